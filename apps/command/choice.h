// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "command/command.h"

namespace litfog::command {

/// A word of the command line, its value, and a sentence that explains it in a window.
template <typename Value>
struct Choice {
  const char* word;
  Value value;
  const char* meaning;
};

template <typename Value, std::size_t count>
const char* word_of(const Choice<Value> (&choices)[count], const Value& value) {
  for (const auto& choice : choices) {
    if (choice.value == value) return choice.word;
  }
  return "";
}

/// An option that takes one of a table's words.
template <typename Target, typename Value, std::size_t count>
CLI::Option* add_choice(CLI::App& app, const std::string& name, Target& target, const Choice<Value> (&choices)[count],
                        const std::string& description) {
  std::vector<std::pair<std::string, Target>> words;
  for (const auto& choice : choices) words.emplace_back(choice.word, choice.value);
  return add_choice(app, name, target, std::move(words), description);
}

}  // namespace litfog::command
