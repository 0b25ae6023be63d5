#include <algorithm>
#include <map>
#include <utility>

#include <fmt/core.h>

#include "mlab/mission/wording.h"
#include "mlab/run/mission_run.h"

namespace mlab::run {

void MissionRun::edit(std::shared_ptr<const Crew> crew) {
  note(input::Exchanged{crew, false});
  const std::shared_ptr<const mission::Mission> old = now_.executive.mission;
  now_.crews.push_back(std::move(crew));
  const Crew& next = *now_.crews.back();
  fleet_->edit(*next.mission, next.programs, next.bodies);
  rename_metrics(*old, *next.mission);
  carry_out(mission::event::Edited{next.mission});
  const std::optional<double> duration = next.mission->options.cycle_duration;
  if (duration && duration != old->options.cycle_duration)
    apply(mission::effect::Set{mission::SetNumber{mission::NumberOption::kCycleDuration, *duration}});
  change_world(old->overlay, next.mission->overlay);
  drop_unused_crews();
}

namespace {

constexpr std::size_t kMostRestarts = 8;  // that are named

// Why these robots can't go on with what the crew has for them; empty: they can.
std::string why_not(const fleet::Fleet& fleet, const Crew& crew) {
  const std::vector<mission::Robot>& planned = crew.mission->robots;
  if (planned.size() != fleet.robots().size()) return "there are other robots now";
  for (const mission::Robot& one : planned) {
    const fleet::FleetRobot* const robot = fleet.find(one.id);
    const robot::RobotProgram& program = crew.programs[one.type];
    if (robot == nullptr || robot->type != crew.mission->types[one.type].name)
      return "there are other robots now";
    if (robot->body_spec != crew.bodies[one.type])
      return fmt::format("the body of {} has changed", robot->type);
    if (robot->program->is_closed() || program.is_closed())
      return fmt::format("the program of {} is an executable, which keeps its values to itself", robot->type);
    if (program.is_described_only)
      return fmt::format("{} brings procedures that were only checked", robot->type);
    if (!program.can_run() || robot->runner == nullptr)
      return fmt::format("nothing here answers to the program of {}", robot->type);
  }
  return "";
}

std::vector<Takeover::Restart> by_path(const std::vector<std::pair<base::RobotId, flow::Restart>>& all) {
  std::vector<Takeover::Restart> out;
  std::map<flow::Restart, std::size_t> known;  // index in `out`
  for (const auto& [robot, restart] : all) {
    const auto [at, is_new] = known.try_emplace(restart, out.size());
    if (is_new) out.push_back({restart.path, restart.why, {}});
    out[at->second].robots.push_back(robot);
  }
  return out;
}

}  // namespace

std::string text_of(const Takeover& takeover) {
  std::string out = fmt::format("{} took over a change", mission::robots_name(takeover.robots));
  if (takeover.restarts.empty()) return out + "; nothing begins anew";
  for (std::size_t i = 0; i < takeover.restarts.size(); ++i) {
    if (i == kMostRestarts) {
      out += fmt::format("; and {} more begin anew", takeover.restarts.size() - i);
      break;
    }
    const Takeover::Restart& one = takeover.restarts[i];
    out += fmt::format("; `{}` {}", one.path, one.why);
    if (one.robots != takeover.robots) out += fmt::format(" ({})", mission::robots_name(one.robots));
  }
  return out;
}

std::expected<Takeover, std::string> MissionRun::take_over(std::shared_ptr<const Crew> crew) {
  note(input::Exchanged{crew, true});
  if (std::string why = why_not(*fleet_, *crew); !why.empty()) return std::unexpected(std::move(why));
  const std::shared_ptr<const mission::Mission> old = now_.executive.mission;
  now_.crews.push_back(std::move(crew));
  const Crew& next = *now_.crews.back();
  Takeover out;
  out.cycle = now_.cycle;
  std::vector<std::pair<base::RobotId, flow::Restart>> restarts;
  out.robots = fleet_->take_over(*next.mission, next.programs, next.bodies, restarts);
  out.restarts = by_path(restarts);
  if (next.mission != old) {
    rename_metrics(*old, *next.mission);
    carry_out(mission::event::Edited{next.mission});
    change_world(old->overlay, next.mission->overlay);
  }
  drop_unused_crews();
  now_.takeovers.push_back(out);
  tell(mission::effect::Tell::Kind::kMessage, text_of(out));
  return out;
}

void MissionRun::change_world(const overlay::Overlay& before_edit, const overlay::Overlay& after_edit) {
  const binding::MapChange change = binding_->change_map(before_edit, after_edit);
  tell_moved(change.moved_by_obstacles, "an obstacle");
  tell_moved(change.moved_by_walls, "a wall");
  if (change.has_other_objects) now_.carriers.clear();
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
    for (std::size_t k = 0; k < std::min(now_.metrics.size(), before_edit.units.size()); ++k) {
      const bool same_unit = after_edit.units[i].name == before_edit.units[k].name &&
                             (!after_edit.units[i].name.empty() || i == k);
      if (same_unit) metrics[i] = now_.metrics[k];
    }
  }
  now_.metrics = std::move(metrics);
}

void MissionRun::drop_unused_crews() {
  const std::shared_ptr<const Crew> in_force = now_.crews.back();
  std::erase_if(now_.crews, [&](const std::shared_ptr<const Crew>& crew) {
    return crew != in_force && !fleet_->uses(crew->programs);
  });
}

}  // namespace mlab::run
