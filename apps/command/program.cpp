// SPDX-License-Identifier: Apache-2.0
#include "command/program.h"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>

#include "command/exit_status.h"
#include "litfog/files/output_error.h"
#include "text/system_reason.h"

namespace litfog::command {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// A file without a name, deleted when closed.
File temporary_file() {
  File file(std::tmpfile(), std::fclose);
  if (!file) throw OutputError(fmt::format("temporary file cannot be written: {}", system_reason(errno)));
  return file;
}

std::string contents_of(std::FILE* file) {
  std::string text;
  std::rewind(file);
  std::array<char, 4096> buffer;
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), file)) text.append(buffer.data(), count);
  return text;
}

}  // namespace

std::string run_program(const std::vector<std::string>& arguments, std::string_view input, const std::string& remedy) {
  const File in = temporary_file();
  const File out = temporary_file();
  const File messages = temporary_file();
  if (std::fwrite(input.data(), 1, input.size(), in.get()) != input.size() || std::fflush(in.get()) != 0) {
    throw OutputError(fmt::format("temporary file cannot be written: {}", system_reason(errno)));
  }
  std::rewind(in.get());

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(in.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(out.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(messages.get()), STDERR_FILENO);
  std::vector<std::string> texts = arguments;
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  const std::string& name = arguments.front();
  pid_t process = 0;
  const int error = posix_spawnp(&process, name.c_str(), &actions, nullptr, pointers.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    throw MissingCapability(fmt::format("{} cannot be run: {}; {}", name, system_reason(error), remedy));
  }
  int status = 0;
  while (waitpid(process, &status, 0) < 0) {
    if (errno != EINTR) throw MissingCapability(fmt::format("{} cannot be run: {}", name, system_reason(errno)));
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    throw MissingCapability(name + " failed: " + contents_of(messages.get()));
  }
  return contents_of(out.get());
}

}  // namespace litfog::command
