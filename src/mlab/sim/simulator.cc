#include "mlab/sim/simulator.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <ranges>

#include "mlab/base/angle.h"
#include "mlab/base/hash.h"
#include "mlab/base/random.h"
#include "mlab/sim/camera.h"
#include "mlab/sim/odometry.h"
#include "mlab/sim/simulator_parts.h"

namespace mlab::sim {
namespace {

using geom::Offset;
using geom::Point;

constexpr std::size_t kPiece = 256;
/// Of a body that nobody moves.
constexpr percept::Action kStands;
/// Nobody goes farther in one cycle [m].
constexpr double kLongestStep = 1e6;

class Stopwatch {
 public:
  explicit Stopwatch(bool is_on) : is_on_(is_on) { lap(); }
  /// Seconds since it was made or last asked; 0: it is off.
  double lap() {
    if (!is_on_) return 0.0;
    const auto now = std::chrono::steady_clock::now();
    const std::chrono::duration<double> passed = now - last_;
    last_ = now;
    return passed.count();
  }

 private:
  bool is_on_;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace

void Simulator::Parts::refresh() {
  if (!is_stale.load(std::memory_order_acquire)) return;
  const std::scoped_lock lock(refreshing);
  if (!is_stale.load(std::memory_order_relaxed)) return;
  const Bodies& bodies = state.bodies;
  items.clear();
  items.reserve(bodies.count());
  double widest = 0.0;
  for (std::uint32_t i = 0; i < bodies.count(); ++i) {
    if (!bodies.present[i]) continue;
    items.push_back({bodies.x[i], bodies.y[i], rounded_up(bodies.radius[i]), i});
    widest = std::max(widest, bodies.radius[i]);
  }
  reach = std::max(asked.exchange(0.0F, std::memory_order_relaxed), 0.5F * reach);
  grid.build(items, std::max({0.05, 2.0 * widest, PointGrid::cell_for(static_cast<double>(reach))}));
  state.objects.refresh();
  clear.resize(bodies.count());
  apart.resize(bodies.count());
  is_stale.store(false, std::memory_order_release);
}

std::uint32_t Simulator::Parts::kind_of(const BodySpec& spec) {
  const auto found = std::ranges::find_if(state.kinds, [&](const Kind& kind) { return kind.spec == spec; });
  if (found == state.kinds.end()) {
    state.kinds.push_back({spec, RingBeams(spec.ring, spec.radius)});
    has_odometry = has_odometry || spec.odometry_noise > 0.0;
    return static_cast<std::uint32_t>(state.kinds.size() - 1);
  }
  return static_cast<std::uint32_t>(found - state.kinds.begin());
}

/// What the body would do if nothing were in its way.
void Simulator::Parts::want(const percept::Action& action, std::uint32_t body, double dt) {
  Bodies& bodies = state.bodies;
  Offset& motion = contact.motions()[body];
  motion = {};
  if (!bodies.present[body] || bodies.is_guest[body]) return;
  const BodySpec& spec = state.kinds[bodies.kind[body]].spec;
  const Kinematics& kinematics = spec.kinematics;
  const WantedMotion wanted =
      drive(kinematics, action, bodies.heading[body], bodies.ahead[body], bodies.momentum[body], dt);
  motion = wanted.step;
  const double way = length(motion);
  if (!(way <= kLongestStep)) motion = std::isfinite(way) ? motion * (kLongestStep / way) : Offset{};
  bodies.momentum[body] = wanted.momentum;
  if (wanted.heading != bodies.heading[body]) {
    bodies.heading[body] = wanted.heading;
    bodies.ahead[body] = geom::ahead_of(wanted.heading);
  }
  if (action.looks) bodies.pan[body] = turned_camera(spec.camera, bodies.pan[body], action.pan, dt);
}

void Simulator::Parts::carry_out(const percept::Action& action, std::uint32_t body) {
  state.objects.carry_out(action, state.bodies, body);
  const int count = std::min<int>(action.request_count, percept::Action::kMaxRequests);
  for (int i = 0; i < count; ++i) {
    const percept::Request& request = action.requests[static_cast<std::size_t>(i)];
    const bool marks = request.kind == percept::Request::Kind::kMarkDoor;
    if (marks || request.kind == percept::Request::Kind::kUnmarkDoor)
      state.site.mark(request.object.value, marks, state.bodies.position(body), request.reach);
    if (request.kind == percept::Request::Kind::kLocalize) localize(request, body);
  }
}

/// Who counts its wheels goes on counting from what it was told; any other body is put there.
void Simulator::Parts::localize(const percept::Request& request, std::uint32_t body) {
  if (!is_inside(kWholeWorld, request.place) || !std::isfinite(request.heading)) return;
  Bodies& bodies = state.bodies;
  const double heading = base::wrap_angle(request.heading);
  if (counts_wheels(body)) {
    bodies.counted[body] = {request.place, heading};
    return;
  }
  placer.rebuild(bodies);
  const auto place = placer.nearest_free(bodies, *state.statics, request.place, bodies.radius[body],
                                         bodies.held[body] ? state.area : kWholeWorld, body);
  if (!place) return;
  bodies.put(body, {*place, heading}, {std::cos(heading), std::sin(heading)});
  bodies.momentum[body] = {};
  state.objects.follow(bodies);
}

void Simulator::Parts::count_wheels() {
  Bodies& bodies = state.bodies;
  for (std::uint32_t i = 0; i < bodies.count(); ++i) {
    if (!bodies.present[i] || !counts_wheels(i)) continue;
    const OdometryStep step{departure[i], {bodies.position(i), bodies.heading[i]}};
    base::Random random =
        base::Random::of(settings.seed, bodies.robot[i].value, base::hash_text("odometry"), state.cycle);
    bodies.counted[i] =
        counted(bodies.counted[i], step, state.kinds[bodies.kind[i]].spec.odometry_noise, random);
  }
}

Simulator::Simulator(World world, const SimulatorSettings& settings) {
  keep_usable(world);
  parts_ = std::make_unique<Parts>(std::move(world), settings);
}
Simulator::~Simulator() = default;

std::optional<Placement> Simulator::add_body(const BodySetup& setup) {
  Parts& p = *parts_;
  Bodies& bodies = p.state.bodies;
  const BodySpec spec = usable(setup.spec);
  geom::Pose pose = setup.pose;
  if (!std::isfinite(pose.heading)) pose.heading = 0.0;
  if (!is_inside(kWholeWorld, pose.position)) return std::nullopt;
  const bool is_held = is_inside(p.state.area, pose.position);
  if (p.is_placer_stale) p.placer.rebuild(bodies);
  p.is_placer_stale = false;
  const auto place = p.placer.nearest_free(bodies, *p.state.statics, pose.position, spec.radius,
                                           is_held ? p.state.area : kWholeWorld);
  if (!place) return std::nullopt;
  const auto index = static_cast<std::uint32_t>(bodies.count());
  bodies.x.push_back(place->x);
  bodies.y.push_back(place->y);
  bodies.heading.push_back(pose.heading);
  bodies.ahead.push_back({std::cos(pose.heading), std::sin(pose.heading)});
  bodies.radius.push_back(spec.radius);
  bodies.momentum.emplace_back();
  bodies.counted.push_back({*place, pose.heading});
  bodies.distance.push_back(0.0);
  bodies.contacts.push_back(0);
  bodies.run_over.push_back(0);
  bodies.touched.emplace_back();
  bodies.kind.push_back(p.kind_of(spec));
  bodies.robot.push_back(setup.robot);
  bodies.unit.push_back(setup.unit);
  bodies.seen_as.push_back(setup.seen_as);
  bodies.pan.push_back(0.0);
  bodies.carried.push_back(0);
  bodies.present.push_back(1);
  bodies.is_guest.push_back(0);
  bodies.held.push_back(is_held ? 1 : 0);
  p.placer.add(bodies, index);
  p.is_stale = true;
  const bool moved = !(*place == pose.position);
  return Placement{{index}, {*place, pose.heading}, moved};
}

void Simulator::remove_body(BodyIndex body) {
  Parts& p = *parts_;
  p.state.objects.drop(p.state.bodies, body.value);
  p.state.bodies.present[body.value] = 0;
  p.state.bodies.momentum[body.value] = {};
  p.is_stale = true;
  p.is_placer_stale = true;
}

std::size_t Simulator::body_count() const {
  return parts_->state.bodies.count();
}
bool Simulator::is_present(BodyIndex body) const {
  return parts_->state.bodies.present[body.value] != 0;
}
geom::Pose Simulator::pose(BodyIndex body) const {
  const Bodies& bodies = parts_->state.bodies;
  return {bodies.position(body.value), bodies.heading[body.value]};
}
base::RobotId Simulator::robot(BodyIndex body) const {
  return parts_->state.bodies.robot[body.value];
}
const BodySpec& Simulator::spec(BodyIndex body) const {
  return parts_->state.kinds[parts_->state.bodies.kind[body.value]].spec;
}
const binding::Momentum& Simulator::momentum(BodyIndex body) const {
  return parts_->state.bodies.momentum[body.value];
}

Offset Simulator::velocity(BodyIndex body) const {
  return parts_->state.bodies.momentum[body.value].velocity;
}
double Simulator::pan(BodyIndex body) const {
  return parts_->state.bodies.pan[body.value];
}
double Simulator::distance_driven(BodyIndex body) const {
  return parts_->state.bodies.distance[body.value];
}
std::uint32_t Simulator::contacts(BodyIndex body) const {
  return parts_->state.bodies.contacts[body.value];
}
std::uint32_t Simulator::run_over(BodyIndex body) const {
  return parts_->state.bodies.run_over[body.value];
}
bool Simulator::in_contact(BodyIndex body) const {
  const auto& until = parts_->state.bodies.touched[body.value].until;
  return std::ranges::any_of(until, [&](double end) { return end > parts_->state.time; });
}
base::ObjectId Simulator::carried(BodyIndex body) const {
  const std::uint32_t carried = parts_->state.bodies.carried[body.value];
  return carried == 0 ? base::ObjectId{} : objects()[carried - 1].id;
}
void Simulator::set_unit(BodyIndex body, std::uint32_t unit) {
  parts_->state.bodies.unit[body.value] = unit;
}

void Simulator::put_body(BodyIndex body, const geom::Pose& pose, geom::Offset velocity, double turn_rate) {
  if (!is_inside(kWholeWorld, pose.position)) return;
  Bodies& bodies = parts_->state.bodies;
  const std::uint32_t i = body.value;
  const geom::Offset ahead{std::cos(pose.heading), std::sin(pose.heading)};
  // From where it was thought to be it has not driven.
  if (bodies.is_guest[i]) bodies.distance[i] += distance(bodies.position(i), pose.position);
  bodies.is_guest[i] = 1;
  bodies.put(i, pose, ahead);
  bodies.counted[i] = pose;
  bodies.momentum[i] = {velocity, dot(velocity, ahead), turn_rate};
  parts_->is_stale = true;
  parts_->is_placer_stale = true;
}

void Simulator::sense(BodyIndex body, const percept::Needs& needs, SenseBuffer& buffer,
                      percept::Percepts& out) const {
  const binding::Sensing one{body, &needs, &out};
  sense({&one, 1}, {&buffer, 1});
}

void Simulator::sense(std::span<const binding::Sensing> bodies, std::span<SenseBuffer> buffers) const {
  parts_->refresh();
  const Sensors::Scene scene = parts_->scene();
  for (std::size_t i = 0; i < bodies.size(); ++i) parts_->sense(scene, bodies[i], buffers[i]);
}

void Simulator::Parts::sense(const Sensors::Scene& scene, const binding::Sensing& wanted,
                             SenseBuffer& buffer) {
  const Bodies& bodies = state.bodies;
  const std::uint32_t i = wanted.body.value;
  const BodySpec& spec = state.kinds[bodies.kind[i]].spec;
  const percept::Needs& needs = *wanted.needs;
  percept::Percepts& out = *wanted.out;
  out.pose = counts_wheels(i) ? bodies.counted[i] : geom::Pose{bodies.position(i), bodies.heading[i]};
  // Whoever looks at what it senses turns it by that, mostly.
  geom::remember({bodies.heading[i], bodies.ahead[i]});
  out.map = state.site.map();
  out.time = state.time;
  Sensors::forget(out);
  out.camera = {bodies.pan[i], spec.camera.field_of_view};
  const std::uint32_t carried = bodies.carried[i];
  out.carried = carried == 0 ? base::ObjectId{} : state.objects.list()[carried - 1].id;
  out.carried_class =
      carried == 0 ? percept::ObjectClass::kUnknown : state.objects.list()[carried - 1].object_class;
  Sensors sensors(scene, i, buffer);
  using percept::Sensor;
  const bool uses_ring =
      needs.has(Sensor::kRanges) || (needs.has(Sensor::kObstacles) && spec.has_ring_obstacles);
  const double ring = uses_ring ? spec.ring.range : 0.0;
  note_reach(
      static_cast<float>(usable_range(std::max({needs[Sensor::kRobots], needs[Sensor::kObjects], ring}))));
  for (std::size_t number = 0; number < percept::kSensors.size(); ++number) {
    const auto sensor = static_cast<Sensor>(number);
    if (needs.has(sensor)) sensors.sense(sensor, usable_range(needs[sensor]), out);
  }
}

void Simulator::sense_at(BodyIndex body, const geom::Pose& pose, const percept::Needs& needs,
                         SenseBuffer& buffer, percept::Percepts& out) const {
  parts_->refresh();
  Bodies& bodies = parts_->state.bodies;
  const std::uint32_t i = body.value;
  const geom::Pose stands = this->pose(body);
  const geom::Offset ahead = bodies.ahead[i];
  bodies.put(i, pose, {std::cos(pose.heading), std::sin(pose.heading)});
  sense(body, needs, buffer, out);
  parts_->apart[i] = {};
  bodies.put(i, stands, ahead);
  out.pose = pose;
}

const binding::RadioLinks* Simulator::radio() {
  const auto is_perfect = [](const Kind& kind) { return kind.spec.radio.is_perfect(); };
  if (parts_->state.silences->empty() && std::ranges::all_of(parts_->state.kinds, is_perfect)) return nullptr;
  for (const Kind& kind : parts_->state.kinds) parts_->note_reach(static_cast<float>(kind.spec.radio.range));
  parts_->refresh();
  parts_->radio.link(parts_->scene());
  return &parts_->radio;
}

void Simulator::step(std::span<const percept::Action> actions, double dt) {
  Parts& p = *parts_;
  Bodies& bodies = p.state.bodies;
  Stopwatch watch(p.settings.measures_times);
  p.refresh();
  p.contact.resize(bodies.count());
  if (p.has_odometry) {
    p.departure.resize(bodies.count());
    for (std::uint32_t i = 0; i < bodies.count(); ++i) p.departure[i] = pose(BodyIndex{i});
  }
  std::atomic<bool> has_requests = false;
  p.workers.run(bodies.count(), kPiece, [&](std::size_t begin, std::size_t end, int) {
    bool any = false;
    for (std::size_t i = begin; i < end; ++i) {
      const percept::Action& action = i < actions.size() ? actions[i] : kStands;
      p.want(action, static_cast<std::uint32_t>(i), dt);
      any = any || action.request_count > 0;
    }
    if (any) has_requests = true;
  });
  p.times.move += watch.lap();

  const double until = p.state.time + dt;
  p.contact.move(
      bodies,
      {*p.state.statics, p.grid, p.state.area, until, dt, p.roaming.move(*p.state.roamers, until), p.apart},
      p.workers);
  p.times.contact += watch.lap();

  p.state.objects.follow(bodies);
  p.state.objects.travel(until);
  if (p.has_odometry) p.count_wheels();
  if (has_requests) {
    p.by_robot.resize(bodies.count());
    for (std::uint32_t i = 0; i < bodies.count(); ++i) p.by_robot[i] = i;
    std::ranges::sort(p.by_robot, [&](std::uint32_t a, std::uint32_t b) {
      return bodies.robot[a] != bodies.robot[b] ? bodies.robot[a] < bodies.robot[b] : a < b;
    });
    for (const std::uint32_t i : p.by_robot) {
      if (bodies.present[i] && i < actions.size()) p.carry_out(actions[i], i);
    }
  }
  p.state.time += dt;
  ++p.state.cycle;
  p.is_stale = true;
  p.is_placer_stale = true;
  p.refresh();
  p.times.move += watch.lap();
}

double Simulator::time() const {
  return parts_->state.time;
}
std::uint64_t Simulator::cycle() const {
  return parts_->state.cycle;
}
StepTimes Simulator::step_times() const {
  return parts_->times;
}
Workers& Simulator::workers() const {
  return parts_->workers;
}

std::span<const Disc> Simulator::discs() const {
  return parts_->state.statics->discs();
}
std::span<const MovingDisc> Simulator::moving_discs() const {
  return parts_->roaming.discs();
}
std::span<const Wall> Simulator::walls() const {
  return parts_->state.statics->walls();
}
std::span<const Object> Simulator::objects() const {
  return parts_->state.objects.list();
}
std::uint32_t Simulator::basket_count(base::ObjectId container) const {
  return parts_->state.objects.count_in(container);
}

}  // namespace mlab::sim
