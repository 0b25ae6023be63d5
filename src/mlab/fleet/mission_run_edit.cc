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

// What is in `from` and not in `without`; equal ones are told apart by their number.
std::vector<sim::Disc> difference(const std::vector<sim::Disc>& from, const std::vector<sim::Disc>& without) {
  std::vector<sim::Disc> out;
  std::ranges::set_difference(from, without, std::back_inserter(out), before);
  return out;
}

}  // namespace

void MissionRun::edit(std::shared_ptr<const Crew> crew) {
  const std::shared_ptr<const mission::Mission> old = state_.mission;
  crews_.push_back(crew);
  fleet_->edit(*crew->mission, crew->programs, crew->bodies);
  rename_metrics(*old, *crew->mission);
  post(mission::event::Edited{crew->mission});
  const std::optional<double> duration = crew->mission->options.cycle_duration;
  if (duration && duration != old->options.cycle_duration)
    apply(mission::effect::Set{mission::SetNumber{mission::NumberOption::kCycleDuration, *duration}});
  change_world(old->overlay, crew->mission->overlay);
  drop_unused_crews();
}

void MissionRun::change_world(const overlay::Overlay& before_edit, const overlay::Overlay& after_edit) {
  std::vector<sim::Disc> old_discs = sim::world_of(before_edit).discs;
  std::vector<sim::Disc> new_discs = sim::world_of(after_edit).discs;
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
  for (const sim::Placement& moved : simulator_->add_obstacles(come)) {
    tell(mission::effect::Tell::Kind::kWarning,
         fmt::format("robot {} was moved: an obstacle appeared where it stood",
                     simulator_->robot(moved.body).value));
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
