// SPDX-License-Identifier: Apache-2.0
#include "window/folder_listing.h"

#include <gtest/gtest.h>

#include <fstream>

#include "command/temporary_directory.h"

namespace litfog::test {
using namespace window;

namespace {

namespace fs = std::filesystem;

const std::string kEndings[] = {".json", ".glb"};

std::vector<std::string> names_in(const FolderListing& listing) {
  std::vector<std::string> names;
  for (const auto& [name, is_folder] : listing.entries) names.push_back(name + (is_folder ? "/" : ""));
  return names;
}

TEST(FolderListing, FoldersThenFilesThatOpenAreSorted) {
  const TemporaryDirectory directory;
  for (const char* name : {"b.json", "a.GLB", "a.txt", "json", ".hidden.json"}) std::ofstream(directory.path() / name);
  for (const char* name : {"z", "y.json", ".git"}) fs::create_directory(directory.path() / name);
  fs::create_directory_symlink("z", directory.path() / "link");
  fs::create_symlink("nowhere", directory.path() / "broken.json");
  const FolderListing listing = list_folder(directory.path() / "z" / "..", kEndings);
  EXPECT_EQ(listing.folder, directory.path());
  EXPECT_EQ(names_in(listing), (std::vector<std::string>{"link/", "y.json/", "z/", "a.GLB", "b.json"}));
  EXPECT_EQ(listing.error, "");
}

TEST(FolderListing, NamesInAnyEncodingAreKeptByteByByte) {
  const TemporaryDirectory directory;
  const std::vector<std::string> names{"\n##.json", "\xc3\xa4.json", "\xff\xfe.json"};
  for (const std::string& name : names) std::ofstream(directory.path() / name);
  EXPECT_EQ(names_in(list_folder(directory.path(), kEndings)), names);
}

TEST(FolderListing, FolderThatCannotBeReadSaysWhy) {
  const TemporaryDirectory directory;
  std::ofstream(directory.path() / "file");
  EXPECT_EQ(list_folder(directory.path() / "none", kEndings).error, "cannot be read: No such file or directory");
  EXPECT_EQ(list_folder(directory.path() / "file", kEndings).error, "cannot be read: Not a directory");
}

}  // namespace

}  // namespace litfog::test
