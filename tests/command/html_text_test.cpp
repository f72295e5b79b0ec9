// SPDX-License-Identifier: Apache-2.0
#include "command/html_text.h"

#include <gtest/gtest.h>

namespace litfog::test {
using namespace command;

namespace {

TEST(HtmlText, TextCannotEndAnElementOrAnAttribute) {
  EXPECT_EQ(html_text("<b class=\"a\" id='b'>R&amp;D</b>"),
            "&lt;b class=&quot;a&quot; id=&#39;b&#39;&gt;R&amp;amp;D&lt;/b&gt;");
  EXPECT_EQ(html_text("Nebel über 50 m"), "Nebel über 50 m");
  EXPECT_EQ(html_text(""), "");
}

TEST(HtmlLink, LinkNamesAFileBesideThePageWhateverItsName) {
  EXPECT_EQ(html_link("room-lookup_3d.v1~.png"), "room-lookup_3d.v1~.png");
  EXPECT_EQ(html_link("a b#c?d%e&f\"g'h.png"), "a%20b%23c%3Fd%25e%26f%22g%27h.png");
  EXPECT_EQ(html_link("file:x.png"), "file%3Ax.png");  // no scheme
  EXPECT_EQ(html_link("\u00fc.png"), "%C3%BC.png");
}

TEST(DataUri, BytesAreInBase64) {
  // Test vectors of RFC 4648, section 10.
  const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors) EXPECT_EQ(data_uri("a/b", bytes), std::string("data:a/b;base64,") + text);
  EXPECT_EQ(data_uri("a/b", std::string("\xFF\xFE\x00\xFB\xEF\xBE", 6)), "data:a/b;base64,//4A++++");
}

}  // namespace

}  // namespace litfog::test
