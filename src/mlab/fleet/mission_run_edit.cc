#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/fleet/mission_run.h"

namespace mlab::fleet {
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
  const binding::MapChange change = binding_->change_map(before_edit, after_edit);
  tell_moved(change.moved_by_obstacles, "an obstacle");
  tell_moved(change.moved_by_walls, "a wall");
  if (change.has_other_objects) carriers_.clear();
}

void MissionRun::tell_moved(const std::vector<base::RobotId>& moved, std::string_view by) {
  for (const base::RobotId robot : moved) {
    tell(mission::effect::Tell::Kind::kWarning,
         fmt::format("robot {} was moved: {} appeared where it stood", robot.value, by));
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
