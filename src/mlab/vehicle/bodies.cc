#include "mlab/vehicle/bodies.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/angle.h"
#include "mlab/text/shown.h"
#include "mlab/vehicle/earth.h"
#include "mlab/vehicle/messages.h"
#include "mlab/vehicle/state.h"

namespace mlab::vehicle {
namespace {

using binding::BodyIndex;

constexpr double kSilencePatience = 5.0;  // [s]
constexpr double kReadyPatience = 10.0;   // [s]
constexpr double kFixPatience = 2.0;      // that it has not said where on the Earth it is [s]
constexpr std::size_t kLongestKind = 64;  // characters
constexpr std::size_t kLongestRefusal = 200;
constexpr double kMovedBy = 0.5;  // from where the mission has it start, that is told [m]

// Where something stands that stands there in the frame.
geom::Pose in_world(const geom::Pose& frame, const geom::Pose& pose) {
  const geom::Offset from = frame.to_world({pose.position.x, pose.position.y, 0.0});
  return {frame.position + from, base::wrap_angle(frame.heading + pose.heading)};
}

// The frame in which `pose` is there in the world.
geom::Pose frame_with(const geom::Pose& pose, const geom::Pose& there) {
  geom::Pose out;
  out.heading = base::wrap_angle(there.heading - pose.heading);
  out.position = there.position - out.to_world({pose.position.x, pose.position.y, 0.0});
  return out;
}

// The pose in the frame of what is there in the world.
geom::Pose in_frame(const geom::Pose& frame, const geom::Pose& there) {
  const geom::Vector from = frame.to_robot(there.position);
  return {{from.x, from.y}, base::wrap_angle(there.heading - frame.heading)};
}

std::string refusal_of(const Crewed& crewed) {
  return "says limits that can't be: " + crewed.refusal;
}

const std::string& kind_of(const Crewed& crewed) {
  return crewed.kind.empty() ? crewed.name : crewed.kind;
}

}  // namespace

Bodies::Bodies(std::unique_ptr<binding::Binding> others, std::vector<Crewed> vehicles, std::uint64_t session,
               const std::optional<geography::Projection>& map)
    : others_(std::move(others)), session_(session), map_(map) {
  for (Crewed& one : vehicles) {
    vehicles_.push_back(std::make_unique<Vehicle>());
    vehicles_.back()->crewed = std::move(one);
  }
}

Bodies::~Bodies() {
  for (const auto& one : vehicles_) {
    if (one->now.body != binding::kNoBody) release(one->now.body);
  }
}

Bodies::Vehicle* Bodies::of(BodyIndex body) const {
  return body.value < by_body_.size() ? by_body_[body.value] : nullptr;
}

Bodies::Vehicle* Bodies::of(std::string_view name) const {
  const auto at = std::ranges::find_if(vehicles_, [&](const auto& one) { return one->crewed.name == name; });
  return at == vehicles_.end() ? nullptr : at->get();
}

// ---- bodies

std::expected<binding::Placement, std::string> Bodies::embody(const binding::BodySetup& setup) {
  Vehicle* const vehicle = setup.vehicle.empty() ? nullptr : of(setup.vehicle);
  if (vehicle == nullptr) return others_->embody(setup);
  State& state = vehicle->now;
  if (!vehicle->crewed.refusal.empty())
    return std::unexpected(fmt::format("its vehicle `{}` {}", setup.vehicle, refusal_of(vehicle->crewed)));
  if (state.body != binding::kNoBody)
    return std::unexpected(fmt::format("another robot has the vehicle `{}`", setup.vehicle));
  if (state.number == 0 || seconds_between(state.heard, now()) > kSilencePatience)
    return std::unexpected(fmt::format("nothing is heard of its vehicle `{}`", setup.vehicle));
  if (!state.motion || !state.report.motion)
    return std::unexpected(fmt::format("its vehicle `{}` does not say where it is: it {}", setup.vehicle,
                                       why_not_ready(state.report)));
  if (!knows_its_place(state)) state.frame = frame_with(state.motion->pose, setup.pose);
  binding::BodySetup out = setup;
  out.vehicle.clear();
  out.pose = pose_of(state);
  out.spec.radius = vehicle->crewed.limits.radius;
  out.spec.kinematics = vehicle->crewed.limits.kinematics;
  out.spec.ring = {};
  out.spec.has_ring_obstacles = false;
  out.spec.odometry_noise = 0.0;
  auto placement = others_->embody(out);
  if (!placement) return placement;
  state.body = placement->body;
  state.unready_since.reset();
  ++state.engagement;
  by_body_.resize(std::max<std::size_t>(by_body_.size(), state.body.value + std::size_t{1}));
  by_body_[state.body.value] = vehicle;
  put(state);
  placement->pose = out.pose;
  placement->moved = geom::distance(out.pose.position, setup.pose.position) > kMovedBy;
  return placement;
}

void Bodies::release(BodyIndex body) {
  if (Vehicle* const vehicle = of(body)) {
    wire::VehicleCommand leave;
    leave.set_session(session_);
    leave.set_number(++vehicle->now.told);
    leave.set_period(1.0);
    leave.set_leaves(true);
    if (vehicle->crewed.line) vehicle->crewed.line->tell(leave);
    vehicle->now.body = binding::kNoBody;
    by_body_[body.value] = nullptr;
  }
  others_->release(body);
}

binding::Capabilities Bodies::capabilities(BodyIndex body) const {
  binding::Capabilities out = others_->capabilities(body);
  const Vehicle* const vehicle = of(body);
  if (vehicle == nullptr) return out;
  const Limits& limits = vehicle->crewed.limits;
  out.radius = limits.radius;
  out.range_sensors = static_cast<std::uint16_t>(std::min<std::size_t>(vehicle->now.ranges.size(), 0xffff));
  out.max_speed = limits.kinematics.max_speed;
  out.max_turn_rate = limits.kinematics.max_turn_rate;
  out.kinematics = limits.kinematics;
  out.overlooks = true;
  return out;
}

std::string Bodies::ailment_of(Vehicle& vehicle) const {
  State& state = vehicle.now;
  const std::string& name = vehicle.crewed.name;
  if (const double silent = seconds_between(state.heard, now()); silent > kSilencePatience)
    return fmt::format("is the vehicle `{}`, of which nothing was heard for {:.0f} s", name, silent);
  const bool is_anothers = state.held_by != 0 && state.held_by != session_;
  const bool is_well = state.report.readiness == Readiness::kReady && state.report.motion && !is_anothers;
  if (is_well || !state.is_to_drive || state.is_stopped) {
    state.unready_since.reset();
    return "";
  }
  if (!state.unready_since) state.unready_since = now();
  if (seconds_between(*state.unready_since, now()) <= kReadyPatience) return "";
  if (is_anothers) return fmt::format("is the vehicle `{}`, which another run drives", name);
  return fmt::format("is the vehicle `{}`, which {}", name,
                     state.report.motion || state.report.readiness != Readiness::kReady
                         ? why_not_ready(state.report)
                         : "does not say where it is any more");
}

void Bodies::health(std::vector<binding::Ailment>& out) {
  others_->health(out);
  for (const auto& one : vehicles_) {
    if (one->now.body == binding::kNoBody) continue;
    std::string what = ailment_of(*one);
    if (!what.empty()) out.push_back({one->now.body, std::move(what)});
  }
}

// ---- what vehicles say

// Of the run, as a clock has it: whatever is computed with it comes out the same when it is taken again.
Clock::time_point Bodies::now() const {
  return Clock::time_point(
      std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time())));
}

void Bodies::hear(std::vector<binding::Heard>& out) {
  others_->hear(out);
  for (const auto& one : vehicles_) {
    auto said = one->crewed.line ? one->crewed.line->hear() : std::nullopt;
    if (said) out.push_back({one->crewed.name, std::move(*said)});
  }
}

void Bodies::take(const binding::Heard& heard) {
  Vehicle* const vehicle = of(heard.vehicle);
  if (vehicle == nullptr) {
    others_->take(heard);
    return;
  }
  wire::VehicleReport message;
  if (!message.ParseFromString(heard.said) || message.number() == 0) return;
  const auto report = decode(message, now());
  // A process that was started anew counts from the beginning.
  if (!report || message.number() == vehicle->now.number) return;
  vehicle->now.number = message.number();
  vehicle->now.held_by = message.held_by();
  vehicle->now.is_stopped = message.is_stopped();
  take(*vehicle, *report);
  if (message.held_by() == session_) note_trip(vehicle->now, message.command());
}

// Where its odometry begins is known by where one point of it is on the Earth, and by where north is there.
void Bodies::fix(State& state) const {
  Report& report = state.report;
  if (report.is_global) {
    state.frame = {};
    state.fixed_at.reset();
  } else if (report.fix && map_) {
    const geom::Point there = map_->to_world(report.fix->place);
    const double turned = north_at(*map_, report.fix->place) - report.fix->north;
    state.frame = frame_with({report.fix->point, 0.0}, {there, turned});
    state.fixed_at = now();
  } else if (state.fixed_at && seconds_between(*state.fixed_at, now()) > kFixPatience) {
    report.motion.reset();  // it may count from elsewhere by now
  }
}

void Bodies::take(Vehicle& vehicle, Report said) {
  State& state = vehicle.now;
  state.report = std::move(said);
  state.heard = now();
  if (!state.first) state.first = state.heard;
  fix(state);
  const Report& report = state.report;
  if (report.battery) state.battery = report.battery;
  if (!report.motion) return;
  state.motion = report.motion;
  state.ranges.clear();
  state.range_limit = 0.0;
  for (const Scan& scan : report.scans) {
    state.map.add(scan, scan.pose.value_or(report.motion->pose));
    state.range_limit = std::max(state.range_limit, scan.farthest);
    // Beams of a sensor that stands on the edge of the body, as most do, begin there.
    const double inside = vehicle.crewed.limits.radius - geom::length(scan.mount.position - geom::Point{});
    for (std::size_t i = 0; i < scan.distances.size(); ++i) {
      const float distance = scan.distances[i];
      if (std::isnan(distance)) continue;  // nothing is known there
      const double angle = scan.mount.heading + scan.first_angle + scan.step * static_cast<double>(i);
      const bool is_hit = std::isfinite(distance) && distance <= scan.farthest;
      const double to_surface = std::max(0.0, (is_hit ? distance : scan.farthest) - inside);
      state.ranges.push_back(
          {static_cast<float>(base::wrap_angle(angle)), static_cast<float>(to_surface), is_hit});
    }
  }
  state.map.age(report.motion->pose, state.heard);
  if (state.body != binding::kNoBody) put(state);
}

// It carries out the newest that has come, so how long ago it was told that is the way there and back.
void Bodies::note_trip(State& state, std::uint64_t command) {
  const bool is_known = command != 0 && command <= state.told && state.told - command < state.told_at.size();
  if (!is_known) state.trip.reset();
  if (!is_known || command == state.answered) return;
  state.answered = command;
  state.trip = seconds_between(state.told_at[command % state.told_at.size()], state.heard);
}

geom::Pose Bodies::pose_of(const State& state) {
  return in_world(state.frame, state.motion->pose);
}

void Bodies::put(const State& state) {
  const geom::Pose pose = pose_of(state);
  others_->place(state.body, pose, pose.to_world({state.motion->speed, 0.0, 0.0}), state.motion->turn_rate);
}

// ---- what is told of them

binding::BodyState Bodies::body(BodyIndex body) const {
  binding::BodyState out = others_->view().body(body);
  const Vehicle* const vehicle = of(body);
  if (vehicle == nullptr) return out;
  const State& state = vehicle->now;
  binding::Upkeep& upkeep = out.upkeep.emplace();
  upkeep.motion_age = std::max(0.0, seconds_between(state.motion->at, now()));
  if (state.battery) upkeep.battery = state.battery->share;
  const Clock::time_point known = state.battery ? state.battery->at : state.first.value_or(now());
  upkeep.battery_age = std::max(0.0, seconds_between(known, now()));
  return out;
}

binding::VehicleState::Driver Bodies::driver_of(const State& state) const {
  using Driver = binding::VehicleState::Driver;
  if (state.held_by == 0) return Driver::kNobody;
  return state.held_by == session_ ? Driver::kThisRun : Driver::kAnotherRun;
}

std::optional<binding::VehicleState> Bodies::vehicle(std::string_view name) const {
  const Vehicle* const found = of(name);
  if (found == nullptr) return others_->vehicle(name);
  const State& state = found->now;
  const auto age = [&](Clock::time_point at) { return std::max(0.0, seconds_between(at, now())); };
  binding::VehicleState out;
  const bool is_known = state.number != 0;
  if (is_known) out = state_of(state.report, now());
  out.name = found->crewed.name;
  out.kind = kind_of(found->crewed);
  out.number = state.number;
  out.age = age(state.heard);
  if (!found->crewed.refusal.empty()) {
    out.why = refusal_of(found->crewed);
    if (is_known) out.readiness = binding::VehicleState::Readiness::kFaulty;
  }
  if (!is_known) return out;
  out.trip = state.trip;
  out.driver = driver_of(state);
  out.is_stopped = state.is_stopped;
  if (state.battery) out.battery = {state.battery->share, state.battery->voltage, age(state.battery->at)};
  return out;
}

// ---- the cycle

void Bodies::sense_around(State& state, const geom::Pose& at, const percept::Needs& needs,
                          percept::Percepts& out) {
  using percept::Sensor;
  out.objects = {};
  out.touch = {};
  out.carried = {};
  out.obstacles = {};
  out.ranges = {};
  if (needs.has(Sensor::kObstacles))
    out.obstacles = state.map.obstacles(at, needs[Sensor::kObstacles], out.robots);
}

void Bodies::sense_with(State& state, const percept::Needs& needs, percept::Percepts& out) {
  sense_around(state, state.motion->pose, needs, out);
  if (!needs.has(percept::Sensor::kRanges)) return;
  out.ranges = state.ranges;
  out.range_limit = state.range_limit;
}

void Bodies::percepts(std::span<const binding::Sensing> robots, int worker) {
  others_->percepts(robots, worker);
  for (const binding::Sensing& one : robots) {
    if (Vehicle* const vehicle = of(one.body)) sense_with(vehicle->now, *one.needs, *one.out);
  }
}

percept::Percepts Bodies::sense(BodyIndex body, const percept::Needs& needs) const {
  percept::Percepts out = others_->view().sense(body, needs);
  if (Vehicle* const vehicle = of(body)) sense_with(vehicle->now, needs, out);
  return out;
}

percept::Percepts Bodies::sense_at(BodyIndex body, const geom::Pose& pose,
                                   const percept::Needs& needs) const {
  percept::Percepts out = others_->view().sense_at(body, pose, needs);
  if (Vehicle* const vehicle = of(body))
    sense_around(vehicle->now, in_frame(vehicle->now.frame, pose), needs, out);
  return out;
}

void Bodies::command(Vehicle& vehicle, const percept::Action& action, double dt) const {
  wire::VehicleCommand out;
  out.set_session(session_);
  out.set_number(++vehicle.now.told);
  vehicle.now.told_at[vehicle.now.told % vehicle.now.told_at.size()] = now();
  out.set_answers(vehicle.now.number);
  out.set_drives(action.drives);
  out.set_velocity_x(action.velocity.x);
  out.set_velocity_y(action.velocity.y);
  out.set_spins(action.spins);
  out.set_spin(action.spin);
  out.set_period(dt);
  out.set_engagement(vehicle.now.engagement);
  vehicle.now.is_to_drive = action.drives;
  if (vehicle.crewed.line) vehicle.crewed.line->tell(out);
}

void Bodies::carry_out(std::span<const percept::Action> actions, double dt) {
  actions_.assign(actions.begin(), actions.end());
  for (const auto& one : vehicles_) {
    State& state = one->now;
    if (state.body == binding::kNoBody || state.body.value >= actions_.size()) continue;
    percept::Action& action = actions_[state.body.value];
    command(*one, action, dt);
    for (std::uint8_t i = 0; i < action.request_count; ++i) {
      const percept::Request& request = action.requests[i];
      if (request.kind == percept::Request::Kind::kLocalize && !knows_its_place(state))
        state.frame = frame_with(state.motion->pose, {request.place, base::wrap_angle(request.heading)});
    }
    action = {};
  }
  others_->carry_out(actions_, dt);
  for (const auto& one : vehicles_) {
    if (one->now.body != binding::kNoBody) put(one->now);
  }
}

std::vector<std::optional<geom::Pose>> Bodies::places_for(std::span<const binding::BodySetup> setups) {
  std::vector<std::optional<geom::Pose>> out = others_->places_for(setups);
  for (std::size_t i = 0; i < setups.size(); ++i) {
    const Vehicle* const vehicle = of(setups[i].vehicle);
    if (vehicle == nullptr) continue;
    const State& state = vehicle->now;
    out[i] = state.motion && knows_its_place(state) ? pose_of(state) : setups[i].pose;
  }
  return out;
}

// ---- checkpoints

class Bodies::KeptBodies final : public binding::Binding::Kept {
 public:
  KeptBodies(std::shared_ptr<const Kept> others, std::vector<State> vehicles)
      : others_(std::move(others)), vehicles_(std::move(vehicles)) {}
  std::size_t bytes() const override { return others_->bytes() + vehicles_.size() * sizeof(State); }
  const Kept& others() const { return *others_; }
  const std::vector<State>& vehicles() const { return vehicles_; }

 private:
  std::shared_ptr<const Kept> others_;
  std::vector<State> vehicles_;
};

std::expected<std::shared_ptr<const binding::Binding::Kept>, std::string> Bodies::save() const {
  if (std::ranges::any_of(vehicles_, [](const auto& one) { return one->crewed.line != nullptr; }))
    return Binding::save();
  auto others = others_->save();
  if (!others) return others;
  std::vector<State> states;
  for (const auto& one : vehicles_) states.push_back(one->now);
  return std::make_shared<const KeptBodies>(std::move(*others), std::move(states));
}

bool Bodies::restore(const Kept& kept) {
  const auto* const before = dynamic_cast<const KeptBodies*>(&kept);
  if (before == nullptr || before->vehicles().size() != vehicles_.size() ||
      !others_->restore(before->others()))
    return false;
  by_body_.assign(by_body_.size(), nullptr);
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    vehicles_[i]->now = before->vehicles()[i];
    const BodyIndex body = vehicles_[i]->now.body;
    if (body == binding::kNoBody) continue;
    by_body_.resize(std::max<std::size_t>(by_body_.size(), body.value + std::size_t{1}));
    by_body_[body.value] = vehicles_[i].get();
  }
  return true;
}

// ---- recorded runs

std::vector<std::string> Bodies::vehicles() const {
  std::vector<std::string> out;
  for (const auto& one : vehicles_) {
    wire::RecordedVehicle told;
    told.set_name(one->crewed.name);
    *told.mutable_said() = offered(kind_of(one->crewed), one->crewed.limits);
    told.set_session(session_);
    told.set_refusal(one->crewed.refusal);
    out.push_back(told.SerializeAsString());
  }
  return out;
}

std::unique_ptr<binding::Binding> recorded_bodies(std::unique_ptr<binding::Binding> others,
                                                  const std::vector<std::string>& vehicles,
                                                  const std::optional<geography::Projection>& map) {
  std::vector<Crewed> crewed;
  std::uint64_t session = 1;
  wire::RecordedVehicle told;
  for (const std::string& bytes : vehicles) {
    if (!told.ParseFromString(bytes)) continue;
    const auto limits = limits_of(told.said());
    if (!limits && told.refusal().empty()) continue;
    crewed.push_back({told.name(), limits.value_or(Limits()), nullptr,
                      text::shown(told.said().kind(), kLongestKind),
                      text::shown(told.refusal(), kLongestRefusal)});
    session = told.session();
  }
  return std::make_unique<Bodies>(std::move(others), std::move(crewed), session, map);
}

std::set<std::string, std::less<>> recorded_names(const std::vector<std::string>& vehicles) {
  std::set<std::string, std::less<>> out;
  wire::RecordedVehicle told;
  for (const std::string& bytes : vehicles) {
    if (told.ParseFromString(bytes)) out.insert(told.name());
  }
  return out;
}

}  // namespace mlab::vehicle
