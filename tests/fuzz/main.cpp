// SPDX-License-Identifier: Apache-2.0
// litfog_fuzz                     names the targets, or without libFuzzer runs the seeds of all, whole and damaged
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
#include "reference/random_light.h"

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

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return std::string{std::istreambuf_iterator<char>(file), {}};
}

/// Bytes changed at one to four places: another byte, dropped, doubled, or a word at which readers stumble; and some of
/// them cut.
std::string damaged(std::string bytes, Random& random) {
  static const std::vector<std::string> words{"-1",   "2147483648", "4294967297", "1e999", "1e-999", "nan", "inf",
                                              "0x10", "",           "-0.",        "\xFF",  "\r",     "\n",  ",",
                                              "-",    "+",          "1e30",       "TILT=", "{",      "]",   "\""};
  for (int left = 1 + random.below(4); left > 0 && !bytes.empty(); --left) {
    const auto at = std::size_t(random.below(int(bytes.size()))), length = std::size_t(random.below(4));
    if (random.chance(0.3)) {
      bytes[at] = char(random.below(256));
    } else if (random.chance(0.3)) {
      bytes.erase(at, length);
    } else if (random.chance(0.3)) {
      bytes.insert(at, bytes.substr(at, length));
    } else {
      bytes.replace(at, length, random.pick(words));
    }
  }
  if (random.chance(0.1)) bytes.resize(std::size_t(random.below(int(bytes.size()) + 1)));
  return bytes;
}

void run_seeds(const FuzzTarget& target) {
  const int damages = target.seeds == random_seeds ? 20 : 1000;  // of each seed
  constexpr std::size_t kMostCuts = 4096;
  std::printf("%s\n", target.name);
  std::fflush(stdout);
  std::vector<std::string> seeds = target.seeds();
  for (const std::string& folder : target.folders) {
    for (const auto& entry : std::filesystem::directory_iterator(folder)) seeds.push_back(text_of(entry.path()));
  }
  target.run({});
  Random random(1);
  for (const std::string& seed : seeds) {
    target.run(seed);
    for (int i = 0; i < damages; ++i) target.run(damaged(seed, random));
    for (std::size_t size = 0; size < std::min(seed.size(), kMostCuts) && target.seeds != random_seeds; ++size) {
      target.run(seed.substr(0, size));
    }
  }
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
  for (int i = 2; i < count; ++i) target.run(text_of(arguments[i]));
}

#endif
