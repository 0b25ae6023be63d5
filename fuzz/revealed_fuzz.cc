// Anything that an executable may answer when it is asked how it is made: the program is built of it, or
// refused with a sentence; what is built can be looked at.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include <google/protobuf/stubs/logging.h>

#include "mlab/robot/program/brought_code.h"

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  using namespace mlab;
  static const auto kLog = google::protobuf::SetLogHandler(nullptr);
  static_cast<void>(kLog);
  wire::Revealed revealed;
  if (!revealed.ParseFromArray(data, static_cast<int>(size))) return 0;
  const auto built = robot::host_revealed(revealed, {});
  if (!built) {
    if (!built.error().empty()) return 0;
    std::fprintf(stderr, "it is refused without a word\n");
    std::abort();
  }
  const flow::Frame& frame = built->program->initial_frame();
  for (const flow::Port& port : built->program->ports()) flow::Program::print(frame.data(), port);
  return 0;
}
