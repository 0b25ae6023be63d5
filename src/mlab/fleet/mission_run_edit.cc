#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include "mlab/fleet/mission_run.h"

namespace mlab::fleet {
namespace {

bool before(const sim::Disc& a, const sim::Disc& b) {
  return std::tuple(a.center.x, a.center.y, a.radius) < std::tuple(b.center.x, b.center.y, b.radius);
}

bool is_same_wall(const sim::Wall& a, const sim::Wall& b) {
  return a.segment.a == b.segment.a && a.segment.b == b.segment.b && a.group == b.group;
}

// What is in `from` and not in `without`; equal ones are told apart by their number.
std::vector<sim::Disc> difference(const std::vector<sim::Disc>& from, const std::vector<sim::Disc>& without) {
  std::vector<sim::Disc> out;
  std::ranges::set_difference(from, without, std::back_inserter(out), before);
  return out;
}

}  // namespace

void MissionRun::edit(std::shared_ptr<const Crew> crew) {
  const std::shared_ptr<const mission::Mission> old = state_.mission;
  crews_.push_back(std::move(crew));
  const Crew& next = *crews_.back();
  fleet_->edit(*next.mission, next.programs, next.bodies);
  rename_metrics(*old, *next.mission);
  post(mission::event::Edited{next.mission});
  const std::optional<double> duration = next.mission->options.cycle_duration;
  if (duration && duration != old->options.cycle_duration)
    apply(mission::effect::Set{mission::SetNumber{mission::NumberOption::kCycleDuration, *duration}});
  change_world(old->overlay, next.mission->overlay);
  drop_unused_crews();
}

void MissionRun::change_world(const overlay::Overlay& before_edit, const overlay::Overlay& after_edit) {
  const sim::World old_world = sim::world_of(before_edit);
  const sim::World new_world = sim::world_of(after_edit);
  std::vector<sim::Disc> old_discs = old_world.discs;
  std::vector<sim::Disc> new_discs = new_world.discs;
  std::ranges::sort(old_discs, before);
  std::ranges::sort(new_discs, before);
  std::vector<sim::Disc> gone = difference(old_discs, new_discs);
  const std::vector<sim::Disc> come = difference(new_discs, old_discs);
  if (!gone.empty()) {
    simulator_->remove_obstacles([&](const sim::Disc& disc) {
      const auto [first, last] = std::ranges::equal_range(gone, disc, before);
      if (first == last) return false;
      gone.erase(first);
      return true;
    });
  }
  tell_moved(simulator_->add_obstacles(come), "an obstacle");
  if (!std::ranges::equal(old_world.walls, new_world.walls, is_same_wall))
    tell_moved(simulator_->set_walls(new_world.walls), "a wall");
  simulator_->set_building(new_world.building);
  const std::vector<base::ObjectId> were = sim::same_objects(old_world.objects, new_world.objects);
  const bool stay = std::ranges::equal(were, old_world.objects, {}, {}, &sim::Object::id);
  if (!stay) {
    simulator_->set_objects(new_world.objects, were);
    carriers_.clear();  // ids may mean others now
  }
}

void MissionRun::tell_moved(const std::vector<sim::Placement>& moved, std::string_view by) {
  for (const sim::Placement& each : moved) {
    tell(mission::effect::Tell::Kind::kWarning, fmt::format("robot {} was moved: {} appeared where it stood",
                                                            simulator_->robot(each.body).value, by));
  }
}

void MissionRun::rename_metrics(const mission::Mission& before_edit, const mission::Mission& after_edit) {
  std::vector<UnitMetrics> metrics(after_edit.units.size());
  for (std::size_t i = 0; i < after_edit.units.size(); ++i) {
    for (std::size_t k = 0; k < std::min(metrics_.size(), before_edit.units.size()); ++k) {
      const bool same_unit = after_edit.units[i].name == before_edit.units[k].name &&
                             (!after_edit.units[i].name.empty() || i == k);
      if (same_unit) metrics[i] = metrics_[k];
    }
  }
  metrics_ = std::move(metrics);
}

void MissionRun::drop_unused_crews() {
  const std::shared_ptr<const Crew> in_force = crews_.back();
  std::erase_if(crews_, [&](const std::shared_ptr<const Crew>& crew) {
    return crew != in_force && !fleet_->uses(crew->programs);
  });
}

}  // namespace mlab::fleet
