// SPDX-License-Identifier: Apache-2.0
#include "text/csv.h"

#include <algorithm>
#include <cerrno>
#include <utility>

#include "litfog/input_error.h"
#include "text/code_points.h"
#include "text/system_reason.h"

namespace litfog {

namespace {

constexpr std::size_t kMaxRecord = std::size_t{1} << 20;
constexpr std::size_t kMaxFields = 65536;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace

std::string_view CsvRecord::raw(std::size_t count) const {
  count = std::min(count, fields_.size());
  return std::string_view(raw_).substr(0, count == 0 ? 0 : fields_[count - 1].raw_end);
}

CsvReader::CsvReader(std::FILE* file, std::string name, char separator)
    : file_(file), name_(std::move(name)), separator_(separator) {
  peek();
  if (std::string_view(buffer_.data(), filled_).starts_with(kByteOrderMark)) next_ = kByteOrderMark.size();
}

int CsvReader::peek() {
  if (next_ == filled_) {
    next_ = 0;
    filled_ = std::fread(buffer_.data(), 1, buffer_.size(), file_);
    if (filled_ == 0) {
      if (std::ferror(file_)) throw InputError({.file = name_}, "cannot be read: " + system_reason(errno));
      return kEnd;
    }
  }
  return static_cast<unsigned char>(buffer_[next_]);
}

int CsvReader::take() {
  const int byte = peek();
  if (byte == kEnd) return kEnd;
  ++next_;
  if (byte == '\n') {
    ++location_.line;
    location_.column = 1;
  } else if (starts_code_point(char(byte))) {
    ++location_.column;
  }
  return byte;
}

bool CsvReader::read(CsvRecord& record) {
  if (peek() == kEnd) return false;
  const auto drop_content = [&record] {
    record.text_.clear();
    record.raw_.clear();
    record.fields_.clear();
  };
  drop_content();
  record.ends_in_crlf_ = false;
  record.error_ = nullptr;

  const CsvLocation start = location_;
  enum class State { field_start, plain, quoted, quote_seen } state = State::field_start;
  const auto note_error = [&record](const char* rule, CsvLocation location) {
    if (record.error_ == nullptr) {
      record.error_ = rule;
      record.error_location_ = location;
    }
  };
  const auto begin_field = [&] { record.fields_.push_back({record.text_.size(), 0, 0, location_}); };
  const auto end_field = [&] {
    record.fields_.back().size = record.text_.size() - record.fields_.back().begin;
    record.fields_.back().raw_end = record.raw_.size();
    state = State::field_start;
  };

  const char* too_long = nullptr;
  begin_field();
  for (;;) {
    const CsvLocation location = location_;
    const int taken = take();
    const char byte = char(taken);
    if (taken == kEnd || byte == '\n' || (byte == '\r' && peek() == '\n')) {
      if (state == State::quoted) {
        note_error("quote must be closed on its line", record.fields_.back().location);
        record.raw_ += '"';  // so that text written after it stays outside
      }
      if (byte == '\r') {
        record.ends_in_crlf_ = true;
        take();
      }
      break;
    }
    if (record.raw_.size() == kMaxRecord || record.fields_.size() > kMaxFields) {  // reads on without storing
      if (too_long == nullptr) {
        too_long = record.raw_.size() == kMaxRecord ? "record must not be longer than 1 MiB"
                                                    : "record must not have more than 65,536 fields";
      }
      drop_content();
      begin_field();
    }
    if (state != State::quoted && byte == separator_) {
      end_field();
      record.raw_ += byte;
      begin_field();
      continue;
    }
    record.raw_ += byte;
    switch (state) {
      case State::field_start:
        state = byte == '"' ? State::quoted : State::plain;
        if (state == State::plain) record.text_ += byte;
        break;
      case State::quoted:
        if (byte == '"') {
          state = State::quote_seen;
        } else {
          record.text_ += byte;
        }
        break;
      case State::quote_seen:
        record.text_ += byte;
        if (byte == '"') {
          state = State::quoted;
        } else {
          note_error("quoted field must end at its quote", location);
          state = State::plain;
        }
        break;
      case State::plain:
        record.text_ += byte;
        break;
    }
  }
  end_field();
  if (too_long != nullptr) {
    drop_content();
    record.error_ = too_long;
    record.error_location_ = start;
  }
  return true;
}

std::string csv_quoted(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == text.npos) return std::string(text);
  std::string quoted = "\"";
  for (const char byte : text) {
    if (byte == '"') quoted += '"';
    quoted += byte;
  }
  return quoted + "\"";
}

}  // namespace litfog
