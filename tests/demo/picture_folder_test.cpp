// SPDX-License-Identifier: Apache-2.0
#include "drawing/picture_folder.h"

#include <gtest/gtest.h>

#include <CLI/Error.hpp>
#include <fstream>

#include "command/exit_status.h"
#include "command/no_more_threads.h"
#include "command/temporary_directory.h"
#include "litfog/files/output_error.h"
#include "litfog/input_error.h"

namespace litfog::test {
using namespace drawing;
using namespace render;
using namespace command;

namespace {

const Picture kPixel{1, 1, {0.1f, 0.2f, 0.3f}};

class PictureFolderTest : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (directory_.path() / name).string(); }

 private:
  litfog::test::TemporaryDirectory directory_;
};

TEST_F(PictureFolderTest, FolderIsMadeWithItsParentsAndHoldsWhatWasWritten) {
  PictureFolder pictures(path("a/b"), {"first.png", "second.png"}, {});
  pictures.write("first.png", kPixel);
  pictures.write("second.png", kPixel);
  pictures.finish();
  for (const char* name : {"first.png", "second.png"}) EXPECT_TRUE(std::filesystem::exists(path("a/b") + "/" + name));
}

TEST_F(PictureFolderTest, ReplacingAnotherScenesPictureIsAnError) {
  EXPECT_THROW(PictureFolder(path("a"), {"room-vertex-reference.png", "room-vertex-reference.png"}, {}), InputError);
  EXPECT_FALSE(std::filesystem::exists(path("a")));
}

TEST_F(PictureFolderTest, ReplacingAnInputIsAnError) {
  std::filesystem::create_directory(path("a"));
  std::ofstream(path("a/room-clear.png")) << "a texture";
  EXPECT_THROW(PictureFolder(path("a"), {"room-clear.png"}, {path("a/room-clear.png")}), CLI::ValidationError);
  PictureFolder(path("a"), {"room-60m.png"}, {path("a/room-clear.png")});
}

TEST_F(PictureFolderTest, FolderIsFilledWhereNoThreadCanStart) {
  const NoMoreThreads limit;
  PictureFolder pictures(path("a"), {"first.png", "second.png"}, {});
  pictures.write("first.png", kPixel);
  pictures.write("second.png", kPixel);
  pictures.finish();
  for (const char* name : {"first.png", "second.png"}) EXPECT_TRUE(std::filesystem::exists(path("a") + "/" + name));
}

TEST_F(PictureFolderTest, FileThatCannotBeWrittenIsNamed) {
  PictureFolder pictures(path("a"), {"taken.png"}, {});
  std::filesystem::create_directory(path("a") + "/taken.png");
  pictures.write("taken.png", kPixel);
  EXPECT_THROW(pictures.finish(), OutputError);
  EXPECT_THROW(PictureFolder(pictures.path_of("none.png") + std::string(300, 'a'), {}, {}), OutputError);
}

}  // namespace

}  // namespace litfog::test
