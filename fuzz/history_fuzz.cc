// Histories of runs, as a stranger's recording may have them: any entries are refused with a sentence, or the
// run that they tell of is computed for some cycles. A seed is a row of entries in protobuf's text format,
// each ended by a line `%`.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/text_format.h>

#include "mlab/history/replay.h"

namespace {

using namespace mlab;

constexpr int kMostCycles = 40;
constexpr std::size_t kMostRobots = 50;

class Silent : public google::protobuf::io::ErrorCollector {
  void AddError(int /*line*/, int /*column*/, const std::string& /*message*/) override {}
};

std::shared_ptr<history::History> read(std::string_view text) {
  Silent silent;
  google::protobuf::TextFormat::Parser parser;
  parser.RecordErrorsTo(&silent);
  parser.SetRecursionLimit(20);
  auto out = std::make_shared<history::History>();
  while (!text.empty()) {
    const std::size_t end = text.find("\n%\n");
    const std::string one(text.substr(0, end));
    text = end == std::string_view::npos ? "" : text.substr(end + 3);
    wire::HistoryEntry entry;
    if (parser.ParseFromString(one, &entry)) static_cast<void>(out->add(entry));
  }
  return out;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto history = read({reinterpret_cast<const char*>(data), size});
  text::Diagnostics problems;
  // Nobody has allowed code to be compiled.
  const auto replay = history::Replay::make(history, {}, problems);
  if (!replay || replay->run().mission().robots.size() > kMostRobots) return 0;
  for (int cycle = 0; cycle < kMostCycles && replay->step(); ++cycle) {
  }
  return 0;
}
