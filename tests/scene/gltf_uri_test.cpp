// SPDX-License-Identifier: Apache-2.0
#include "scene/file/gltf_uri.h"

#include <gtest/gtest.h>

namespace litfog::test {

using scene::decode_base64;

namespace {

// RFC 4648, section 10; and bytes beyond 127.
TEST(GltfUri, Base64IsDecoded) {
  EXPECT_EQ(decode_base64(""), "");
  EXPECT_EQ(decode_base64("Zg=="), "f");
  EXPECT_EQ(decode_base64("Zm8="), "fo");
  EXPECT_EQ(decode_base64("Zm9v"), "foo");
  EXPECT_EQ(decode_base64("Zm9vYg=="), "foob");
  EXPECT_EQ(decode_base64("Zm9vYmE="), "fooba");
  EXPECT_EQ(decode_base64("Zm9vYmFy"), "foobar");
  EXPECT_EQ(decode_base64("+/8A"), std::string("\xFB\xFF\0", 3));
}

TEST(GltfUri, Base64NeedsNoPadding) {
  EXPECT_EQ(decode_base64("Zg"), "f");
  EXPECT_EQ(decode_base64("Zm8"), "fo");
}

TEST(GltfUri, OtherTextIsNoBase64) {
  for (const char* text : {"Z", "Zm9vY", "Zm9v!", "Zm 9", "Z===", "====", "Zg==Zg==", "Zm9-", "Zm9\xE9"}) {
    EXPECT_EQ(decode_base64(text), std::nullopt) << text;
  }
}

}  // namespace

}  // namespace litfog::test
