// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace litfog {

/// CSV as in RFC 4180, but each line is a record: quoted fields may hold separators and quotes (doubled), and no
/// newlines, so that a quote left open spoils one record. Lines end in LF or CRLF; the last line may lack its end. A
/// byte order mark at the start is skipped. Quotes within an unquoted field are plain text.
///
/// Our own reader, because the packaged ones do not suffice. libcsv keeps no locations, drops a field's quotes, which
/// pass-through columns keep, and grows its buffer without limit. libfccp needs its columns at compile time.

/// Location in a text, from 1; a column is a code point.
struct CsvLocation {
  long line = 1;
  long column = 1;
};

/// One record and where its fields start.
class CsvRecord {
 public:
  std::size_t size() const { return fields_.size(); }
  std::string_view field(std::size_t i) const {
    return std::string_view(text_).substr(fields_[i].begin, fields_[i].size);
  }
  CsvLocation location(std::size_t i) const { return fields_[i].location; }  ///< a quoted field's is its quote

  /// The first fields as they stood in the file, quotes and commas included, without the line's end.
  std::string_view raw(std::size_t count) const;
  bool is_blank() const { return raw_.empty() && error_ == nullptr; }
  bool ends_in_crlf() const { return ends_in_crlf_; }

  /// The record's error, or null. A record that is too long has lost its fields.
  const char* error() const { return error_; }
  CsvLocation error_location() const { return error_location_; }

 private:
  friend class CsvReader;
  struct Field {
    std::size_t begin;  // in text_
    std::size_t size;
    std::size_t raw_end;
    CsvLocation location;
  };

  std::string text_;  // all fields' texts, end to end
  std::string raw_;
  std::vector<Field> fields_;
  bool ends_in_crlf_ = false;
  const char* error_ = nullptr;
  CsvLocation error_location_;
};

/// Reads records one by one; holds one, of at most 1 MiB and 65,536 fields.
class CsvReader {
 public:
  /// file       stays the caller's
  /// name       for messages
  /// separator  between fields: a comma, or a semicolon from spreadsheets in other languages
  CsvReader(std::FILE* file, std::string name, char separator = ',');

  /// Reads the next record; false at the end. Throws InputError if the file cannot be read.
  bool read(CsvRecord& record);

  const std::string& name() const { return name_; }
  CsvLocation location() const { return location_; }  ///< where the next record begins

 private:
  static constexpr int kEnd = -1;

  int peek();  // the next byte or kEnd
  int take();

  std::FILE* file_;
  std::string name_;
  char separator_;
  std::array<char, 65536> buffer_;
  std::size_t next_ = 0;
  std::size_t filled_ = 0;
  CsvLocation location_;
};

/// A text as a CSV field, quoted if needed.
std::string csv_quoted(std::string_view text);

}  // namespace litfog
