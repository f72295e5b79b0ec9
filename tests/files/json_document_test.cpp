// SPDX-License-Identifier: Apache-2.0
#include "files/json_document.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <functional>
#include <string>

#include "command/comma_locale.h"
#include "files/json_text.h"
#include "litfog/input_error.h"

namespace litfog::test {
using namespace files;

namespace {

/// The message with which a reading fails; a text that no message equals if it does not.
std::string error_of(const std::function<void()>& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "(accepted)";
}

std::string error_of(const std::string& text) {
  return error_of([&] { parse_json(text, "f"); });
}

TEST(JsonDocument, EveryTypeIsRead) {
  const JsonValue root =
      parse_json(R"({"n": -1.5e2, "i": 3, "b": true, "s": "a\n\u00e4\"]", "v": [1, 2, 3], "o": {"z": null}})", "f");
  EXPECT_EQ(root.member("n").number(), -150);
  EXPECT_EQ(root.member("i").number(), 3);
  EXPECT_TRUE(root.member("b").boolean());
  EXPECT_EQ(root.member("s").string(), "a\n\xC3\xA4\"]");
  EXPECT_EQ(root.member("v").vec3(), glm::dvec3(1, 2, 3));
  EXPECT_EQ(root.member("v").items().size(), 3u);
  EXPECT_TRUE(root.member("o").is_object());
  EXPECT_FALSE(root.optional("absent"));
  EXPECT_EQ(root.number_or("absent", 7), 7);
  EXPECT_EQ(root.number_or("i", 7), 3);
  EXPECT_EQ(root.file(), "f");
  EXPECT_EQ(root.member("o").member("z").path(), "o.z");
}

TEST(JsonDocument, ValuesOutliveTheirRoot) {
  const auto item = [] {
    return parse_json("[[\"kept alive, and too long to be stored in place\"]]", "f").items()[0].items()[0];
  }();
  EXPECT_EQ(item.string(), "kept alive, and too long to be stored in place");
  EXPECT_EQ(item.path(), "[0][0]");
}

TEST(JsonDocument, EveryValueKnowsItsLocation) {
  const JsonValue root = parse_json(
      "{\n  \"a\" : [10 ,\r\n\t{\"b\\\"}\" :\"x\"}, -2.5e1,true\n, null, [ ] ], \"\xC3\xA4\": 1 , \"c\":0\n}", "f");
  const auto location = [](const JsonValue& value) {
    const std::string message = error_of([&] { value.fail("w", "", "r"); });
    return message.substr(0, message.find(": w: r"));
  };
  EXPECT_EQ(location(root), "f:1:1");
  const auto items = root.member("a").items();
  EXPECT_EQ(location(root.member("a")), "f:2:9");
  EXPECT_EQ(location(items[0]), "f:2:10");
  EXPECT_EQ(location(items[1]), "f:3:2");
  EXPECT_EQ(location(items[1].member("b\"}")), "f:3:11");
  EXPECT_EQ(location(items[2]), "f:3:17");
  EXPECT_EQ(location(items[3]), "f:3:24");
  EXPECT_EQ(location(items[4]), "f:4:3");
  EXPECT_EQ(location(items[5]), "f:4:9");
  EXPECT_EQ(location(root.member("\xC3\xA4")), "f:4:21") << "a column is a code point";
  EXPECT_EQ(location(root.member("c")), "f:4:29");
}

TEST(JsonDocument, ByteOrderMarkIsNoColumn) {
  const JsonValue root = parse_json("\xEF\xBB\xBF{\"a\":1}", "f");
  EXPECT_EQ(error_of([&] { root.member("a").fail("must be 2"); }), "f:1:6: a = 1: must be 2");
  EXPECT_EQ(error_of([&] { root.fail("must be 2"); }), "f:1:1: document = an object: must be 2");
  EXPECT_EQ(error_of("\xEF\xBB\xBF{]"), R"(f:1:2: text = "]": must be a member's name in quotes)");
}

TEST(JsonDocument, BrokenTextIsAnErrorAtItsLocation) {
  EXPECT_EQ(error_of(""), "f:1:1: end of file: must be an object, an array, a string, a number, true, false or null");
  EXPECT_EQ(error_of("{\n \"a\": 1,\n}"), R"(f:3:1: text = "}": must be a member's name in quotes)");
  EXPECT_EQ(error_of("{\"a\": 1 \"b\": 2}"), R"(f:1:9: text = "\"b\"": must be ',' or '}')");
  EXPECT_EQ(error_of("[1, 2"), "f:1:6: end of file: must be ',' or ']'");
  EXPECT_EQ(error_of("[tru]"),
            R"(f:1:5: text = "tru": must be an object, an array, a string, a number, true, false or null)");
  EXPECT_EQ(error_of("[01]"), R"(f:1:3: text = "1": must be ',' or ']')");
  EXPECT_EQ(error_of("[1.]"), "f:1:4: number = 1.: must have a digit after the point");
  EXPECT_EQ(error_of("[NaN]"),
            R"(f:1:2: text = "NaN": must be an object, an array, a string, a number, true, false or null)");
  EXPECT_EQ(error_of("[+1]"),
            R"(f:1:2: text = "+1": must be an object, an array, a string, a number, true, false or null)");
  EXPECT_EQ(error_of("// no\n1"),
            R"(f:1:1: text = "//": must be an object, an array, a string, a number, true, false or null)");
  EXPECT_EQ(error_of("{} {}"), R"(f:1:4: text = "{": must not follow the end of the document)");
  EXPECT_EQ(error_of("[\"\xFF\"]"), "f:1:3: string: must be UTF-8");
  EXPECT_EQ(error_of(std::string("\0\0\0\0", 4)), "f:1:1: file: must be text, without zero bytes");
  EXPECT_EQ(error_of(std::string("[]\0[]", 5)), "f:1:3: file: must be text, without zero bytes");
  EXPECT_EQ(error_of("[1 true]"), R"(f:1:4: text = "true": must be ',' or ']')");
  EXPECT_EQ(error_of("[1 false]"), R"(f:1:4: text = "false": must be ',' or ']')");
  EXPECT_EQ(error_of("[1,,2]"),
            R"(f:1:4: text = ",": must be an object, an array, a string, a number, true, false or null)");
  EXPECT_EQ(error_of("\x7F\x45LF\x02\x01"),
            "f:1:1: text = \"\x7F\x45LF\\u0002\\u0001\": must be an object, an array, a string, a number, true, false "
            "or null");
}

TEST(JsonDocument, NumberBeyondDoubleIsAnError) {
  EXPECT_EQ(error_of("[1,\n 1e999]"), "f:2:2: number = 1e999: must be within the range of a double");
  EXPECT_EQ(error_of("[-1e999]"), "f:1:2: number = -1e999: must be within the range of a double");
  EXPECT_EQ(error_of("[1e-999]"), "f:1:2: number = 1e-999: must be within the range of a double");
  EXPECT_EQ(parse_json("123456789012345678901234567890", "f").number(), 123456789012345678901234567890.0);
}

TEST(JsonDocument, MemberGivenTwiceIsAnError) {
  EXPECT_EQ(error_of("{\"a\": 1,\n \"b\": {\"a\": 2},\n  \"a\": 3}"), "f:3:3: \"a\": must not be given twice");
  EXPECT_EQ(error_of(R"({"a": 1, "\u0061": 2})"), "f:1:10: \"a\": must not be given twice");
}

TEST(JsonDocument, DeepNestingIsAnError) {
  EXPECT_EQ(error_of(std::string(64, '[') + std::string(64, ']')), "(accepted)");
  EXPECT_EQ(error_of(std::string(65, '[') + std::string(65, ']')), "f:1:65: nesting: must not be deeper than 64");
  EXPECT_EQ(error_of(std::string(10'000'000, '[')), "f:1:65: nesting: must not be deeper than 64");
}

TEST(JsonDocument, TooManyValuesAreAnError) {
  std::string text = "[0";
  for (int i = 0; i < 1'000'000; ++i) text += ",0";
  EXPECT_EQ(error_of(text + "]"), "f:1:2000000: file: must not hold more than 1000000 values");
  text.resize(text.size() - 4);
  EXPECT_EQ(parse_json(text + "]", "f").items().size(), 999'999u) << "and the array itself";
}

TEST(JsonDocument, ErrorOfAnotherTypeNamesPathAndValue) {
  const JsonValue root = parse_json(R"({"a": [{"t": "x"}, 2, {}], "b": true, "v": [1, 2], "w": [1, "y", 3]})", "f");
  const auto a = root.member("a").items();
  EXPECT_EQ(error_of([&] { a[0].member("t").number(); }), "f:1:14: a[0].t = \"x\": must be a number");
  EXPECT_EQ(error_of([&] { a[1].string(); }), "f:1:20: a[1] = 2: must be a string");
  EXPECT_EQ(error_of([&] { a[1].boolean(); }), "f:1:20: a[1] = 2: must be true or false");
  EXPECT_EQ(error_of([&] { a[2].items(); }), "f:1:23: a[2] = an object: must be an array");
  EXPECT_EQ(error_of([&] { root.member("b").member("c"); }), "f:1:33: b = true: must be an object");
  EXPECT_EQ(error_of([&] { a[0].member("u"); }), "f:1:8: a[0].u: must be given");
  EXPECT_EQ(error_of([&] { root.member("v").vec3(); }), "f:1:44: v = an array: must be an array of three numbers");
  EXPECT_EQ(error_of([&] { root.member("w").vec3(); }), "f:1:61: w[1] = \"y\": must be a number");
}

TEST(JsonDocument, UnknownMemberIsAnErrorAtItsName) {
  const JsonValue root = parse_json("{\"a\": 1,\n  \"aa\": {}}", "f");
  root.allow_only({"aa", "a", "b"});
  EXPECT_EQ(error_of([&] { root.allow_only({"a", "b"}); }), "f:2:3: \"aa\": must be one of a, b");
}

TEST(JsonDocument, LongAndBrokenValuesAreShortInErrors) {
  EXPECT_EQ(quoted_excerpt("a\"\n"), R"("a\"\n")");
  EXPECT_EQ(quoted_excerpt(std::string(1000, 'x')), '"' + std::string(40, 'x') + "\"...");
  EXPECT_EQ(quoted_excerpt(std::string(39, 'x') + "\xC3\xA4"), '"' + std::string(39, 'x') + "\"...")
      << "not half a letter";
  EXPECT_EQ(quoted_excerpt("\xFF\x1B"), "\"\xEF\xBF\xBD\\u001b\"");
}

TEST(JsonDocument, HeaderMustNameFormatAndKnownVersion) {
  const auto header_error_of = [](const std::string& text, int newest_version) {
    return error_of([&] { expect_header(parse_json(text, "f"), "light", newest_version); });
  };
  EXPECT_EQ(header_error_of(R"({"litfog": "light", "version": 1})", 1), "(accepted)");
  EXPECT_EQ(header_error_of(R"({"litfog": "light", "version": 2})", 2), "(accepted)");
  EXPECT_EQ(header_error_of("[]", 1), "f:1:1: document = an array: must be an object");
  EXPECT_EQ(header_error_of("{}", 1), "f:1:1: litfog: must be given");
  EXPECT_EQ(header_error_of(R"({"litfog": "light"})", 1), "f:1:1: version: must be given");
  EXPECT_EQ(header_error_of(R"({"litfog": "scene", "version": 1})", 1),
            "f:1:12: litfog = \"scene\": must be \"light\"");
  EXPECT_EQ(header_error_of(R"({"litfog": "light", "version": 2})", 1),
            "f:1:32: version = 2: must be 1, the one that this program reads");
  EXPECT_EQ(header_error_of(R"({"litfog": "light", "version": 1.5})", 2),
            "f:1:32: version = 1.5: must be from 1 to 2, the ones that this program reads");
}

TEST(JsonDocument, SyntaxErrorsNameTheRuleThatIsBroken) {
  EXPECT_EQ(error_of("[0x10]"), "f:1:2: number = 0x10: must be decimal, such as 16 or -1.5e3");
  EXPECT_EQ(error_of("[1.5.2]"), "f:1:2: number = 1.5.2: must be decimal, such as 16 or -1.5e3");
  EXPECT_EQ(error_of("[2e]"), "f:1:4: number = 2e: must have a digit in its exponent");
  EXPECT_EQ(error_of("{\"a\" 1}"), "f:1:6: text = \"1\": must be ':'");
  EXPECT_EQ(error_of("[\"a"), "f:1:4: end of file: must end in a quotation mark");
  EXPECT_EQ(error_of("[\"a\nb\"]"), "f:1:4: string: must not hold a control character that is not escaped");
  EXPECT_EQ(error_of(R"(["a\x"])"), R"(f:1:4: string: must have one of " \ / b f n r t u after a backslash)");
  EXPECT_EQ(error_of(R"(["\u00g0"])"), R"(f:1:3: string: must have four hexadecimal digits after \u)");
  EXPECT_EQ(error_of(R"(["\ud83dx"])"), R"(f:1:3: string: must have one of \udc00 to \udfff after \ud800 to \udbff)");
  EXPECT_EQ(error_of(R"(["a", "\ude00"])"),
            R"(f:1:7: string: must have one of \ud800 to \udbff before \udc00 to \udfff)");
  EXPECT_EQ(error_of(R"({"\ude00": 1})"),
            R"(f:1:2: string: must have one of \ud800 to \udbff before \udc00 to \udfff)");
}

TEST(JsonDocument, BlanksAreReadWithoutMemoryOfTheirOwn) {
  constexpr std::size_t kSize = std::size_t{64} << 20;
  std::string text(kSize, '\n');
  rusage before{};
  getrusage(RUSAGE_SELF, &before);
  EXPECT_EQ(error_of([&] { parse_json(std::move(text), "f"); }),
            "f:67108865:1: end of file: must be an object, an array, a string, a number, true, false or null");
  rusage after{};
  getrusage(RUSAGE_SELF, &after);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 16 << 10) << "KiB more than the text itself";
}

TEST(JsonDocument, FilesThatCannotBeReadAreNamed) {
  EXPECT_EQ(error_of([] { read_json("/nonexistent/x.json"); }),
            "/nonexistent/x.json: cannot be read: No such file or directory");
  EXPECT_EQ(error_of([] { read_json("/tmp"); }), "/tmp: cannot be read: Is a directory");
  EXPECT_EQ(error_of([] { read_json("/dev/zero"); }), "/dev/zero: cannot be read: Is a device");
}

TEST(JsonDocument, NumbersDoNotDependOnTheLocale) {
  const CommaLocale comma;
  const double number = parse_json("[1.5, 2.25e1]", "f").items()[1].number();
  const std::string error = error_of("[1e999]");
  EXPECT_EQ(number, 22.5);
  EXPECT_EQ(error, "f:1:2: number = 1e999: must be within the range of a double");
}

}  // namespace
}  // namespace litfog::test
