// SPDX-License-Identifier: Apache-2.0
#include "files/json_document.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <functional>
#include <new>
#include <string>

#include "command/comma_locale.h"
#include "core/value_errors.h"
#include "files/json_text.h"
#include "litfog/input_error.h"
#include "photometry/memory_limit.h"

namespace litfog::test {
using namespace files;

namespace {

/// The message with which a reading fails; a text that no message equals if it does not.
std::string error_of(const std::function<void()>& read) { return sentence_of<InputError>(read); }

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
  EXPECT_EQ(root.names(), (std::vector<std::string_view>{"b", "i", "n", "o", "s", "v"}));
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
  EXPECT_EQ(error_of("{\n \"a\": 1,\n}"),
            R"(f:3:1: text = "}": must be a member's name in quotes; leave out the comma before it)");
  EXPECT_EQ(error_of("{\"a\": 1 \"b\": 2}"), R"(f:1:9: text = "\"b\"": must be ',' or '}')");
  EXPECT_EQ(error_of("[1, 2"), "f:1:6: end of file: must be ',' or ']'");
  EXPECT_TRUE(error_of("[1, ]").ends_with("true, false or null; leave out the comma before it")) << error_of("[1, ]");
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
  EXPECT_EQ(error_of(std::string(64, '[') + std::string(64, ']')), "no error");
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

TEST(JsonDocument, NameOfTheSchemaMayStandBesideTheHeader) {
  const JsonValue root = parse_json(R"({"$schema": "a.json", "litfog": "light"})", "f");
  root.allow_only({"litfog"});
  EXPECT_EQ(error_of([&] { root.allow_only({"b"}); }), "f:1:2: \"$schema\": must be one of b");
  EXPECT_EQ(error_of([] { parse_json(R"({"$schema": 1})", "f").allow_only({"litfog"}); }),
            "f:1:13: $schema = 1: must be a string");
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
  EXPECT_EQ(header_error_of(R"({"litfog": "light", "version": 1})", 1), "no error");
  EXPECT_EQ(header_error_of(R"({"litfog": "light", "version": 2})", 2), "no error");
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

JsonValue changed(const std::string& text, std::string_view path, const std::string& value) {
  return with_value(parse_json(text, "f"), path, parse_json(value, "value"), "--set");
}

TEST(JsonDocument, ValueIsReplacedAndTheDocumentItselfStaysAsItIs) {
  const JsonValue before = parse_json(R"({"a": [{"b": 1}, {"b": 2, "c": [3, 4]}], "d": 5})", "f");
  const JsonValue after = with_value(before, "a[1].c[0]", parse_json("[6]", "value"), "--set");
  EXPECT_EQ(before.member("a").items()[1].member("c").items()[0].number(), 3);
  const JsonValue second = after.member("a").items()[1];
  EXPECT_EQ(second.member("c").items()[0].items()[0].number(), 6);
  EXPECT_EQ(second.member("c").items()[1].number(), 4);
  EXPECT_EQ(second.member("b").number(), 2);
  EXPECT_EQ(after.member("a").items()[0].member("b").number(), 1);
  EXPECT_EQ(changed("[1, [2, 3]]", "[1][0]", "7").items()[1].items()[0].number(), 7);
}

TEST(JsonDocument, ReplacedValueIsLocatedByItsOptionAndAllOthersWhereTheyWere) {
  const JsonValue root = changed("{\"a\": 1,\n \"b\": {\"c\": 2}}", "b.c", "[7, {\"x\": 8}]");
  const JsonValue value = root.member("b").member("c");
  EXPECT_EQ(error_of([&] { value.fail("must not"); }), "--set: b.c = an array: must not");
  EXPECT_EQ(error_of([&] { value.items()[0].fail("must not"); }), "--set: b.c[0] = 7: must not");
  EXPECT_EQ(error_of([&] { value.items()[1].allow_only({"y"}); }), "--set: \"x\": must be one of y");
  EXPECT_EQ(error_of([&] { root.member("a").fail("must not"); }), "f:1:7: a = 1: must not");
  EXPECT_EQ(error_of([&] { root.member("b").fail("must not"); }), "f:2:7: b = an object: must not");
  EXPECT_EQ(error_of([&] { root.member("b").allow_only({"d"}); }), "f:2:8: \"c\": must be one of d");
}

TEST(JsonDocument, MembersThatAreNotThereAreMadeAndRefusedByTheirReader) {
  const JsonValue root = changed("{\"a\": 1}", "colour.d", "2");
  EXPECT_EQ(root.member("colour").member("d").number(), 2);
  EXPECT_EQ(error_of([&] {
              root.allow_only({"a", "color"});
            }),
            "--set: \"colour\": must be one of a, color; did you mean color?");
}

TEST(JsonDocument, IndexAfterTheLastAppendsAndNullRemoves) {
  EXPECT_EQ(changed("[1, 2]", "[2]", "3").items()[2].number(), 3);
  EXPECT_EQ(changed("{}", "a[0]", "3").member("a").items()[0].number(), 3);
  const JsonValue fewer = changed(R"({"a": [1, 2, {"b": 3, "c": 4}]})", "a[0]", "null");
  ASSERT_EQ(fewer.member("a").items().size(), 2u);
  EXPECT_EQ(fewer.member("a").items()[0].number(), 2);
  EXPECT_FALSE(with_value(fewer, "a[1].b", parse_json("null", "value"), "--set").member("a").items()[1].optional("b"));
  EXPECT_EQ(fewer.member("a").items()[1].member("b").number(), 3);
  EXPECT_FALSE(changed("{}", "a", "null").optional("a"));
}

TEST(JsonDocument, PathsThatLeadNowhereAreErrors) {
  const auto error = [](std::string_view path) {
    return error_of([&] { changed(R"({"a": [1, 2], "s": "t", "e": []})", path, "3"); });
  };
  EXPECT_EQ(error("a[3]"), "--set: a[3]: is not there: the last one is a[1]");
  EXPECT_EQ(error("a[2].x"), "--set: a[2]: is not there: the last one is a[1]");
  EXPECT_EQ(error("a[99999999999999999999]"), "--set: a[99999999999999999999]: is not there: the last one is a[1]");
  EXPECT_EQ(error("e[1]"), "--set: e[1]: is not there: e is empty");
  EXPECT_EQ(error_of([] { changed("[1]", "[1]", "null"); }), "--set: [1]: is not there: the last one is [0]");
  EXPECT_EQ(error("a.x"), "--set: a = an array: must be an object, to have a.x");
  EXPECT_EQ(error("a[0].x"), "--set: a[0] = 1: must be an object, to have a[0].x");
  EXPECT_EQ(error("s[0]"), "--set: s = \"t\": must be an array, to have s[0]");
  EXPECT_EQ(error("[0]"), "--set: document = an object: must be an array, to have [0]");
  for (const std::string path : {"a[", "a[]", "a[-1]", "a[+1]", "a[1", "a[0]x", ".a", "s..b", "a[ 1]"}) {
    EXPECT_NE(error(path).find(": must be a member such as lights[0].position"), std::string::npos) << error(path);
  }
}

TEST(JsonDocument, StringIsFollowedToTheDocumentThatItNames) {
  const JsonValue root = parse_json(R"({"a": "other", "b": "other"})", "f");
  const FollowLink follow = [](const JsonValue& link) -> std::optional<JsonValue> {
    if (link.string() != "other") return std::nullopt;
    return parse_json("{\n \"x\": 1, \"y\": 2}", "g");
  };
  const JsonValue after = with_value(root, "a.y", parse_json("3", "value"), "--set", follow);
  EXPECT_EQ(error_of([&] { after.member("a").member("x").fail("must not"); }), "g:2:7: a.x = 1: must not");
  EXPECT_EQ(error_of([&] { after.member("a").member("y").fail("must not"); }), "--set: a.y = 3: must not");
  EXPECT_EQ(after.member("b").string(), "other");
  EXPECT_EQ(with_value(root, "a", parse_json("3", "value"), "--set", follow).member("a").number(), 3);
  EXPECT_EQ(error_of([&] { with_value(parse_json(R"({"a": "t"})", "f"), "a.y", root, "--set", follow); }),
            "--set: a = \"t\": must be an object, to have a.y");
}

#ifndef LITFOG_SANITIZED  // sanitizers' own memory would count
TEST(JsonDocument, ShortMemoryIsNeverAFaultOfTheText) {
  const std::string text = R"({"name": ")" + std::string(16 << 20, 'x') + "\"}";
  bool is_read = false;
  for (std::size_t mebibytes = 0; !is_read && mebibytes < 200; mebibytes += 4) {
    const MemoryLimit limit(mebibytes << 20);
    try {
      parse_json(text, "f");
      is_read = true;
    } catch (const std::bad_alloc&) {
    }
  }
  EXPECT_TRUE(is_read);
}
#endif

}  // namespace
}  // namespace litfog::test
