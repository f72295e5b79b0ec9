// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace litfog::command {

enum class TableFormat {
  text,  ///< aligned columns, six digits, but whole numbers below 1e9 in full
  csv,   ///< RFC 4180, numbers read back exactly, infinity is inf
  json,  ///< an array of objects, one a row; numbers read back exactly, infinity is the string "inf", empty is null
};

/// A result table: named columns, rows of texts, numbers and empty cells.
struct Table {
  using Cell = std::variant<std::string, double, std::monostate>;

  std::vector<std::string> columns = {};
  std::vector<std::vector<Cell>> rows = {};  ///< each as long as columns
};

/// The whole table as text, with a newline at its end.
std::string format_table(const Table& table, TableFormat format);

}  // namespace litfog::command
