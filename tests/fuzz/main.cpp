// SPDX-License-Identifier: Apache-2.0
// litfog_fuzz                     names the targets, or without libFuzzer runs the seeds of all
// litfog_fuzz TARGET              without libFuzzer, runs its seeds
// litfog_fuzz TARGET FILE...      runs files
// litfog_fuzz TARGET FOLDER ...   libFuzzer's search from the target's seeds, its finds kept in the folder

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/fuzz_target.h"

namespace litfog::test {
namespace {

/// Ends the program where an expectation fails, so that libFuzzer keeps the bytes.
class Abort : public testing::EmptyTestEventListener {
  void OnTestPartResult(const testing::TestPartResult& result) override {
    std::fflush(stdout);
    if (result.failed()) std::abort();
  }
};

[[maybe_unused]] const FuzzTarget& start(std::string_view name) {
  testing::UnitTest::GetInstance()->listeners().Append(new Abort);
  for (const FuzzTarget& target : fuzz_targets()) {
    if (name == target.name) return target;
  }
  std::fprintf(stderr, "no target %s\n", std::string(name).c_str());
  std::exit(1);
}

#ifdef LITFOG_LIBFUZZER

const FuzzTarget* the_target = nullptr;

/// Takes the target from the arguments, and adds its folders of seeds to them.
void change_arguments(int& count, char**& arguments) {
  if (count < 2) {
    for (const FuzzTarget& target : fuzz_targets()) std::puts(target.name);
    std::exit(0);
  }
  static std::vector<std::string> texts(arguments, arguments + count);
  the_target = &start(texts[1]);
  texts.erase(texts.begin() + 1);
  if (texts.size() > 1 && std::filesystem::is_directory(texts[1])) {
    int number = 0;
    for (const std::string& seed : the_target->seeds()) {
      std::ofstream(texts[1] + "/seed-" + std::to_string(number++), std::ios::binary) << seed;
    }
    texts.insert(texts.end(), the_target->folders.begin(), the_target->folders.end());
  }
  static std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  count = int(pointers.size());
  pointers.push_back(nullptr);
  arguments = pointers.data();
}

#else

void run_file(const FuzzTarget& target, const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  target.run(std::string{std::istreambuf_iterator<char>(file), {}});
}

void run_seeds(const FuzzTarget& target) {
  std::printf("%s\n", target.name);
  std::fflush(stdout);
  for (const std::string& folder : target.folders) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) run_file(target, entry.path());
  }
  for (const std::string& seed : target.seeds()) target.run(seed);
  target.run({});
}

#endif

}  // namespace
}  // namespace litfog::test

#ifdef LITFOG_LIBFUZZER

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  litfog::test::change_arguments(*count, *arguments);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  litfog::test::the_target->run({reinterpret_cast<const char*>(bytes), size});
  return 0;
}

#else

int main(int count, char** arguments) {
  using namespace litfog::test;
  if (count < 2) {
    for (const FuzzTarget& target : fuzz_targets()) run_seeds(start(target.name));
    return 0;
  }
  const FuzzTarget& target = start(arguments[1]);
  if (count == 2) run_seeds(target);
  for (int i = 2; i < count; ++i) run_file(target, arguments[i]);
}

#endif
