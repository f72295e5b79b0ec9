// SPDX-License-Identifier: Apache-2.0
#include "files/bundled_name.h"

#include <gtest/gtest.h>

#include "command/temporary_directory.h"
#include "core/value_errors.h"
#include "litfog/input_error.h"

namespace litfog::test {
namespace {

using files::file_or_bundled;

TEST(BundledName, FilesComeFirstThenBundledOnesAndOthersAreNamed) {
  const TemporaryDirectory directory;
  const std::filesystem::path folder = directory.path();
  directory.write("street-lamp.json", "{}");
  EXPECT_EQ(file_or_bundled("street-lamp", folder), folder / "street-lamp.json");
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::current_path(folder);
  directory.write("stage-lamp", "{}");
  directory.write("stage-lamp.json", "{}");
  const std::filesystem::path found = file_or_bundled("stage-lamp", folder);
  std::filesystem::current_path(here);
  EXPECT_EQ(found, "stage-lamp");
  EXPECT_EQ(file_or_bundled("./street-lamp", folder), "./street-lamp") << "a path, which its reader reports";
  EXPECT_EQ(file_or_bundled("lamp.ies", folder), "lamp.ies");
  EXPECT_EQ(sentence_of<InputError>([&] { file_or_bundled("street-lmp", folder); }),
            "street-lmp: must be a file or a bundled light; did you mean street-lamp?");
}

}  // namespace
}  // namespace litfog::test
