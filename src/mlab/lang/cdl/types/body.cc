#include "mlab/lang/cdl/types/body.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mlab::cdl {
namespace {

constexpr double kLarge = 1e6;

constexpr BodyProperty kProperties[] = {
    {"radius", "body", "m", "0.2 m", 0.001, 1000.0, "of the disc that the body takes up"},
    {"odometry_noise", "body", "", "0", 0.0, 1.0,
     "how much of each step its wheels miscount, as a share; 0: it knows exactly where it is"},
    {"max_speed", "drive", "m/s", "0 m/s", 0.0, kLarge, "never faster than this; 0: no limit"},
    {"max_acceleration", "drive", "", "0", 0.0, kLarge, "in m/s per second; 0: no limit"},
    {"max_turn_rate", "drive", "deg/s", "0 deg/s", 0.0, kLarge, "never turns faster than this; 0: no limit"},
    {"max_turn_acceleration", "drive", "", "0", 0.0, kLarge, "in rad/s per second; 0: no limit"},
    {"axle", "drive", "m", "0.4 m", 0.001, 1000.0, "between the two wheels of a differential drive"},
    {"max_wheel_speed", "drive", "m/s", "0 m/s", 0.0, kLarge,
     "of each wheel of a differential or synchro drive; 0: no limit"},
    {"wheelbase", "drive", "m", "1.25 m", 0.001, 1000.0, "between the axles of a car"},
    {"max_steer", "drive", "deg", "75 deg", 0.1, 89.0, "of a car's front wheels, to each side"},
    {"ring_count", "ring", "", "0", 0.0, 720.0, "how many range sensors it has; 0: none", true},
    {"ring_arc", "ring", "deg", "0 deg", 0.0, 359.0,
     "over which they are spread, ahead in the middle; 0: all round"},
    {"ring_range", "ring", "m", "5 m", 0.0, 10'000.0, "how far they measure, from the body's surface"},
    {"ring_beam_width", "ring", "deg", "0 deg", 0.0, 180.0,
     "of each one's cone, in which it tells the nearest thing; 0: a single ray"},
    {"ring_noise", "ring", "m", "0 m", 0.0, 1000.0, "standard deviation of what they measure"},
    {"ring_dropout", "ring", "", "0", 0.0, 1.0, "how often one that hit something tells nothing, as a share"},
    {"ring_obstacles", "ring", "", "0", 0.0, 1.0,
     "1: obstacles are what the range sensors hit; 0: they are seen as they are", true},
    {"camera_field_of_view", "camera", "deg", "360 deg", 0.0, 360.0, "in which it sees objects"},
    {"camera_max_pan", "camera", "deg", "180 deg", 0.0, 180.0,
     "how far the camera turns to each side; 180: round without end"},
    {"camera_pan_rate", "camera", "deg/s", "0 deg/s", 0.0, kLarge, "how fast the camera turns; 0: no limit"},
    {"radio_range", "radio", "m", "0 m", 0.0, kLarge,
     "how far its radio is heard, where no wall is; 0: everywhere"},
    {"radio_loss", "radio", "", "0", 0.0, 1.0, "how often what is told does not arrive, as a share"},
};

}  // namespace

std::span<const BodyProperty> body_properties() {
  return kProperties;
}

const BodyProperty* body_property(std::string_view name) {
  const auto* const found = std::ranges::find(kProperties, name, &BodyProperty::name);
  return found == std::end(kProperties) ? nullptr : found;
}

BodyMisfit body_misfit(const BodyProperty& property, double number, const Unit& unit) {
  const std::optional<Unit> wanted = unit_named(property.unit);
  const std::optional<double> converted_number = wanted ? converted(number, unit, *wanted) : std::nullopt;
  if (!converted_number) return BodyMisfit::kUnit;
  constexpr double kRounding = 1e-9;  // of what was converted there and back
  const bool is_in_range = *converted_number >= property.min * (1 - kRounding) &&
                           *converted_number <= property.max * (1 + kRounding);
  if (!is_in_range) return BodyMisfit::kRange;
  const bool is_fraction = property.is_whole && *converted_number != std::floor(*converted_number);
  return is_fraction ? BodyMisfit::kFraction : BodyMisfit::kNone;
}

std::vector<std::string> body_settings() {
  std::vector<std::string> out = {"drive"};
  for (const BodyProperty& property : kProperties) out.emplace_back(property.name);
  std::ranges::sort(out.begin() + 1, out.end());
  return out;
}

}  // namespace mlab::cdl
