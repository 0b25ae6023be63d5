// Any bytes from an MRV-2, and to one: as they are, and as whole frames. What the device reports is fresh,
// finite and within what its sensors can measure; the model does not move faster than it can.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "mlab/model_vehicles/mrv2_model.h"
#include "mlab/vehicle/mrv2/frames.h"
#include "mlab/vehicle/mrv2/mrv2.h"
#include "vehicle_bytes.h"

namespace {

using namespace mlab;

/// Cuts the next piece off: its length is in front of it.
std::string_view next_piece(std::string_view& text) {
  if (text.empty()) return {};
  const std::size_t length = 1 + static_cast<std::uint8_t>(text[0]) % 64U;
  const std::string_view piece = text.substr(1, length);
  text.remove_prefix(1 + piece.size());
  return piece;
}

std::string as_frame(std::string_view piece) {
  return vehicle::mrv2::bytes_of(vehicle::mrv2::Frame{static_cast<std::uint8_t>(piece[0]), piece.substr(1)});
}

void hear(std::string_view text, bool in_frames) {
  auto line = std::make_unique<fuzz::SaidLine>();
  fuzz::SaidLine& said = *line;
  const auto device = vehicle::make_mrv2_over(std::move(line));
  fuzz::talk_to(**device, said, [&] {
    const std::string_view piece = next_piece(text);
    return piece.empty() || !in_frames ? std::string(piece) : as_frame(piece);
  });
}

void tell(std::string_view text, bool in_frames) {
  model_vehicles::Mrv2Model vehicle(overlay::Overlay{}, {});
  for (int i = 0; i < 100; ++i) {
    const std::string_view piece = next_piece(text);
    if (piece.empty()) return;
    vehicle.receive(in_frames ? as_frame(piece) : std::string(piece));
    vehicle.step(0.05);
    fuzz::require(std::abs(vehicle.truth().speed) <= 0.1 + 1e-9);
  }
}

}  // namespace

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  for (const bool in_frames : {false, true}) {
    hear(text, in_frames);
    tell(text, in_frames);
  }
  return 0;
}
