#include "mlab/model_vehicles/mrv2_model.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "mlab/base/angle.h"
#include "mlab/base/hash.h"
#include "mlab/base/random.h"
#include "mlab/model_vehicles/body.h"
#include "mlab/vehicle/mrv2/frames.h"
#include "mlab/vehicle/mrv2/messages.h"

namespace mlab::model_vehicles {
namespace {

using vehicle::mrv2::Drive;
using vehicle::mrv2::Message;

constexpr std::uint16_t kSensors = 24;
constexpr double kRadius = 0.4;
constexpr double kStateEvery = 0.1;
constexpr double kSonarsEvery = 0.2;
constexpr double kEmptyAfter = 4 * 3600.0;  // of its battery [s]
constexpr double kEmptyVoltage = 22.0;
constexpr double kFullVoltage = 26.0;

binding::BodySpec body_of(const Mrv2Spec& spec) {
  binding::BodySpec body;
  body.radius = kRadius;
  body.kinematics = {.drive = binding::Drive::kSynchro,
                     .max_speed = spec.max_speed,
                     .max_acceleration = spec.max_acceleration,
                     .max_turn_rate = spec.max_turn_rate};
  body.ring = {.count = kSensors, .range = spec.sonar.range, .beam_width = spec.sonar.beam_width};
  body.odometry_noise = spec.encoder_noise;
  return body;
}

}  // namespace

struct Mrv2Model::Parts {
  Mrv2Spec spec;
  Body body;
  base::Random random;
  vehicle::mrv2::FrameReader frames;
  std::uint16_t boot = 0;
  double time = 0.0;    // since it was switched on [s]
  double worked = 0.0;  // since its battery was charged [s]
  double said_state = 0.0;
  double said_ranges = 0.0;
  std::optional<Drive> drive;
  double drive_ends = 0.0;  // on its own clock [s]
  double lurch_time = 0.0;  // since it began to move
  bool stop_is_pressed = false;
  std::string says;

  Parts(const overlay::Overlay& world, const Mrv2Spec& how)
      : spec(how), body(world, body_of(how), how.place, how.seed), random(base::combine_bits(how.seed, 1)) {}

  std::uint32_t clock() const { return static_cast<std::uint32_t>(std::llround(time * 1000.0)); }
  void say(const Message& message) { says += vehicle::mrv2::bytes_of(message); }
  void obey(const Message& message);
  void say_identity();
  void say_state();
  void say_ranges();
  bool is_pausing(double dt);
};

void Mrv2Model::Parts::obey(const Message& message) {
  if (std::holds_alternative<vehicle::mrv2::Ask>(message)) say_identity();
  if (std::holds_alternative<vehicle::mrv2::Stop>(message)) drive.reset();
  const auto* const told = std::get_if<Drive>(&message);
  if (told == nullptr || told->boot != boot) return;
  const auto left = static_cast<std::int32_t>(told->good_until - clock());
  if (left <= 0) return;  // it was under way for too long
  drive = *told;
  drive_ends = time + std::min(left / 1000.0, spec.watchdog);
}

void Mrv2Model::Parts::say_identity() {
  say(vehicle::mrv2::Identity{boot, spec.lurches, kRadius, spec.max_speed, spec.max_turn_rate,
                              spec.max_acceleration, spec.watchdog, kSensors, spec.sonar.range,
                              spec.sonar.nearest, spec.sonar.beam_width});
}

void Mrv2Model::Parts::say_state() {
  const Truth truth = body.truth();
  const double charge = std::max(0.0, 1.0 - worked / kEmptyAfter);
  vehicle::mrv2::State state;
  state.boot = boot;
  state.time = clock();
  state.pose = body.counted();
  state.speed = truth.speed;
  state.turn_rate = truth.turn_rate;
  state.flags = stop_is_pressed ? vehicle::mrv2::State::kStopPressed : 0;
  state.charge = charge;
  state.voltage = kEmptyVoltage + (kFullVoltage - kEmptyVoltage) * charge;
  say(state);
}

void Mrv2Model::Parts::say_ranges() {
  say(vehicle::mrv2::Ranges{
      boot, clock(), heard(spec.sonar, body.truth().pose, kRadius, body.ranges(), body.walls(), random)});
}

/// Whether it stands between two lurches; a lurch begins with the first command after it stood for long
/// enough.
bool Mrv2Model::Parts::is_pausing(double dt) {
  if (!spec.lurches) return false;
  const bool is_told = drive.has_value() && (drive->speed != 0.0 || drive->turn_rate != 0.0);
  lurch_time = is_told || lurch_time > 0.0 ? lurch_time + dt : 0.0;
  const double whole = spec.lurch + spec.pause;
  if (lurch_time > whole) lurch_time = is_told ? lurch_time - whole : 0.0;
  return lurch_time > spec.lurch;
}

Mrv2Model::Mrv2Model(const overlay::Overlay& world, const Mrv2Spec& spec)
    : parts_(std::make_unique<Parts>(world, spec)) {
  restart();
}

Mrv2Model::~Mrv2Model() = default;

void Mrv2Model::receive(std::string_view bytes) {
  parts_->frames.add(bytes);
  while (const auto frame = parts_->frames.next()) {
    if (const auto message = vehicle::mrv2::message_of(*frame)) parts_->obey(*message);
  }
}

std::string Mrv2Model::step(double dt) {
  Parts& p = *parts_;
  p.time += dt;
  p.worked += dt;
  if (p.time >= p.drive_ends) p.drive.reset();
  const bool pauses = p.is_pausing(dt);
  const bool moves = p.drive.has_value() && !pauses && !p.stop_is_pressed;
  p.body.step(moves ? p.drive->speed : 0.0, moves ? p.drive->turn_rate : 0.0, dt);
  if (p.time - p.said_state >= kStateEvery - dt / 2) {
    p.say_state();
    p.said_state = p.time;
  }
  if (p.time - p.said_ranges >= kSonarsEvery - dt / 2) {
    p.say_ranges();
    p.said_ranges = p.time;
  }
  return std::exchange(p.says, {});
}

void Mrv2Model::restart() {
  Parts& p = *parts_;
  p.boot = static_cast<std::uint16_t>(p.random.bits());
  p.time = p.said_state = p.said_ranges = p.drive_ends = p.lurch_time = 0.0;
  p.drive.reset();
  p.frames.begin_anew();
  p.says.clear();
  p.body.count_from_here();
}

ModelVehicle::Truth Mrv2Model::truth() const {
  return parts_->body.truth();
}

void Mrv2Model::press_stop(bool is_pressed) {
  parts_->stop_is_pressed = is_pressed;
}

}  // namespace mlab::model_vehicles
