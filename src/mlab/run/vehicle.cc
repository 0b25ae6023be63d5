#include "mlab/run/vehicle.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/core.h>

#include "mlab/base/angle.h"
#include "mlab/lang/cdl/types/body.h"

namespace mlab::run {
namespace {

// What a body has, by what its configuration and, but for the radius, missions call it.
struct Quantity {
  std::string_view key;
  void (*set)(binding::BodySpec& body, double value);  ///< in SI units
};

constexpr std::string_view kRadius = "radius";
constexpr std::string_view kRadiusOfMissions = "robot_radius";

constexpr Quantity kQuantities[] = {
    {kRadius, [](binding::BodySpec& b, double v) { b.radius = v; }},
    {"max_acceleration", [](binding::BodySpec& b, double v) { b.kinematics.max_acceleration = v; }},
    {"max_turn_rate", [](binding::BodySpec& b, double v) { b.kinematics.max_turn_rate = v; }},
    {"max_turn_acceleration", [](binding::BodySpec& b, double v) { b.kinematics.max_turn_acceleration = v; }},
    {"axle", [](binding::BodySpec& b, double v) { b.kinematics.axle = v; }},
    {"max_wheel_speed", [](binding::BodySpec& b, double v) { b.kinematics.max_wheel_speed = v; }},
    {"wheelbase", [](binding::BodySpec& b, double v) { b.kinematics.wheelbase = v; }},
    {"max_steer", [](binding::BodySpec& b, double v) { b.kinematics.max_steer = v; }},
    {"ring_count", [](binding::BodySpec& b, double v) { b.ring.count = static_cast<std::uint16_t>(v); }},
    {"ring_range", [](binding::BodySpec& b, double v) { b.ring.range = v; }},
    {"ring_beam_width", [](binding::BodySpec& b, double v) { b.ring.beam_width = v; }},
    {"ring_arc", [](binding::BodySpec& b, double v) { b.ring.arc = v; }},
    {"ring_obstacles", [](binding::BodySpec& b, double v) { b.has_ring_obstacles = v != 0.0; }},
    {"odometry_noise", [](binding::BodySpec& b, double v) { b.odometry_noise = v; }},
    {"max_speed", [](binding::BodySpec& b, double v) { b.kinematics.max_speed = v; }},
    {"ring_noise", [](binding::BodySpec& b, double v) { b.ring.noise = v; }},
    {"camera_field_of_view", [](binding::BodySpec& b, double v) { b.camera.field_of_view = v; }},
    {"camera_max_pan", [](binding::BodySpec& b, double v) { b.camera.max_pan = v; }},
    {"camera_pan_rate", [](binding::BodySpec& b, double v) { b.camera.max_pan_rate = v; }},
    {"radio_range", [](binding::BodySpec& b, double v) { b.radio.range = v; }},
    {"radio_loss", [](binding::BodySpec& b, double v) { b.radio.loss = v; }},
    {"ring_dropout", [](binding::BodySpec& b, double v) { b.ring.dropout = v; }},
};

std::string_view key_in_missions(const Quantity& quantity) {
  return quantity.key == kRadius ? kRadiusOfMissions : quantity.key;
}

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

// Whether the robot's program has refused the value: one word on it is enough.
bool is_refused(const mission::RobotParameter& parameter, const text::Diagnostics& sink) {
  const text::Place& at = parameter.value_place;
  return at.source && std::ranges::any_of(sink.items(), [&](const text::Diagnostic& one) {
           return one.severity == text::Severity::kError && one.place.source == at.source &&
                  one.place.span.begin == at.span.begin;
         });
}

binding::Drive drive_of(const mission::RobotParameter& parameter, text::Diagnostics& sink) {
  std::string upper = parameter.value;
  std::transform(upper.begin(), upper.end(), upper.begin(), [](unsigned char c) { return std::toupper(c); });
  if (upper == "DIFFERENTIAL") return binding::Drive::kDifferential;
  if (upper == "SYNCHRO") return binding::Drive::kSynchro;
  if (upper == "CAR" || upper == "NO_HOLONOMIC") return binding::Drive::kCar;
  constexpr std::string_view kHolonomic[] = {"HOLONOMIC", "SIMULATION", "HSERVER", "MRV2", "DRV1"};
  if (std::find(std::begin(kHolonomic), std::end(kHolonomic), upper) == std::end(kHolonomic)) {
    sink.warning("unknown-robot-type", parameter.value_place,
                 fmt::format("unknown robot_type `{}`", parameter.value))
        .hints = {"it is simulated as HOLONOMIC; the others are DIFFERENTIAL, SYNCHRO and CAR"};
  }
  return binding::Drive::kHolonomic;
}

// A setting of the class in a configuration.
void configure(binding::BodySpec& body, std::string_view name, double value, const mission::RobotType& type,
               text::Diagnostics& sink) {
  if (name == "drive") {
    body.kinematics.drive = static_cast<binding::Drive>(std::clamp(static_cast<int>(value), 0, 3));
    return;
  }
  for (const Quantity& quantity : kQuantities) {
    if (quantity.key != name) continue;
    const cdl::BodyProperty& property = *cdl::body_property(quantity.key);
    const double bound_value = property.is_angle() ? base::degrees(value) : value;
    constexpr double kRounding = 1e-9;  // of what was converted there and back
    if (bound_value >= property.min * (1 - kRounding) && bound_value <= property.max * (1 + kRounding)) {
      quantity.set(body, value);
    } else {
      sink.error("out-of-range", type.place, fmt::format("the body's `{}` can't be {}", name, bound_value))
          .label = fmt::format("takes a number from {} to {}", property.min, property.max);
    }
    return;
  }
  text::Diagnostic& d =
      sink.error("unknown-body-setting", type.place, fmt::format("a body has no `{}`", name));
  const std::string nearest = text::nearest_name(std::string(name), cdl::body_settings());
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
      if (key_in_missions(quantity) != parameter.key) continue;
      const cdl::BodyProperty& property = *cdl::body_property(quantity.key);
      const std::optional<double> value = number(parameter.value);
      if (value && *value >= property.min && *value <= property.max) {
        quantity.set(body, property.is_angle() ? base::radians(*value) : *value);
      } else if (!is_refused(parameter, sink)) {
        sink.error("out-of-range", parameter.value_place,
                   fmt::format("`{}` can't be {}", parameter.key, parameter.value))
            .label = fmt::format("takes a number from {} to {}", property.min, property.max);
      }
    }
  }
  body.ring.first_angle = -body.ring.arc / 2;
  return body;
}

const std::vector<std::string>& vehicle_keys() {
  static const std::vector<std::string> kKeys = [] {
    std::vector<std::string> keys = {"robot_type"};
    for (const Quantity& quantity : kQuantities) keys.emplace_back(key_in_missions(quantity));
    for (const std::string_view key : kHardwareKeys) keys.emplace_back(key);
    return keys;
  }();
  return kKeys;
}

}  // namespace mlab::run
