// SPDX-License-Identifier: Apache-2.0
#include "text/csv.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/value_errors.h"
#include "litfog/input_error.h"

namespace litfog::test {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

File file_of(const std::string& text) {
  File file(std::tmpfile(), std::fclose);
  if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size()) throw std::runtime_error("temporary file");
  std::rewind(file.get());
  return file;
}

std::vector<std::string> fields_of(const CsvRecord& record) {
  std::vector<std::string> fields;
  for (std::size_t i = 0; i < record.size(); ++i) fields.emplace_back(record.field(i));
  return fields;
}

std::vector<std::vector<std::string>> read_all(const std::string& text) {
  const File file = file_of(text);
  CsvReader reader(file.get(), "f");
  std::vector<std::vector<std::string>> records;
  for (CsvRecord record; reader.read(record);) records.push_back(fields_of(record));
  return records;
}

using Records = std::vector<std::vector<std::string>>;

TEST(Csv, RecordsAndFieldsAreSplit) {
  EXPECT_EQ(read_all(""), Records{});
  EXPECT_EQ(read_all("a"), (Records{{"a"}}));
  EXPECT_EQ(read_all("a,b\nc,d\n"), (Records{{"a", "b"}, {"c", "d"}}));
  EXPECT_EQ(read_all("a,b\r\nc,d"), (Records{{"a", "b"}, {"c", "d"}}));
  EXPECT_EQ(read_all(",\n,,"), (Records{{"", ""}, {"", "", ""}}));
  EXPECT_EQ(read_all("a\n\nb"), (Records{{"a"}, {""}, {"b"}}));
  EXPECT_EQ(read_all(" a , b "), (Records{{" a ", " b "}})) << "spaces are part of a field";
}

TEST(Csv, SeparatorIsTheOneGiven) {
  const File file = file_of("a;\"b;c\";1,5\n");
  CsvReader reader(file.get(), "f", ';');
  CsvRecord record;
  ASSERT_TRUE(reader.read(record));
  EXPECT_EQ(fields_of(record), (std::vector<std::string>{"a", "b;c", "1,5"}));
  EXPECT_EQ(record.location(2).column, 9);
  EXPECT_EQ(reader.location().line, 2);
}

TEST(Csv, FieldsAreUnquoted) {
  EXPECT_EQ(read_all("\"a,b\",\"say \"\"hi\"\"\",\"\"\n"), (Records{{"a,b", "say \"hi\"", ""}}));
  EXPECT_EQ(read_all("5\" pipe,b\n"), (Records{{"5\" pipe", "b"}})) << "a quote within an unquoted field is text";
  EXPECT_EQ(read_all("a\rb,c\r\n"), (Records{{"a\rb", "c"}})) << "only CR LF ends a line";
}

TEST(Csv, ByteOrderMarkIsSkippedAtTheStartOnly) {
  EXPECT_EQ(read_all("\xEF\xBB\xBFid\n\xEF\xBB\xBFid\n"), (Records{{"id"}, {"\xEF\xBB\xBFid"}}));
  EXPECT_EQ(read_all("\xEF\xBB\xBF"), Records{});
  EXPECT_EQ(read_all("\xEF\xBB"), (Records{{"\xEF\xBB"}}));
}

TEST(Csv, FieldsKnowTheirLocation) {
  const File file = file_of(
      "\xEF\xBB\xBF"
      "a,\"b,c\",\xC3\xA4\xC3\xA4,d\r\n\n e,f");
  CsvReader reader(file.get(), "f");
  CsvRecord record;
  const auto location = [&record](std::size_t i) {
    return std::to_string(record.location(i).line) + ":" + std::to_string(record.location(i).column);
  };
  ASSERT_TRUE(reader.read(record));
  EXPECT_EQ(location(0), "1:1");
  EXPECT_EQ(location(1), "1:3");
  EXPECT_EQ(location(2), "1:9");
  EXPECT_EQ(location(3), "1:12") << "a column is a code point";
  EXPECT_TRUE(record.ends_in_crlf());
  ASSERT_TRUE(reader.read(record));
  EXPECT_TRUE(record.is_blank());
  ASSERT_TRUE(reader.read(record));
  EXPECT_FALSE(record.ends_in_crlf());
  EXPECT_EQ(location(0), "3:1");
  EXPECT_EQ(location(1), "3:4");
  EXPECT_FALSE(reader.read(record));
}

TEST(Csv, RawTextOfFieldsIsKept) {
  const File file = file_of("\"a\",\"b,\"\"\",c\r\nd\n");
  CsvReader reader(file.get(), "f");
  CsvRecord record;
  ASSERT_TRUE(reader.read(record));
  EXPECT_EQ(record.raw(0), "");
  EXPECT_EQ(record.raw(1), "\"a\"");
  EXPECT_EQ(record.raw(2), "\"a\",\"b,\"\"\"");
  EXPECT_EQ(record.raw(3), "\"a\",\"b,\"\"\",c");
  EXPECT_EQ(record.raw(9), record.raw(3));
  ASSERT_TRUE(reader.read(record));
  EXPECT_EQ(record.raw(1), "d");
}

TEST(Csv, OpenQuoteIsNotedAndClosedAtTheEndOfItsLine) {
  const File file = file_of("a\nb,\"open,\r\nc\n\"");
  CsvReader reader(file.get(), "f");
  CsvRecord record;
  ASSERT_TRUE(reader.read(record));
  EXPECT_EQ(record.error(), nullptr);
  ASSERT_TRUE(reader.read(record));
  EXPECT_STREQ(record.error(), "quote must be closed on its line");
  EXPECT_EQ(record.error_location().line, 2);
  EXPECT_EQ(record.error_location().column, 3);
  EXPECT_EQ(record.raw(2), "b,\"open,\"");
  EXPECT_TRUE(record.ends_in_crlf());
  ASSERT_TRUE(reader.read(record));
  EXPECT_EQ(record.error(), nullptr) << "the next line is another record";
  EXPECT_EQ(fields_of(record), (std::vector<std::string>{"c"}));
  ASSERT_TRUE(reader.read(record));
  EXPECT_STREQ(record.error(), "quote must be closed on its line") << "nor is it closed at the file's end";
  EXPECT_FALSE(reader.read(record));
}

TEST(Csv, TextBehindAClosingQuoteIsNoted) {
  const File file = file_of("\"a\" ,b\nc,d\n");
  CsvReader reader(file.get(), "f");
  CsvRecord record;
  ASSERT_TRUE(reader.read(record));
  EXPECT_STREQ(record.error(), "quoted field must end at its quote");
  EXPECT_EQ(record.error_location().line, 1);
  EXPECT_EQ(record.error_location().column, 4);
  EXPECT_EQ(fields_of(record), (std::vector<std::string>{"a ", "b"}));
  ASSERT_TRUE(reader.read(record));
  EXPECT_EQ(record.error(), nullptr) << "the next record is sound";
  EXPECT_EQ(fields_of(record), (std::vector<std::string>{"c", "d"}));
}

TEST(Csv, RecordOfOneMebibyteIsHeldAndALongerOneDropped) {
  constexpr std::size_t kMost = std::size_t{1} << 20;
  const File file =
      file_of(std::string(kMost, 'x') + "\n" + std::string(5 * kMost, 'x') + "\nb,c\n" + std::string(kMost, ','));
  CsvReader reader(file.get(), "f");
  CsvRecord record;
  ASSERT_TRUE(reader.read(record));
  EXPECT_EQ(record.error(), nullptr);
  EXPECT_EQ(record.field(0).size(), kMost);
  ASSERT_TRUE(reader.read(record));
  EXPECT_STREQ(record.error(), "record must not be longer than 1 MiB");
  EXPECT_EQ(record.error_location().line, 2);
  EXPECT_EQ(record.error_location().column, 1);
  EXPECT_EQ(record.size(), 0u);
  EXPECT_EQ(record.raw(1), "");
  EXPECT_FALSE(record.is_blank());
  ASSERT_TRUE(reader.read(record));
  EXPECT_EQ(fields_of(record), (std::vector<std::string>{"b", "c"}));
  EXPECT_EQ(record.location(0).line, 3);
  ASSERT_TRUE(reader.read(record));
  EXPECT_STREQ(record.error(), "record must not have more than 65,536 fields");
}

TEST(Csv, RecordsMayStraddleTheReadersBuffer) {
  std::string text;
  for (int i = 0; i < 20000; ++i) text += std::to_string(i) + ",\"x\"\",\r" + std::to_string(i) + "\"\r\n";
  const auto records = read_all(text);
  ASSERT_EQ(records.size(), 20000u);
  for (int i = 0; i < 20000; ++i) {
    const auto& record = records[std::size_t(i)];
    ASSERT_EQ(record, (std::vector<std::string>{std::to_string(i), "x\",\r" + std::to_string(i)}));
  }
}

TEST(Csv, UnreadableInputIsAnError) {
  const File file(std::fopen("/tmp", "rb"), std::fclose);
  ASSERT_NE(file, nullptr);
  EXPECT_EQ(sentence_of<InputError>([&] { CsvReader reader(file.get(), "dir"); }),
            "dir: cannot be read: Is a directory");
}

TEST(Csv, FieldIsQuotedOnlyWhereItNeedsIt) {
  EXPECT_EQ(csv_quoted("plain text"), "plain text");
  EXPECT_EQ(csv_quoted(""), "");
  EXPECT_EQ(csv_quoted("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_quoted("\""), "\"\"\"\"");
  EXPECT_EQ(csv_quoted("a\nb"), "\"a\nb\"");
  EXPECT_EQ(csv_quoted("a\r"), "\"a\r\"");
}

}  // namespace

}  // namespace litfog::test
