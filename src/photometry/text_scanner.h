// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "litfog/input_error.h"

namespace litfog {

inline constexpr std::size_t kMaxPhotometricBytes = std::size_t{64} << 20;

/// The bytes of a file of at most kMaxPhotometricBytes; throws InputError.
std::string read_photometric_file(const std::string& path);

/// A value for a message: cut if long, control characters replaced.
std::string excerpt(std::string_view text);

/// "what = value: rule"; "what: must be given" for an empty value, and that the file ends there for a missing one.
[[noreturn]] void fail_at(InputLocation location, std::string_view what, std::string_view value, bool is_missing,
                          std::string_view rule);

/// A photometric file's text, read piece by piece. Each error names the location of a piece.
class TextScanner {
 public:
  enum class Unit {
    token,  ///< up to white space or a comma
    line,   ///< up to a line end (CR LF, LF or CR), without white space around it
  };

  struct Piece {
    std::string_view text;
    std::size_t offset;       ///< first byte
    bool is_missing = false;  ///< the file ended before it
  };

  /// bytes  as for utf8_from_bytes()
  TextScanner(std::string bytes, std::string name);
  TextScanner(const TextScanner&) = delete;
  TextScanner& operator=(const TextScanner&) = delete;

  Piece next(Unit unit);
  bool is_at_end() const { return cursor_ == text_.size(); }
  const std::string& text() const { return text_; }
  const std::string& name() const { return name_; }

  /// A piece as a number: decimal, whole and finite; its exponent may be Fortran's, 1.5D+03. `what` names it in errors.
  double number(const Piece& piece, std::string_view what) const;
  /// number() of a field on which no intensity depends: nothing if the piece is not a number.
  static std::optional<double> number_if_any(const Piece& piece);
  int integer(const Piece& piece, std::string_view what, int low, int high) const;
  double positive(const Piece& piece, std::string_view what) const;
  /// Fails if a number follows in the file; other text is allowed.
  void expect_no_more_numbers();

  InputLocation location(const Piece& piece) const;
  /// fail_at() a piece.
  [[noreturn]] void fail(const Piece& piece, std::string_view what, std::string_view rule) const;

 private:
  Piece next_token();
  Piece next_line();

  std::string text_;
  std::string name_;
  std::size_t cursor_ = 0;
};

}  // namespace litfog
