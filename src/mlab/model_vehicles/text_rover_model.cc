#include "mlab/model_vehicles/text_rover_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "mlab/model_vehicles/body.h"
#include "mlab/vehicle/lines.h"

namespace mlab::model_vehicles {
namespace {

constexpr double kHoldsAtMost = 1.0;  // a command, from when it came [s]
constexpr double kPlaceEvery = 0.1;
constexpr double kRangesEvery = 0.2;
constexpr double kBatteryEvery = 0.5;
constexpr double kLasts = 2 * 3600.0;  // its battery [s]

binding::BodySpec rover_body(const TextRoverSpec& spec) {
  binding::BodySpec body;
  body.radius = 0.2;
  body.kinematics = {.drive = binding::Drive::kDifferential,
                     .axle = 0.3,
                     .max_speed = spec.max_speed,
                     .max_acceleration = 0.5,
                     .max_turn_rate = spec.max_turn_rate};
  body.ring = {.count = 8, .range = 3.0};
  body.odometry_noise = spec.encoder_noise;
  return body;
}

}  // namespace

struct TextRoverModel::Parts {
  Body body;
  vehicle::LineReader lines;
  double time = 0.0;  // since it was switched on [s]
  double worked = 0.0;
  double speed = 0.0;
  double turn_rate = 0.0;
  double good_until = 0.0;  // on its own clock [s]
  double said_place = 0.0;
  double said_ranges = 0.0;
  double said_battery = 0.0;

  Parts(const overlay::Overlay& world, const TextRoverSpec& spec)
      : body(world, rover_body(spec), spec.place, spec.seed) {}

  void obey(const vehicle::Words& words);
  std::string say(double dt);
  bool is_due(double& said, double every, double dt) const {
    if (time - said < every - dt / 2) return false;
    said = time;
    return true;
  }
};

void TextRoverModel::Parts::obey(const vehicle::Words& words) {
  if (words.word == 'S' && words.numbers.empty()) good_until = 0.0;
  if (words.word != 'V' || words.numbers.size() != 3) return;
  good_until = std::min(words.numbers[0] / 1000.0, time + kHoldsAtMost);
  speed = words.numbers[1];
  turn_rate = words.numbers[2];
}

std::string TextRoverModel::Parts::say(double dt) {
  const auto now = std::llround(time * 1000.0);
  std::string said;
  if (is_due(said_place, kPlaceEvery, dt)) {
    const Truth truth = body.truth();
    const geom::Pose pose = body.counted();
    said += vehicle::line_of(fmt::format("P {} {:.3f} {:.3f} {:.4f} {:.3f} {:.3f}", now, pose.position.x,
                                         pose.position.y, pose.heading, truth.speed, truth.turn_rate));
  }
  if (is_due(said_ranges, kRangesEvery, dt)) {
    std::string text = fmt::format("R {}", now);
    for (const percept::RangeReading& reading : body.ranges())
      text += reading.hit ? fmt::format(" {:.2f}", reading.distance) : " -";
    said += vehicle::line_of(text);
  }
  if (is_due(said_battery, kBatteryEvery, dt))
    said += vehicle::line_of(fmt::format("B {} {:.0f}", now, std::max(0.0, 100.0 * (1.0 - worked / kLasts))));
  return said;
}

TextRoverModel::TextRoverModel(const overlay::Overlay& world, const TextRoverSpec& spec)
    : parts_(std::make_unique<Parts>(world, spec)) {}

TextRoverModel::~TextRoverModel() = default;

void TextRoverModel::receive(std::string_view bytes) {
  parts_->lines.add(bytes);
  while (const auto line = parts_->lines.next()) {
    if (const auto words = vehicle::words_of(*line)) parts_->obey(*words);
  }
}

std::string TextRoverModel::step(double dt) {
  Parts& p = *parts_;
  p.time += dt;
  p.worked += dt;
  const bool moves = p.time < p.good_until;
  p.body.step(moves ? p.speed : 0.0, moves ? p.turn_rate : 0.0, dt);
  return p.say(dt);
}

void TextRoverModel::restart() {
  Parts& p = *parts_;
  p.time = p.good_until = p.said_place = p.said_ranges = p.said_battery = 0.0;
  p.lines.begin_anew();
  p.body.count_from_here();
}

ModelVehicle::Truth TextRoverModel::truth() const {
  return parts_->body.truth();
}

}  // namespace mlab::model_vehicles
