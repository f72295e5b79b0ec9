// SPDX-License-Identifier: Apache-2.0
#include "fit/input_list.h"

#include <glob.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>

#include "ascii_text.h"
#include "command/bundled_data.h"
#include "command/option_rule.h"
#include "files/hint.h"
#include "litfog/input_error.h"
#include "litfog/photometry/gldf.h"
#include "litfog/photometry/isocandela.h"
#include "litfog/photometry/tm33.h"

namespace litfog::fit {
namespace {

namespace fs = std::filesystem;

std::string beginning_of(const fs::path& path) {
  std::array<char, 4096> text{};
  std::ifstream file(path, std::ios::binary);
  file.read(text.data(), text.size());
  return {text.data(), std::size_t(file.gcount())};
}

/// Whether a file in a folder is meant: other JSON, XML and CSV may lie there.
bool is_input(const fs::path& path) {
  const std::string ending = ending_of(path);
  if (ending == ".ies" || ending == ".ldt" || ending == ".gldf") return true;
  if (ending == ".json") return beginning_of(path).find("\"light-spec\"") != std::string::npos;
  if (ending == ".xml" || ending == ".iesxml") return is_tm33(beginning_of(path));
  return ending == ".csv" && is_isocandela(beginning_of(path));
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && entry != fs::recursive_directory_iterator(); entry.increment(error)) {
    std::error_code no_status;  // of a link that leads nowhere
    if (entry->is_regular_file(no_status) && is_input(entry->path())) files.push_back(entry->path());
  }
  if (error) throw InputError({.file = folder.string()}, "cannot be searched: " + error.message());
  std::ranges::sort(files);
  return files;
}

std::vector<std::string> files_of_pattern(const std::string& pattern) {
  glob_t matches{};
  const std::unique_ptr<glob_t, decltype(&globfree)> owner(&matches, globfree);
  if (glob(pattern.c_str(), 0, nullptr, &matches) != 0) return {};
  return {matches.gl_pathv, matches.gl_pathv + matches.gl_pathc};
}

class InputList {
 public:
  void add(const std::string& argument) {
    std::error_code error;
    const std::size_t before = inputs_.size();
    if (argument.empty()) command::fail_option("input", argument, "must not be empty");
    if (fs::is_directory(argument, error)) {
      for (const fs::path& file : files_in(argument)) add_file(file.string(), fs::path(argument));
      if (inputs_.size() == before) {
        command::fail_option("input", argument, "must hold light specs or photometric files");
      }
    } else if (!fs::exists(argument, error) && argument.find_first_of("*?[") != argument.npos) {
      for (const std::string& file : files_of_pattern(argument)) add(file);
      if (inputs_.size() == before) command::fail_option("input", argument, "must match a file");
    } else {
      add_file(found(argument), {});
    }
  }

  /// With an ending where a name alone would stand for several.
  std::vector<Input> inputs() && {
    std::map<std::string, std::vector<Input*>> of_name;
    for (Input& input : inputs_) of_name[input.name].push_back(&input);
    for (auto& [name, same] : of_name) {
      const auto is_other = [&first = same.front()->path](const Input* input) {
        return ending_of(input->path) != ending_of(first);
      };
      if (std::ranges::none_of(same, is_other)) continue;
      for (Input* input : same) input->name += fs::path(input->path).extension().string();
    }
    return std::move(inputs_);
  }

 private:
  /// A file, or else the spec of a bundled light of that name.
  static std::string found(const std::string& argument) {
    std::error_code error;
    if (fs::exists(argument, error) || fs::path(argument).has_parent_path()) return argument;
    const fs::path folder = command::bundled_folder("specs");
    const fs::path bundled = folder / (argument + ".json");
    if (fs::exists(bundled, error)) return bundled.string();
    if (fs::path(argument).has_extension()) return argument;
    throw InputError({.file = argument}, "must be a file or a bundled light" + hint_for_bundled(argument, folder));
  }

  static std::string hint_for_bundled(const std::string& argument, const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
      names.push_back(entry.path().stem().string());
    }
    std::ranges::sort(names);
    return files::hint_for_word(argument, {names.begin(), names.end()});
  }

  static std::string name_of(fs::path path) {
    std::string name = path.replace_extension().string();
    std::ranges::replace(name, '/', '-');
    return name;
  }

  void add_file(const std::string& path, const fs::path& folder) {
    const std::string name =
        name_of(folder.empty() ? fs::path(path).filename() : fs::path(path).lexically_relative(folder));
    if (ending_of(path) != ".gldf") {
      inputs_.push_back({path, name});
      return;
    }
    std::vector<std::string> files;
    try {
      files = list_gldf(path);
    } catch (const InputError&) {
      files = {path};  // the error comes when it is read
    }
    for (const std::string& file : files) {
      const fs::path in_folder = fs::path(file).lexically_relative(fs::path(path) / "ldc");
      inputs_.push_back({file, files.size() == 1 ? name : name + "-" + name_of(in_folder)});
    }
  }

  std::vector<Input> inputs_;
};

}  // namespace

std::string ending_of(const fs::path& path) { return lower(path.extension().string()); }

std::vector<Input> list_inputs(const std::vector<std::string>& arguments) {
  InputList list;
  for (const std::string& argument : arguments) list.add(argument);
  return std::move(list).inputs();
}

}  // namespace litfog::fit
