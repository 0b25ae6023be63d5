#include "mlab/sim/simulator.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <ranges>

#include "mlab/base/angle.h"
#include "mlab/base/hash.h"
#include "mlab/base/random.h"
#include "mlab/sim/camera.h"
#include "mlab/sim/contact.h"
#include "mlab/sim/objects.h"
#include "mlab/sim/odometry.h"
#include "mlab/sim/placement.h"
#include "mlab/sim/roaming.h"
#include "mlab/sim/sensors.h"
#include "mlab/sim/touched.h"

namespace mlab::sim {
namespace {

using geom::Offset;
using geom::Point;

constexpr std::size_t kPiece = 256;
/// That the properties of a body take up in all of its arrays.
constexpr std::size_t kBytesOfBody = 5 * sizeof(double) + sizeof(Offset) + sizeof(binding::Momentum) +
                                     sizeof(geom::Pose) + sizeof(Touched) + 7 * sizeof(std::uint32_t) +
                                     sizeof(percept::ObjectClass) + 2 * sizeof(std::uint8_t);
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

/// What a snapshot holds.
class Simulator::State {
 public:
  Bodies bodies;
  Objects objects;
  Site site;
  std::shared_ptr<const Statics> statics;
  std::shared_ptr<const std::vector<Roamer>> roamers;
  std::shared_ptr<const std::vector<Outline>> silences;
  Box area;                 ///< where the centres of held bodies may be
  std::vector<Kind> kinds;  ///< of bodies
  double time = 0.0;
  std::uint64_t cycle = 0;
};

struct Simulator::Parts {
  Parts(World world, const SimulatorSettings& chosen)
      : settings(chosen),
        workers(chosen.threads),
        state{{},
              Objects(std::move(world.objects), world.travels),
              Site(std::move(world.building)),
              std::make_shared<const Statics>(std::move(world.discs), std::move(world.walls)),
              std::make_shared<const std::vector<Roamer>>(std::move(world.roamers)),
              std::make_shared<const std::vector<Outline>>(std::move(world.silences)),
              {world.area_low.x + kAreaMargin, world.area_low.y + kAreaMargin,
               world.area_high.x - kAreaMargin, world.area_high.y - kAreaMargin},
              {}} {
    place_roamers();
  }

  /// Where roamers are now.
  void place_roamers() {
    roaming.place(*state.roamers, state.time);
    placer.keep_free_of(roaming.discs());
  }
  /// Sorts bodies and objects anew where they moved since. Whichever thread comes first does it.
  void refresh();
  /// Notes how far somebody asks for robots [m].
  void note_reach(float asked_now) {
    float before = asked.load(std::memory_order_relaxed);
    while (before < asked_now && !asked.compare_exchange_weak(before, asked_now, std::memory_order_relaxed)) {
    }
  }
  Sensors::Scene scene() const {
    return {state.bodies,  grid,        *state.statics,  state.objects,  state.kinds,
            settings.seed, state.cycle, roaming.discs(), *state.silences};
  }
  std::uint32_t kind_of(const BodySpec& spec);
  void want(const percept::Action& action, std::uint32_t body, double dt);
  bool counts_wheels(std::uint32_t body) const {
    return state.kinds[state.bodies.kind[body]].spec.odometry_noise > 0.0;
  }
  void carry_out(const percept::Action& action, std::uint32_t body);
  void localize(const percept::Request& request, std::uint32_t body);
  void count_wheels();
  std::vector<Placement> replace_statics(std::vector<Disc> discs, std::vector<Wall> walls);

  SimulatorSettings settings;
  Workers workers;
  State state;
  std::vector<std::uint32_t> by_robot;  ///< body indices in the order of robot ids
  bool has_odometry = false;            ///< some kind counts its wheels
  std::vector<geom::Pose> departure;    ///< of all bodies, before they move; where has_odometry
  Roaming roaming;
  Radio radio;
  PointGrid grid;
  std::vector<PointGrid::Item> items;
  std::atomic<float> asked{0.0F};  ///< the farthest that robots were looked for since the grid was built [m]
  float reach = 0.0F;              ///< the same over some cycles, for the size of its cells
  std::atomic<bool> is_stale{true};
  std::mutex refreshing;
  Placer placer;
  bool is_placer_stale = true;
  ContactSolver contact;
  StepTimes times;
};

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
    bodies.ahead[body] = {std::cos(wanted.heading), std::sin(wanted.heading)};
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
  parts_->refresh();
  const State& state = parts_->state;
  const Bodies& bodies = state.bodies;
  const std::uint32_t i = body.value;
  out.pose = parts_->counts_wheels(i) ? bodies.counted[i] : pose(body);
  out.map = state.site.map();
  out.time = state.time;
  Sensors::forget(out);
  out.camera = {bodies.pan[i], spec(body).camera.field_of_view};
  const std::uint32_t carried = bodies.carried[i];
  out.carried = carried == 0 ? base::ObjectId{} : state.objects.list()[carried - 1].id;
  out.carried_class =
      carried == 0 ? percept::ObjectClass::kUnknown : state.objects.list()[carried - 1].object_class;
  const Sensors::Scene scene = parts_->scene();
  Sensors sensors(scene, i, buffer);
  using percept::Sensor;
  const bool uses_ring =
      needs.has(Sensor::kRanges) || (needs.has(Sensor::kObstacles) && spec(body).has_ring_obstacles);
  const double ring = uses_ring ? spec(body).ring.range : 0.0;
  parts_->note_reach(
      static_cast<float>(usable_range(std::max({needs[Sensor::kRobots], needs[Sensor::kObjects], ring}))));
  for (const percept::SensorInfo& sensor : percept::kSensors) {
    if (needs.has(sensor.sensor)) sensors.sense(sensor.sensor, usable_range(needs[sensor.sensor]), out);
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
      const percept::Action& action = i < actions.size() ? actions[i] : percept::Action{};
      p.want(action, static_cast<std::uint32_t>(i), dt);
      any = any || action.request_count > 0;
    }
    if (any) has_requests = true;
  });
  p.times.move += watch.lap();

  const double until = p.state.time + dt;
  p.contact.move(bodies,
                 {*p.state.statics, p.grid, p.state.area, until, dt, p.roaming.move(*p.state.roamers, until)},
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

/// Other things that stand still; whoever stands in one is put beside it.
std::vector<Placement> Simulator::Parts::replace_statics(std::vector<Disc> discs, std::vector<Wall> walls) {
  World world;
  world.discs = std::move(discs);
  world.walls = std::move(walls);
  keep_usable(world);
  const std::shared_ptr<const Statics> before = state.statics;
  state.statics = std::make_shared<const Statics>(std::move(world.discs), std::move(world.walls));
  Bodies& bodies = state.bodies;
  forget_changed(bodies, *before, *state.statics, state.time);
  std::vector<Placement> moved;
  placer.rebuild(bodies);
  placer.keep_free_of({});  // whom a roamer is running over stays there
  is_placer_stale = false;
  for (std::uint32_t i = 0; i < bodies.count(); ++i) {
    if (!bodies.present[i]) continue;
    const Point here = bodies.position(i);
    const auto place = placer.nearest_free(bodies, *state.statics, here, bodies.radius[i],
                                           bodies.held[i] ? state.area : kWholeWorld, i);
    if (!place || *place == here) continue;
    bodies.x[i] = place->x;
    bodies.y[i] = place->y;
    placer.rebuild(bodies);
    moved.push_back({{i}, {*place, bodies.heading[i]}, true});
  }
  placer.keep_free_of(roaming.discs());
  state.objects.follow(bodies);
  is_stale = true;
  return moved;
}

std::vector<Placement> Simulator::set_obstacles(std::span<const Disc> discs) {
  return parts_->replace_statics({discs.begin(), discs.end()}, {walls().begin(), walls().end()});
}

std::vector<Placement> Simulator::set_walls(std::span<const Wall> walls) {
  return parts_->replace_statics({discs().begin(), discs().end()}, {walls.begin(), walls.end()});
}

void Simulator::set_objects(std::span<const Object> objects, std::span<const base::ObjectId> were,
                            std::span<const Travel> travels) {
  World world;
  std::vector<base::ObjectId> kept;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    world.objects = {objects[i]};
    keep_usable(world);
    if (!world.objects.empty()) kept.push_back(i < were.size() ? were[i] : base::ObjectId{});
  }
  world.objects.assign(objects.begin(), objects.end());
  world.travels.assign(travels.begin(), travels.end());
  keep_usable(world);
  parts_->state.objects.replace(std::move(world.objects), world.travels, kept, parts_->state.bodies);
  parts_->state.objects.travel(parts_->state.time);
  parts_->is_stale = true;
}

std::vector<Placement> Simulator::add_obstacles(std::span<const Disc> discs) {
  std::vector<Disc> all(this->discs().begin(), this->discs().end());
  all.insert(all.end(), discs.begin(), discs.end());
  return set_obstacles(all);
}

void Simulator::set_roamers(std::vector<Roamer> roamers) {
  World world;
  world.roamers = std::move(roamers);
  keep_usable(world);
  parts_->state.roamers = std::make_shared<const std::vector<Roamer>>(std::move(world.roamers));
  forget_roamers(parts_->state.bodies);
  parts_->place_roamers();
  parts_->is_placer_stale = true;
}

std::size_t Simulator::remove_obstacles(const std::function<bool(const Disc&)>& is_gone) {
  std::vector<Disc> all(discs().begin(), discs().end());
  const std::size_t count = std::erase_if(all, is_gone);
  if (count > 0) set_obstacles(all);
  return count;
}

void Simulator::set_silences(std::vector<Outline> silences) {
  parts_->state.silences = std::make_shared<const std::vector<Outline>>(std::move(silences));
}

void Simulator::set_building(Building building) {
  const Site before = std::move(parts_->state.site);
  parts_->state.site = Site(std::move(building));
  for (std::uint32_t i = 0; i < parts_->state.site.doors().size(); ++i) {
    const percept::Door& door = parts_->state.site.doors()[i];
    for (const percept::Door& was : before.doors()) {
      if (was.is_marked && was.a == door.a && was.b == door.b)
        parts_->state.site.mark(i + 1, true, door.a, 0.0);
    }
  }
}

bool Simulator::is_free(Point place, double radius) const {
  Parts& p = *parts_;
  if (p.is_placer_stale) p.placer.rebuild(p.state.bodies);
  p.is_placer_stale = false;
  return p.placer.is_free(p.state.bodies, *p.state.statics, place, radius);
}

bool Simulator::in_sight(Point a, Point b) const {
  return parts_->state.statics->in_sight(a, b);
}

std::shared_ptr<const Simulator::State> Simulator::snapshot() const {
  auto out = std::make_shared<State>(parts_->state);
  out->objects.forget_grid();
  return out;
}

std::size_t Simulator::bytes(const State& state) {
  const std::size_t bodies = state.bodies.count() * kBytesOfBody;
  std::size_t kinds = state.kinds.size() * sizeof(Kind);
  for (const Kind& kind : state.kinds) kinds += kind.beams.count() * sizeof(percept::RangeReading) * 2;
  return sizeof state + bodies + kinds + state.objects.list().size() * sizeof(Object) +
         state.site.doors().size() * sizeof(percept::Door);
}

void Simulator::restore(const State& state) {
  parts_->state = state;
  parts_->place_roamers();
  parts_->has_odometry =
      std::ranges::any_of(state.kinds, [](const Kind& kind) { return kind.spec.odometry_noise > 0.0; });
  parts_->is_stale = true;
  parts_->is_placer_stale = true;
}

}  // namespace mlab::sim
