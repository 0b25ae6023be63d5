// How the world is changed while the simulation goes on, and how it is kept and brought back.

#include <algorithm>
#include <utility>

#include "mlab/base/fields.h"
#include "mlab/sim/simulator_parts.h"
#include "mlab/sim/touched.h"

namespace mlab::sim {
namespace {

using geom::Point;

std::size_t bytes_of(const Bodies& bodies) {
  std::size_t out = 0;
  base::for_each_field(bodies, [&](const auto& list) { out += list.size() * sizeof list[0]; });
  return out;
}

}  // namespace

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
  std::size_t kinds = state.kinds.size() * sizeof(Kind);
  for (const Kind& kind : state.kinds) kinds += kind.beams.count() * sizeof(percept::RangeReading) * 2;
  return sizeof state + bytes_of(state.bodies) + kinds + state.objects.list().size() * sizeof(Object) +
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
