// SPDX-License-Identifier: Apache-2.0
#include "command/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iterator>

#include "command/printable.h"
#include "files/json_text.h"
#include "text/code_points.h"
#include "text/csv.h"

namespace litfog::command {

namespace {

using Cell = Table::Cell;

bool is_number(const Cell& cell) { return std::holds_alternative<double>(cell); }
bool is_empty(const Cell& cell) { return std::holds_alternative<std::monostate>(cell); }

std::string text_cell(const Cell& cell) {
  if (is_empty(cell)) return "-";
  if (is_number(cell)) {
    constexpr double kMaxWhole = 1e9;
    const double number = std::get<double>(cell);
    const bool is_whole = std::abs(number) < kMaxWhole && number == std::round(number);
    return is_whole ? fmt::format("{:.0f}", number + 0.0) : fmt::format("{:.6g}", number);
  }
  const auto& text = std::get<std::string>(cell);
  return text.empty() ? "-" : printable(text);
}

std::string csv_cell(const Cell& cell) {
  if (is_empty(cell)) return "";
  return is_number(cell) ? fmt::format("{}", std::get<double>(cell)) : csv_quoted(std::get<std::string>(cell));
}

std::string json_cell(const Cell& cell) {
  if (is_empty(cell)) return "null";
  if (!is_number(cell)) return files::json_quoted(std::get<std::string>(cell));
  const double number = std::get<double>(cell);
  return std::isfinite(number) ? fmt::format("{}", number) : fmt::format("\"{}\"", number);
}

std::string format_text(const Table& table) {
  std::vector<std::vector<std::string>> lines{table.columns};
  for (const auto& row : table.rows) {
    std::transform(row.begin(), row.end(), std::back_inserter(lines.emplace_back()), text_cell);
  }
  std::string out;
  std::vector<std::size_t> widths(table.columns.size());
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], count_code_points(line[i]));
  }
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const std::string padding(widths[i] - count_code_points(line[i]), ' ');
      const bool align_right = !table.rows.empty() && is_number(table.rows.front()[i]);
      const bool is_last = i + 1 == line.size();
      out += align_right ? padding + line[i] : is_last ? line[i] : line[i] + padding;
      out += is_last ? "\n" : "  ";
    }
  }
  return out;
}

std::string format_csv(const Table& table) {
  std::string out;
  for (std::size_t i = 0; i < table.columns.size(); ++i) out += (i == 0 ? "" : ",") + csv_quoted(table.columns[i]);
  out += "\n";
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) out += (i == 0 ? "" : ",") + csv_cell(row[i]);
    out += "\n";
  }
  return out;
}

std::string format_json(const Table& table) {
  std::string out = "[";
  for (const auto& row : table.rows) {
    out += out.size() == 1 ? "\n  {" : ",\n  {";
    for (std::size_t i = 0; i < row.size(); ++i) {
      out += (i == 0 ? "" : ", ") + files::json_quoted(table.columns[i]) + ": " + json_cell(row[i]);
    }
    out += "}";
  }
  return out + "\n]\n";
}

}  // namespace

std::string format_table(const Table& table, TableFormat format) {
  for ([[maybe_unused]] const auto& row : table.rows) assert(row.size() == table.columns.size());
  switch (format) {
    case TableFormat::text:
      return format_text(table);
    case TableFormat::csv:
      return format_csv(table);
    case TableFormat::json:
      break;
  }
  return format_json(table);
}

}  // namespace litfog::command
