#include "mlab/fleet/vehicle.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/core.h>

#include "mlab/base/angle.h"

namespace mlab::fleet {
namespace {

struct Quantity {
  std::string_view key;
  double min;
  double max;
  void (*set)(binding::BodySpec& body, double value);  ///< in SI units
  bool is_angle = false;                               ///< missions write it, and the bounds, in degrees
};

constexpr double kLarge = 1e6;

constexpr Quantity kQuantities[] = {
    {"robot_radius", 0.001, 1000.0, [](binding::BodySpec& b, double v) { b.radius = v; }},
    {"max_acceleration", 0.0, kLarge,
     [](binding::BodySpec& b, double v) { b.kinematics.max_acceleration = v; }},
    {"max_turn_rate", 0.0, kLarge, [](binding::BodySpec& b, double v) { b.kinematics.max_turn_rate = v; },
     true},
    {"max_turn_acceleration", 0.0, kLarge,
     [](binding::BodySpec& b, double v) { b.kinematics.max_turn_acceleration = v; }, true},
    {"axle", 0.001, 1000.0, [](binding::BodySpec& b, double v) { b.kinematics.axle = v; }},
    {"max_wheel_speed", 0.0, kLarge,
     [](binding::BodySpec& b, double v) { b.kinematics.max_wheel_speed = v; }},
    {"wheelbase", 0.001, 1000.0, [](binding::BodySpec& b, double v) { b.kinematics.wheelbase = v; }},
    {"max_steer", 0.1, 89.0, [](binding::BodySpec& b, double v) { b.kinematics.max_steer = v; }, true},
    {"ring_count", 0.0, 720.0,
     [](binding::BodySpec& b, double v) { b.ring.count = static_cast<std::uint16_t>(v); }},
    {"ring_range", 0.0, 10'000.0, [](binding::BodySpec& b, double v) { b.ring.range = v; }},
    {"ring_beam_width", 0.0, 180.0, [](binding::BodySpec& b, double v) { b.ring.beam_width = v; }, true},
    {"ring_arc", 0.0, 359.0, [](binding::BodySpec& b, double v) { b.ring.arc = v; }, true},
    {"ring_obstacles", 0.0, 1.0, [](binding::BodySpec& b, double v) { b.has_ring_obstacles = v != 0.0; }},
    {"odometry_noise", 0.0, 1.0, [](binding::BodySpec& b, double v) { b.odometry_noise = v; }},
    {"max_speed", 0.0, kLarge, [](binding::BodySpec& b, double v) { b.kinematics.max_speed = v; }},
    {"ring_noise", 0.0, 1000.0, [](binding::BodySpec& b, double v) { b.ring.noise = v; }},
    {"camera_field_of_view", 0.0, 360.0, [](binding::BodySpec& b, double v) { b.camera.field_of_view = v; },
     true},
    {"camera_max_pan", 0.0, 180.0, [](binding::BodySpec& b, double v) { b.camera.max_pan = v; }, true},
    {"camera_pan_rate", 0.0, kLarge, [](binding::BodySpec& b, double v) { b.camera.max_pan_rate = v; }, true},
    {"ring_dropout", 0.0, 1.0, [](binding::BodySpec& b, double v) { b.ring.dropout = v; }},
};

// Keys of the historic robots that name hardware or its connection. They mean nothing in simulation.
constexpr std::string_view kHardwareKeys[] = {
    "run_type",         "wait_for_ack",      "lurch_mode",    "draw_obstacles",
    "adjust_obstacles", "use_reverse",       "wait_for_turn", "danger_range",
    "drive_wait_angle", "multiple_hservers", "hserver_name",  "use_laser",
    "use_sonar",        "use_cognachrome",   "compass_type",  "spin_slippage_factor",
    "desired_robot_id", "extra_robot",       "timeout",       "tty_num",
    "echo_tty"};

std::optional<double> number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

binding::Drive drive_of(const mission::RobotParameter& parameter, text::Diagnostics& sink) {
  std::string upper = parameter.value;
  std::transform(upper.begin(), upper.end(), upper.begin(), [](unsigned char c) { return std::toupper(c); });
  if (upper == "DIFFERENTIAL") return binding::Drive::kDifferential;
  if (upper == "SYNCHRO") return binding::Drive::kSynchro;
  if (upper == "CAR" || upper == "NO_HOLONOMIC") return binding::Drive::kCar;
  constexpr std::string_view kHolonomic[] = {"HOLONOMIC", "SIMULATION", "HSERVER", "MRV2", "DRV1"};
  if (std::find(std::begin(kHolonomic), std::end(kHolonomic), upper) == std::end(kHolonomic)) {
    sink.warning("unknown-robot-type", parameter.place,
                 fmt::format("unknown robot_type `{}`", parameter.value))
        .hints = {"it is simulated as HOLONOMIC; the others are DIFFERENTIAL, SYNCHRO and CAR"};
  }
  return binding::Drive::kHolonomic;
}

std::string_view key_of(std::string_view setting) {
  return setting == "radius" ? "robot_radius" : setting;
}

// A setting of the class in a configuration.
void configure(binding::BodySpec& body, std::string_view name, double value, const mission::RobotType& type,
               text::Diagnostics& sink) {
  if (name == "drive") {
    body.kinematics.drive = static_cast<binding::Drive>(std::clamp(static_cast<int>(value), 0, 3));
    return;
  }
  for (const Quantity& quantity : kQuantities) {
    if (quantity.key != key_of(name)) continue;
    const double bound_value = quantity.is_angle ? base::degrees(value) : value;
    if (bound_value >= quantity.min && bound_value <= quantity.max) {
      quantity.set(body, value);
    } else {
      sink.error("out-of-range", type.place, fmt::format("the body's `{}` can't be {}", name, bound_value))
          .label = fmt::format("takes a number from {} to {}", quantity.min, quantity.max);
    }
    return;
  }
  text::Diagnostic& d =
      sink.error("unknown-body-setting", type.place, fmt::format("a body has no `{}`", name));
  const std::string nearest = text::nearest_name(std::string(name), body_settings());
  if (!nearest.empty()) d.hints.push_back(fmt::format("did you mean `{}`?", nearest));
}

}  // namespace

binding::BodySpec body_of(const mission::RobotType& type, const std::map<std::string, double>& configured,
                          text::Diagnostics& sink) {
  binding::BodySpec body;
  body.kinematics.axle = 0.4;
  body.ring.range = 5.0;
  for (const auto& [name, value] : configured) configure(body, name, value, type, sink);
  for (const mission::RobotParameter& parameter : type.parameters) {
    if (parameter.key == "robot_type") body.kinematics.drive = drive_of(parameter, sink);
    for (const Quantity& quantity : kQuantities) {
      if (quantity.key != parameter.key) continue;
      const std::optional<double> value = number(parameter.value);
      if (value && *value >= quantity.min && *value <= quantity.max) {
        quantity.set(body, quantity.is_angle ? base::radians(*value) : *value);
      } else {
        sink.error("out-of-range", parameter.place,
                   fmt::format("`{}` can't be {}", parameter.key, parameter.value))
            .label = fmt::format("takes a number from {} to {}", quantity.min, quantity.max);
      }
    }
  }
  body.ring.first_angle = -body.ring.arc / 2;
  return body;
}

const std::vector<std::string>& vehicle_keys() {
  static const std::vector<std::string> kKeys = [] {
    std::vector<std::string> keys = {"robot_type"};
    for (const Quantity& quantity : kQuantities) keys.emplace_back(quantity.key);
    for (const std::string_view key : kHardwareKeys) keys.emplace_back(key);
    return keys;
  }();
  return kKeys;
}

std::vector<std::string> body_settings() {
  std::vector<std::string> names = {"radius", "drive"};
  for (const Quantity& quantity : kQuantities) names.emplace_back(quantity.key);
  return names;
}

}  // namespace mlab::fleet
