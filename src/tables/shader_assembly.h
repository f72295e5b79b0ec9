// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace litfog {

/// Assembles a shader from files, for drivers without `#include "name"`: the first such line of a file is replaced by
/// the file. `#line` keeps each file's own line numbers, by the file's index in names().
class ShaderAssembly {
 public:
  /// text_of  gets a file's text by its name; throws if there is none
  explicit ShaderAssembly(std::function<std::string_view(std::string_view)> text_of) : text_of_(std::move(text_of)) {}

  /// Adds a line outside of any file, such as `#version`.
  void add_line(std::string_view line) { text_.append(line).append("\n"); }

  /// Adds a file, unless it was added before.
  void add_file(std::string_view name) {
    if (std::ranges::find(names_, name) != names_.end()) return;
    begin_at(1, names_.size());
    add_source(name, text_of_(name));
  }

  /// Adds the text of a file that text_of need not know. No `#line` precedes it, because `#version` may begin it.
  void add_source(std::string_view name, std::string_view source) {
    const std::size_t file = names_.size();
    names_.push_back(name);
    for (std::size_t line = 1; !source.empty(); ++line) {
      const std::string_view text = source.substr(0, source.find('\n'));
      source.remove_prefix(std::min(text.size() + 1, source.size()));
      constexpr std::string_view kInclude = "#include \"";
      if (text.starts_with(kInclude)) {
        const std::string_view included = text.substr(kInclude.size());
        add_file(included.substr(0, included.find('"')));
        begin_at(line + 1, file);
      } else {
        add_line(text);
      }
    }
  }

  const std::string& text() const { return text_; }
  const std::vector<std::string_view>& names() const { return names_; }

 private:
  void begin_at(std::size_t line, std::size_t file) {
    add_line("#line " + std::to_string(line) + " " + std::to_string(file));
  }

  std::function<std::string_view(std::string_view)> text_of_;
  std::vector<std::string_view> names_;
  std::string text_;
};

}  // namespace litfog
