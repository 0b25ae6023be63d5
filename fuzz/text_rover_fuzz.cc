// Any lines from a text rover, and to one: as they are, and each with the checksum that it should have. What
// the device reports is fresh, finite and within what its sensors can measure; the model does not move faster
// than it can.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "mlab/model_vehicles/text_rover_model.h"
#include "mlab/vehicle/lines.h"
#include "mlab/vehicle/text_rover/text_rover.h"
#include "vehicle_bytes.h"

namespace {

using namespace mlab;

/// Cuts the next line off, its line feed included.
std::string next_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end == std::string_view::npos ? end : end + 1);
  text.remove_prefix(line.size());
  return std::string(line);
}

std::string summed(std::string line) {
  if (line.empty()) return line;
  if (line.ends_with('\n')) line.pop_back();
  return vehicle::line_of(line);
}

void hear(std::string_view text, bool is_summed) {
  auto line = std::make_unique<fuzz::SaidLine>();
  fuzz::SaidLine& said = *line;
  const auto device = vehicle::make_text_rover_over(std::move(line));
  fuzz::talk_to(**device, said, [&] { return is_summed ? summed(next_line(text)) : next_line(text); });
}

void tell(std::string_view text, bool is_summed) {
  model_vehicles::TextRoverModel vehicle(overlay::Overlay{}, {});
  for (int i = 0; i < 100 && !text.empty(); ++i) {
    vehicle.receive(is_summed ? summed(next_line(text)) : next_line(text));
    vehicle.step(0.05);
    fuzz::require(std::abs(vehicle.truth().speed) <= 0.5 + 1e-9);
  }
}

}  // namespace

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const bool is_summed : {false, true}) {
    hear(text, is_summed);
    tell(text, is_summed);
  }
  return 0;
}
