// Runs a fuzzer's function over the files of the folders that are named, and over each of them cut short,
// with a byte changed and said twice: enough to notice that a fuzzer or its seeds no longer work, no
// substitute for fuzzing (which the sanitizers see too).

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "mlab/base/testing/processor_time.h"

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size);  // NOLINT(readability-identifier-naming)

namespace {

void run(const std::string& text) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

void run_variants(const std::string& text) {
  constexpr std::size_t kSteps = mlab::base::kIsSlowBuild ? 10 : 40;
  run(text);
  run(text + text);
  for (std::size_t i = 0; i < kSteps; ++i) {
    const std::size_t at = text.size() * i / kSteps;
    run(text.substr(0, at));
    run(text.substr(at));
    for (const char c : {'\0', '"', '-', '9', '\n', '\xff'}) {
      std::string changed = text;
      if (at < changed.size()) changed[at] = c;
      run(changed);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::size_t count = 0;
  for (int i = 1; i < argc; ++i) {
    for (const auto& entry : std::filesystem::directory_iterator(argv[i])) {
      std::ifstream file(entry.path(), std::ios::binary);
      run_variants({std::istreambuf_iterator<char>(file), {}});
      ++count;
    }
  }
  std::printf("%zu seeds\n", count);
  return count > 0 ? 0 : 1;
}
