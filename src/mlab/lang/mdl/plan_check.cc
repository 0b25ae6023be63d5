#include "mlab/lang/mdl/plan_check.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/counted.h"
#include "mlab/lang/mdl/fence_check.h"
#include "mlab/lang/mdl/formation_check.h"
#include "mlab/lang/mdl/goal_check.h"
#include "mlab/lang/mdl/options.h"
#include "mlab/lang/mdl/quoted.h"
#include "mlab/lang/mdl/way_check.h"
#include "mlab/mission/command.h"
#include "mlab/mission/parameter.h"
#include "mlab/mission/search.h"
#include "mlab/mission/wording.h"
#include "mlab/ways/clearances.h"

namespace mlab::mdl {
namespace {

using mission::Task;
using mission::UnitCommand;

// Robots looked at over the whole mission: some tenths of a second.
constexpr std::uint64_t kMaxRobotVisits = 5'000'000;
// Areas looked at over the whole mission, some tenths of a second each.
constexpr int kMaxSearches = 10;

// How many robots are in the state that a command meets; the first of them.
struct Met {
  std::size_t count = 0;
  base::RobotId first;
  void add(base::RobotId id) {
    if (count++ == 0) first = id;
  }
};

class PlanCheck {
 public:
  PlanCheck(const mission::Mission& mission, text::Diagnostics& diagnostics)
      : mission_(mission),
        diagnostics_(diagnostics),
        formations_(mission, diagnostics),
        goals_(mission, diagnostics),
        fences_(mission, diagnostics),
        ways_(mission, diagnostics),
        robots_(mission.robots.size()) {
    for (std::uint32_t i = 0; i < mission.robots.size(); ++i) index_of_[mission.robots[i].id.value] = i;
  }

  void run() {
    for (const mission::Step& step : mission_.steps) {
      check_label(step);
      if (quits_) {
        diagnostics_.warning("unreachable-step", step.place,
                             "this step comes after QUIT and is never carried out");
        return;
      }
      check_effect(step);
      commands(step.commands);
    }
  }

  void commands(const std::vector<mission::Command>& commands) {
    ++step_;
    for (const mission::Command& command : commands) {
      if (std::holds_alternative<mission::Quit>(command)) quits_ = true;
      const auto* unit_command = std::get_if<UnitCommand>(&command);
      if (unit_command == nullptr || !may_visit(*unit_command)) continue;
      check_two_commands(*unit_command);
      check_goal(*unit_command);
      if (is_one_step_) continue;
      check_life(*unit_command);
      check_way(*unit_command);
    }
  }

  void look_at_one_step() { is_one_step_ = true; }

 private:
  enum class Life : std::uint8_t { kAbsent, kStarted, kStopped };
  struct RobotState {
    Life life = Life::kAbsent;
    bool has_place = false;
    geom::Point place;
    std::uint32_t step = 0;  // the last one with a command for it
    const UnitCommand* command = nullptr;
  };

  RobotState& state(base::RobotId id) { return robots_[index_of_.at(id.value)]; }
  const std::vector<base::RobotId>& robots_of(const UnitCommand& c) const {
    return mission::members_of(mission_, c);
  }
  // Whom a command is for, as its author wrote it.
  std::string whom(const UnitCommand& c) const {
    const std::string name = in_backticks(mission::addressee(mission_, c));
    return c.unit == mission::kNoUnit ? name : "unit " + name;
  }

  bool may_visit(const UnitCommand& c) {
    visits_ += robots_of(c).size();
    return visits_ < kMaxRobotVisits;
  }

  void check_label(const mission::Step& step) {
    const auto [entry, is_new] = labels_.try_emplace(step.label, &step);
    if (is_new) return;
    diagnostics_
        .warning("duplicate-label", step.place,
                 fmt::format("there is a step {} already", in_backticks(step.label + ".")))
        .notes.push_back({"the first one is here", entry->second->place});
  }

  void check_effect(const mission::Step& step) {
    bool has_effect = false;
    for (const mission::Command& command : step.commands) {
      has_effect |= !sets_nothing_new(command, options_);
      apply_set(command, options_);
    }
    if (has_effect) return;
    diagnostics_.warning("step-without-effect", step.place, "this step sets what is set already");
  }

  void check_two_commands(const UnitCommand& c) {
    Met busy;
    const UnitCommand* other = nullptr;
    for (const base::RobotId id : robots_of(c)) {
      RobotState& robot = state(id);
      if (robot.step == step_ && busy.count++ == 0) {
        busy.first = id;
        other = robot.command;
      }
      robot.step = step_;
      robot.command = &c;
    }
    if (other == nullptr || c.unit == mission::kNoUnit) return;  // who names robots means it
    diagnostics_
        .warning("robot-in-two-commands", c.place,
                 busy.count == 1
                     ? fmt::format("robot {} has another command in the same step", busy.first.value)
                     : fmt::format("{} robots, of them robot {}, have another command in the same step",
                                   busy.count, busy.first.value))
        .notes.push_back({"the other command is here", other->place});
  }

  void check_life(const UnitCommand& c) {
    Met absent;
    Met started;
    Met stopped;
    for (const base::RobotId id : robots_of(c)) {
      RobotState& robot = state(id);
      (robot.life == Life::kAbsent ? absent : robot.life == Life::kStarted ? started : stopped).add(id);
      if (c.task == Task::kStart) robot.life = Life::kStarted;
      if (c.task == Task::kStop) robot.life = Life::kStopped;
    }
    const bool is_one = c.unit != mission::kNoUnit || c.robots.size() == 1;
    const char* is = is_one ? "is" : "are";
    const char* get = is_one ? "gets" : "get";
    if (c.task == Task::kStart) {
      if (started.count > 0)
        warn_once("already-started", c, fmt::format("{} {} started already", whom(c), is));
    } else if (absent.count > 0) {
      warn_once(
          "not-started", c,
          fmt::format("{} {} a command before {} started", whom(c), get, is_one ? "it is" : "they are"));
    } else if (stopped.count > 0) {
      warn_once(
          "after-stop", c,
          fmt::format("{} {} a command after {} stopped", whom(c), get, is_one ? "it was" : "they were"));
    }
  }

  void warn_once(const char* kind, const UnitCommand& c, std::string message) {
    const bool is_new = c.unit == mission::kNoUnit ? warned_robots_.insert({kind, c.robots}).second
                                                   : warned_.insert({kind, c.unit}).second;
    if (is_new) diagnostics_.warning(kind, c.place, std::move(message));
  }

  void check_way(const UnitCommand& c) {
    if (c.task == Task::kStop) return;
    if (mission::info(c.task).is_shared) {
      check_shared_ways(c);
      return;
    }
    if (c.task == Task::kStart) {
      check_start(c);
    } else if (c.task == Task::kFollow) {
      for (std::size_t i = 0; i + 1 < c.route.size() && visits_++ < kMaxRobotVisits; ++i) {
        formations_.check_leg(c, {c.route[i], c.route[i + 1]});
      }
      if (!has_way_along(c)) return;  // it stays before its end
    } else if (c.task != Task::kTeleoperate) {
      const RobotState& first = state(robots_of(c).front());
      formations_.check_leg(c, {first.has_place ? first.place : c.goal, c.goal});
      if (!has_ways(c)) return;  // it stays there
    }
    double step = 0.0;
    for (const base::RobotId id : robots_of(c)) {
      RobotState& robot = state(id);
      robot.place = c.task == Task::kStart ? c.goal + c.start_step * step++ : c.goal;
      robot.has_place = true;
    }
  }

  // Whether a way leads there from where each of its robots is, as far as that is looked at. It warns of the
  // first one of which it isn't so.
  bool has_ways(const UnitCommand& c) {
    constexpr std::size_t kMostPlaces = 100;
    const std::vector<base::RobotId>& members = robots_of(c);
    if (!state(members.front()).has_place) return true;
    std::optional<geom::Point> looked_from;
    for (std::size_t k = 0; k < std::min(members.size(), kMostPlaces); ++k) {
      const RobotState& robot = state(members[k]);
      if (!robot.has_place || robot.place == looked_from) continue;
      looked_from = robot.place;
      const std::string who =
          k == 0 ? in_backticks(mission::addressee(mission_, c)) : fmt::format("robot {}", members[k].value);
      if (!leads_there(c, {who, robot.place}, most_room(c), success_radius(c))) return false;
    }
    return true;
  }

  // The same along its route, whose corners that no way leads to are left out: it warns of the first one, and
  // of the end. True where a way leads to that.
  bool has_way_along(const UnitCommand& c) {
    const RobotState& first = state(robots_of(c).front());
    if (!first.has_place || c.route.empty()) return true;
    UnitCommand one;
    one.unit = c.unit;
    one.robots = c.robots;
    one.place_name = c.place_name;
    one.goal_place = c.goal_place;
    const WayCheck::Room room = most_room(c);
    const double success = success_radius(c);
    WayCheck::From from{in_backticks(mission::addressee(mission_, c)), first.place, true};
    for (std::size_t i = 0; i + 1 < c.route.size() && visits_++ < kMaxRobotVisits; ++i) {
      one.goal = c.route[i];
      if (!leads_there(one, from, room, success)) break;
      from.place = one.goal;
    }
    one.goal = c.route.back();
    from.to_corner = false;
    return leads_there(one, from, room, success);
  }

  // Who begins within a minefield gets out of it, and goals within one are warned of besides.
  bool leads_there(const UnitCommand& c, const WayCheck::From& from, WayCheck::Room room, double success) {
    room.keeps_out = room.keeps_out && goals_.minefield_at(from.place) == nullptr &&
                     goals_.minefield_at(mission::goal_of(c)) == nullptr;
    return ways_.check(c, from, room, success);
  }

  // Who goes where they settle among themselves.
  void check_shared_ways(const UnitCommand& c) {
    const base::RobotId first = robots_of(c).front();
    if (state(first).has_place) {
      one_by_one(c, [&](const UnitCommand& one) {
        leads_there(one, {in_backticks(mission::addressee(mission_, one)), state(first).place},
                    room_of(first), success_radius(c));
      });
    }
    for (const base::RobotId id : robots_of(c)) state(id).has_place = false;
  }

  // Of VISIT and PATROL: as if there were a command for each of their places.
  template <class Visit>
  static void one_by_one(const UnitCommand& c, const Visit& visit) {
    UnitCommand one;
    one.unit = c.unit;
    one.robots = c.robots;
    for (std::size_t i = 0; i < std::min(c.route.size(), c.written.size()); ++i) {
      one.goal = c.route[i];
      one.place_name = c.written[i].name;
      one.goal_place = c.written[i].place;
      visit(std::as_const(one));
    }
  }

  bool has_goal(const UnitCommand& c) const {
    return c.task != Task::kStop && c.task != Task::kStart && c.task != Task::kTeleoperate;
  }
  void check_goal(const UnitCommand& c) {
    if (!has_goal(c)) return;
    const double radius = body_radius(robots_of(c).front());
    if (c.task == Task::kSearch) {
      check_area(c);
    } else if (!mission::info(c.task).is_shared) {
      goals_.check(c, radius);
    } else {
      one_by_one(c, [&](const UnitCommand& one) { goals_.check(one, radius); });
    }
  }

  // Of SEARCH.
  void check_area(const UnitCommand& c) {
    if (std::ranges::any_of(c.route, [&](geom::Point corner) { return goals_.is_outside(corner); })) {
      const overlay::Area area = mission_.overlay.mission_area();
      diagnostics_.warning(
          "goal-outside-area", c.goal_place,
          fmt::format("{} reaches out of the mission area of {:g} by {:g} m: what lies there is not searched",
                      in_backticks(c.place_name), area.width, area.height));
    }
    if (++searches_ > kMaxSearches) return;
    const base::RobotId first = robots_of(c).front();
    const auto from = state(first).has_place ? std::optional(state(first).place) : std::nullopt;
    std::string warning = mission::warn_of_search(mission_, c, first, from, in_backticks(c.place_name));
    if (!warning.empty()) diagnostics_.warning("not-searched", c.goal_place, std::move(warning));
  }

  void check_start(const UnitCommand& c) {
    const std::vector<base::RobotId>& members = robots_of(c);
    const double spacing = geom::length(c.start_step);
    // Without offsets that is meant.
    if (members.size() > 1 && spacing > 0.0 && spacing < 2.0 * body_radius(members.front())) {
      diagnostics_
          .warning(
              "start-on-one-spot", c.place,
              fmt::format("the {} robots of {} start {:g} m apart and will be moved to where there is room",
                          members.size(), in_backticks(mission::addressee(mission_, c)), spacing))
          .hints.push_back(
              fmt::format("write `START {} 0 20` for a row to the north, 20 m apart", c.place_name));
    }
    check_fences(c);
    check_start_places(c);
  }

  void check_start_places(const UnitCommand& c) {
    const std::vector<base::RobotId>& members = robots_of(c);
    const overlay::Area area = mission_.overlay.mission_area();
    Met outside;
    Met inside;
    Met mined;
    const overlay::ObstacleDisc* obstacle = nullptr;
    const overlay::ControlMeasure* minefield = nullptr;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const geom::Point p = c.goal + c.start_step * static_cast<double>(k);
      if (goals_.is_outside(p)) outside.add(members[k]);
      if (const overlay::ControlMeasure* around = goals_.minefield_at(p)) {
        if (minefield == nullptr) minefield = around;
        mined.add(members[k]);
      }
      const overlay::ObstacleDisc* hit = goals_.obstacle_at(p, body_radius(members[k]));
      if (hit == nullptr) continue;
      if (obstacle == nullptr) obstacle = hit;
      inside.add(members[k]);
    }
    if (outside.count > 0) {
      diagnostics_.warning(
          "start-outside-area", c.goal_place,
          fmt::format("{} of {} outside the mission area of {:g} by {:g} m, first robot {}", outside.count,
                      starting(members.size()), area.width, area.height, outside.first.value));
    }
    if (inside.count > 0) {
      auto& warning =
          diagnostics_.warning("start-in-obstacle", c.goal_place,
                               fmt::format("{} of {} in an obstacle and will be moved, first robot {}",
                                           inside.count, starting(members.size()), inside.first.value));
      if (obstacle->place.source) warning.notes.push_back({"the obstacle is here", obstacle->place});
    }
    if (mined.count > 0) {
      auto& warning = diagnostics_.warning(
          "start-in-minefield", c.goal_place,
          fmt::format("{} of {} in a minefield, which robots keep out of, first robot {}", mined.count,
                      starting(members.size()), mined.first.value));
      if (minefield->place.source) warning.notes.push_back({"the minefield is here", minefield->place});
    }
  }

  void check_fences(const UnitCommand& c) {
    if (mission_.failsafes.empty()) return;
    std::vector<const mission::Robot*> robots;
    for (const base::RobotId id : robots_of(c)) robots.push_back(&mission_.robots[index_of_.at(id.value)]);
    fences_.check(c, robots);
  }

  static std::string starting(std::size_t robots) {
    return base::counted(robots, "robot") + (robots == 1 ? " starts" : " start");
  }

  // Who is so near to the goal is there [m].
  double success_radius(const UnitCommand& c) const {
    if (c.task == Task::kRally) return c.radius;
    const std::uint32_t type = mission_.robots[index_of_.at(robots_of(c).front().value)].type;
    return mission::number_parameter(mission_.types[type], "navigation_success_radius",
                                     mission::kDefaultSuccessRadius);
  }

  // Of who needs most: where he can't come to, the unit does not arrive.
  WayCheck::Room most_room(const UnitCommand& c) {
    WayCheck::Room out;
    for (const base::RobotId id : robots_of(c)) {
      if (visits_++ >= kMaxRobotVisits) break;
      const WayCheck::Room room = room_of(id);
      const bool keeps_out = out.keeps_out || room.keeps_out;
      if (room.half() > out.half()) out = room;
      out.keeps_out = keeps_out;
    }
    return out;
  }

  // What robots that plan their ways keep from things where there is least room; others may touch them.
  WayCheck::Room room_of(base::RobotId id) const {
    const mission::RobotType& type = mission_.types[mission_.robots[index_of_.at(id.value)].type];
    const double radius = body_radius(id);
    if (!formations_.plans_ways(type)) return {radius, 0.0, false};
    const double margin =
        mission::number_parameter(type, "avoid_obstacle_safety_margin", mission::kDefaultMargin);
    return {radius, ways::Clearances(0.0, std::max(margin, 0.0)).least(), true};
  }

  double body_radius(base::RobotId id) const {
    const std::uint32_t type = mission_.robots[index_of_.at(id.value)].type;
    while (radius_of_type_.size() <= type) {
      radius_of_type_.push_back(mission::number_parameter(mission_.types[radius_of_type_.size()],
                                                          "robot_radius", mission::kDefaultBodyRadius));
    }
    return radius_of_type_[type];
  }

  const mission::Mission& mission_;
  text::Diagnostics& diagnostics_;
  FormationCheck formations_;
  GoalCheck goals_;
  FenceCheck fences_;
  WayCheck ways_;
  std::vector<RobotState> robots_;
  std::unordered_map<std::uint32_t, std::uint32_t> index_of_;  // by robot's number
  std::map<std::string, const mission::Step*> labels_;
  std::set<std::pair<std::string_view, std::uint32_t>> warned_;
  std::set<std::pair<std::string_view, std::vector<base::RobotId>>> warned_robots_;
  mutable std::vector<double> radius_of_type_;
  mission::Options options_ = mission_.options;  // in force at this point of the plan
  std::uint64_t visits_ = 0;
  std::uint32_t step_ = 0;
  int searches_ = 0;
  bool quits_ = false;
  bool is_one_step_ = false;
};

}  // namespace

void check_plan(const mission::Mission& mission, text::Diagnostics& diagnostics) {
  PlanCheck(mission, diagnostics).run();
}

void check_commands_of_one_step(const std::vector<mission::Command>& commands,
                                const mission::Mission& mission, text::Diagnostics& diagnostics) {
  PlanCheck check(mission, diagnostics);
  check.look_at_one_step();
  check.commands(commands);
}

}  // namespace mlab::mdl
