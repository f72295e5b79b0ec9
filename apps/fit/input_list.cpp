// SPDX-License-Identifier: Apache-2.0
#include "fit/input_list.h"

#include <algorithm>
#include <map>
#include <system_error>
#include <utility>

#include "command/bundled_data.h"
#include "command/option_rule.h"
#include "files/bundled_name.h"
#include "litfog/input_error.h"
#include "litfog/photometry/isocandela.h"
#include "litfog/photometry/tm33.h"
#include "text/ascii_text.h"
#include "text/file_text.h"
#include "text/system_reason.h"

namespace litfog::fit {
namespace {

namespace fs = std::filesystem;

/// Whether a file in a folder is meant: other JSON, XML and CSV may lie there. What cannot be read may be meant.
bool is_input(const fs::path& path) try {
  const std::string ending = ending_of(path);
  if (ending == ".ies" || ending == ".ldt" || ending == ".gldf") return true;
  const auto beginning = [&path] { return read_file_start(path.string(), 4096); };
  if (ending == ".json") return beginning().find("\"light-spec\"") != std::string::npos;
  if (ending == ".xml" || ending == ".iesxml") return is_tm33(beginning());
  return ending == ".csv" && is_isocandela(beginning());
} catch (const InputError&) {
  return true;
}

/// A path found in a folder, and why it could not be searched where it is a folder.
struct Found {
  fs::path path;
  std::error_code error = {};
};

std::vector<Found> files_in(const fs::path& top) {
  std::vector<Found> found;
  for (std::vector<fs::path> folders{top}; !folders.empty();) {
    const fs::path folder = std::move(folders.back());
    folders.pop_back();
    std::error_code error;
    fs::directory_iterator entry(folder, error);
    for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
      std::error_code no_status;
      const fs::file_status status = entry->status(no_status);
      // A link that leads nowhere is passed over, as is one to a folder, which may be that above it.
      const bool is_unknown = no_status && no_status != std::errc::no_such_file_or_directory &&
                              no_status != std::errc::too_many_symbolic_link_levels;
      if (fs::is_directory(status)) {
        if (!entry->is_symlink(no_status)) folders.push_back(entry->path());
      } else if ((fs::is_regular_file(status) || is_unknown) && is_input(entry->path())) {
        found.push_back({entry->path()});
      }
    }
    if (error) found.push_back({folder, error});
  }
  std::ranges::sort(found, {}, &Found::path);
  return found;
}

class InputList {
 public:
  void add(const std::string& argument) {
    std::error_code error;
    const std::size_t before = inputs_.size();
    if (argument.empty()) command::fail_option("input", argument, "must not be empty");
    if (fs::is_directory(argument, error)) {
      for (const auto& [path, unsearched] : files_in(argument)) {
        if (unsearched) {
          add_unsearched(path, unsearched);
        } else {
          add_file(path.string(), fs::path(argument));
        }
      }
      if (inputs_.size() == before) {
        command::fail_option("input", argument, "must hold light specs or photometric files");
      }
    } else {
      try {
        add_file(files::file_or_bundled(argument, command::bundled_folder("specs")).string(), {});
      } catch (const InputError&) {
        inputs_.push_back({argument, argument, std::current_exception()});
      }
    }
  }

  /// With an ending where a name alone would stand for several.
  std::vector<Input> inputs() && {
    std::map<std::string, std::vector<Input*>> of_name;
    for (Input& input : inputs_) {
      if (!input.error) of_name[input.name].push_back(&input);
    }
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
  static std::string name_of(fs::path path) {
    std::string name = path.replace_extension().string();
    std::ranges::replace(name, '/', '-');
    return name;
  }

  void add_unsearched(const fs::path& folder, std::error_code reason) {
    const InputError error({.file = folder.string()}, "cannot be searched: " + system_reason(reason));
    inputs_.push_back({folder.string(), folder.filename().string(), std::make_exception_ptr(error)});
  }

  void add_file(const std::string& path, const fs::path& folder) {
    const std::string name =
        name_of(folder.empty() ? fs::path(path).filename() : fs::path(path).lexically_relative(folder));
    if (ending_of(path) != ".gldf") {
      inputs_.push_back({path, name});
      return;
    }
    try {
      const auto container = std::make_shared<const GldfContainer>(path);
      for (const std::string& file : container->files()) {
        const fs::path in_folder = fs::path(file).lexically_relative(fs::path(path) / "ldc");
        const bool is_only = container->files().size() == 1;
        inputs_.push_back({file, is_only ? name : name + "-" + name_of(in_folder), nullptr, container});
      }
    } catch (const std::exception&) {
      inputs_.push_back({path, name, std::current_exception()});
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
