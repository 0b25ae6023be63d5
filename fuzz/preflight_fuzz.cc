// Any file in the place of a signed checklist, and any message in the place of a vehicle's checks. What is
// read is written and read again as it was; what a vehicle says has bounds.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <google/protobuf/stubs/logging.h>

#include "mlab/preflight/preflight.h"
#include "mlab/vehicle/messages.h"

namespace {

using namespace mlab;

void require(bool holds) {
  if (!holds) std::abort();
}

void read_file(std::string_view text) {
  const auto read = preflight::read_signed(text);
  if (!read) return;
  const auto again = preflight::read_signed(preflight::json_of(*read));
  require(again.has_value() && *again == *read);
  require(!preflight::text_of(read->checklist).empty());
  const bool is_signed = preflight::why_not_signed(read->checklist, read->signature).empty();
  const bool holds =
      preflight::why_it_does_not_hold(*read, read->checklist, read->signature.at + 1.0).empty();
  require(is_signed || !holds);
}

void hear(std::string_view message) {
  constexpr std::size_t kLongest = 1000;  // bytes
  const auto checks = vehicle::decode_checks(message);
  if (!checks) return;
  require(checks->size() <= vehicle::kMostChecks);
  for (const vehicle::Check& one : *checks)
    require(!one.name.empty() && one.name.size() + one.is.size() + one.expected.size() < 3 * kLongest);
  const auto again = vehicle::decode_checks(vehicle::encode(*checks));
  require(again && again->size() == checks->size());
}

}  // namespace

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  static const bool kIsQuiet = [] {
    google::protobuf::SetLogHandler(nullptr);
    return true;
  }();
  static_cast<void>(kIsQuiet);
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  read_file(bytes);
  hear(bytes);
  return 0;
}
