#include "mlab/sim/simulated_binding.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <tuple>
#include <utility>

namespace mlab::sim {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

bool is_before(const Disc& a, const Disc& b) {
  return std::tuple(a.center.x, a.center.y, a.radius) < std::tuple(b.center.x, b.center.y, b.radius);
}

bool is_same_wall(const Wall& a, const Wall& b) {
  return a.segment.a == b.segment.a && a.segment.b == b.segment.b && a.group == b.group &&
         a.is_solid == b.is_solid;
}

// What is in `from` and not in `without`; equal ones are told apart by their number.
std::vector<Disc> difference(const std::vector<Disc>& from, const std::vector<Disc>& without) {
  std::vector<Disc> out;
  std::ranges::set_difference(from, without, std::back_inserter(out), is_before);
  return out;
}

class KeptSimulation final : public binding::Binding::Kept {
 public:
  KeptSimulation(std::shared_ptr<const Simulator::State> kept, std::vector<double> failures)
      : state(std::move(kept)), fails_at(std::move(failures)) {}
  std::size_t bytes() const override { return Simulator::bytes(*state) + fails_at.size() * sizeof(double); }

  const std::shared_ptr<const Simulator::State> state;
  const std::vector<double> fails_at;
};

}  // namespace

SimulatedBinding::SimulatedBinding(World world, SimulatorSettings settings)
    : simulator_(std::move(world), settings),
      breakdowns_(std::move(settings.breakdowns)),
      buffers_(static_cast<std::size_t>(workers().count())) {}

std::expected<Placement, std::string> SimulatedBinding::embody(const BodySetup& setup) {
  if (!setup.vehicle.empty())
    return std::unexpected("the vehicle `" + setup.vehicle +
                           "` is its body, and this run did not find it when it began: start the run anew");
  const std::optional<Placement> placement = simulator_.add_body(setup);
  if (!placement) return std::unexpected("there is no free place near");
  if (!breakdowns_.empty()) note_breakdown(placement->body, setup.robot);
  return *placement;
}

// Who has broken down once gets another body, which is well.
void SimulatedBinding::note_breakdown(BodyIndex body, base::RobotId robot) {
  fails_at_.resize(simulator_.body_count(), kNever);
  const auto breakdown = std::ranges::find(breakdowns_, robot, &Breakdown::robot);
  if (breakdown == breakdowns_.end()) return;
  for (std::uint32_t other = 0; other < simulator_.body_count(); ++other) {
    if (BodyIndex{other} != body && simulator_.robot(BodyIndex{other}) == robot) return;
  }
  fails_at_[body.value] = time() + breakdown->after;
}

void SimulatedBinding::health(std::vector<binding::Ailment>& out) {
  for (std::uint32_t body = 0; body < fails_at_.size(); ++body) {
    if (fails_at_[body] > time()) continue;
    fails_at_[body] = kNever;
    out.push_back({BodyIndex{body}, "has broken down"});
  }
}

void SimulatedBinding::percepts(std::span<const binding::Sensing> robots, int worker) {
  simulator_.sense(robots, buffers_[static_cast<std::size_t>(worker)]);
}

void SimulatedBinding::carry_out(std::span<const percept::Action> actions, double dt) {
  if (actions.size() == simulator_.body_count()) {
    simulator_.step(actions, dt);
    return;
  }
  actions_.assign(actions.begin(), actions.begin() + static_cast<std::ptrdiff_t>(
                                                         std::min(actions.size(), simulator_.body_count())));
  actions_.resize(simulator_.body_count());
  simulator_.step(actions_, dt);
}

void SimulatedBinding::poses(std::span<const BodyIndex> bodies, std::span<geom::Pose> out) const {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies[i] != binding::kNoBody) out[i] = simulator_.pose(bodies[i]);
  }
}

std::expected<std::shared_ptr<const binding::Binding::Kept>, std::string> SimulatedBinding::save() const {
  return std::make_shared<const KeptSimulation>(simulator_.snapshot(), fails_at_);
}

bool SimulatedBinding::restore(const Kept& kept) {
  const auto* const simulation = dynamic_cast<const KeptSimulation*>(&kept);
  if (simulation == nullptr) return false;
  simulator_.restore(*simulation->state);
  fails_at_ = simulation->fails_at;
  return true;
}

std::vector<std::optional<geom::Pose>> SimulatedBinding::places_for(std::span<const BodySetup> setups) {
  std::vector<std::optional<geom::Pose>> out;
  const std::shared_ptr<const Simulator::State> before = simulator_.snapshot();
  for (const BodySetup& setup : setups) {
    const auto placement = simulator_.add_body(setup);
    out.push_back(placement ? std::optional(placement->pose) : std::nullopt);
  }
  simulator_.restore(*before);
  return out;
}

binding::MapChange SimulatedBinding::change_map(const overlay::Overlay& before,
                                                const overlay::Overlay& after) {
  binding::MapChange out;
  World old_world = world_of(before);
  World new_world = world_of(after);
  std::ranges::sort(old_world.discs, is_before);
  std::ranges::sort(new_world.discs, is_before);
  out.moved_by_obstacles = change_obstacles(difference(old_world.discs, new_world.discs),
                                            difference(new_world.discs, old_world.discs));
  if (old_world.roamers != new_world.roamers) simulator_.set_roamers(std::move(new_world.roamers));
  if (!std::ranges::equal(old_world.walls, new_world.walls, is_same_wall))
    out.moved_by_walls = robots_of(simulator_.set_walls(new_world.walls));
  simulator_.set_building(std::move(new_world.building));
  simulator_.set_silences(std::move(new_world.silences));
  const std::vector<base::ObjectId> were = same_objects(old_world.objects, new_world.objects);
  out.has_other_objects = !std::ranges::equal(were, old_world.objects, {}, {}, &Object::id);
  if (out.has_other_objects || old_world.travels != new_world.travels)
    simulator_.set_objects(new_world.objects, were, new_world.travels);
  return out;
}

// Only what really comes or goes is touched, so that robots and grids are left alone otherwise.
std::vector<base::RobotId> SimulatedBinding::change_obstacles(std::span<const Disc> gone,
                                                              std::span<const Disc> come) {
  std::vector<Disc> left(gone.begin(), gone.end());
  std::ranges::sort(left, is_before);
  if (!left.empty()) {
    simulator_.remove_obstacles([&](const Disc& disc) {
      const auto [first, last] = std::ranges::equal_range(left, disc, is_before);
      if (first == last) return false;
      left.erase(first);
      return true;
    });
  }
  return robots_of(simulator_.add_obstacles(come));
}

std::vector<base::RobotId> SimulatedBinding::robots_of(const std::vector<Placement>& moved) const {
  std::vector<base::RobotId> out;
  for (const Placement& each : moved) out.push_back(simulator_.robot(each.body));
  return out;
}

binding::BodyState SimulatedBinding::body(BodyIndex body) const {
  const Momentum& momentum = simulator_.momentum(body);
  return {momentum.velocity,         momentum.speed,
          momentum.turn_rate,        simulator_.distance_driven(body),
          simulator_.contacts(body), simulator_.in_contact(body),
          simulator_.carried(body),  simulator_.run_over(body)};
}

percept::Percepts SimulatedBinding::sense(BodyIndex body, const percept::Needs& needs) const {
  percept::Percepts out;
  simulator_.sense(body, needs, view_buffer_, out);
  return out;
}

percept::Percepts SimulatedBinding::sense_at(BodyIndex body, const geom::Pose& pose,
                                             const percept::Needs& needs) const {
  percept::Percepts out;
  simulator_.sense_at(body, pose, needs, view_buffer_, out);
  return out;
}

}  // namespace mlab::sim
