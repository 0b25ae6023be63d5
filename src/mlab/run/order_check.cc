#include "mlab/run/order_check.h"

#include <algorithm>
#include <set>
#include <variant>

#include <fmt/core.h>

#include "mlab/mission/command.h"
#include "mlab/mission/tasks.h"
#include "mlab/text/shown.h"

namespace mlab::run {
namespace {

using mission::Task;
using mission::UnitCommand;

class OrderCheck {
 public:
  OrderCheck(const Crew& crew, text::Diagnostics& sink) : crew_(crew), plan_(*crew.mission), sink_(sink) {}

  void run() {
    const UnitCommand* last_start = nullptr;
    bool is_only_started = true;
    for (const mission::Step& step : plan_.steps) {
      for (const mission::Command& command : step.commands) {
        const auto* one = std::get_if<UnitCommand>(&command);
        if (one == nullptr) continue;
        if (mission::info(one->task).awaits_report && !one->until) check_reports(*one);
        if (mission::info(one->task).is_shared) check_shares(*one);
        is_only_started &= one->task == Task::kStart || one->task == Task::kStop;
        if (one->task == Task::kStart && has_own_program(*one)) last_start = one;
      }
    }
    if (last_start != nullptr && is_only_started) warn_of_end(*last_start);
  }

 private:
  // The types of a unit's robots, each once.
  std::set<std::uint32_t> types_of(const UnitCommand& command) const {
    std::set<std::uint32_t> out;
    for (const base::RobotId id : mission::members_of(plan_, command)) {
      const auto robot = std::ranges::lower_bound(plan_.robots, id, {}, &mission::Robot::id);
      if (robot != plan_.robots.end() && robot->id == id) out.insert(robot->type);
    }
    return out;
  }

  bool has_own_program(const UnitCommand& command) const {
    return std::ranges::any_of(types_of(command),
                               [&](std::uint32_t type) { return crew_.programs[type].is_own; });
  }

  void check_reports(const UnitCommand& command) {
    for (const std::uint32_t type : types_of(command)) {
      const robot::RobotProgram& program = crew_.programs[type];
      if (!program.can_run() || program.tells.reports || !told_.insert(type).second) continue;
      sink_
          .warning(
              "never-reports", command.place,
              fmt::format("robots of the type `{}` never say how far they are with an order: this one fails "
                          "after long waiting",
                          text::shown(plan_.types[type].name)))
          .hints = {
          "a program says so by ReportArrival, ReportStatus, ReportFlags, ReportDone or ReportStep; robots "
          "that act by themselves "
          "are only started, and run with `mlab run --headless --for SECONDS`"};
    }
  }

  void check_shares(const UnitCommand& command) {
    for (const std::uint32_t type : types_of(command)) {
      const robot::RobotProgram& program = crew_.programs[type];
      if (!program.can_run() || !program.tells.reports || program.tells.shares || !idle_.insert(type).second)
        continue;
      const std::string_view word = mission::info(command.task).word;
      sink_
          .warning("never-shares", command.place,
                   fmt::format(
                       "robots of the type `{}` take no part in {}, whose work robots share among themselves",
                       text::shown(plan_.types[type].name), word))
          .hints = {
          "the standard robot does; a program takes its part by NextErrand or by the contract net "
          "(docs/coordination.md)"};
    }
  }

  void warn_of_end(const UnitCommand& start) {
    sink_
        .warning("only-started", start.place,
                 "no order follows START: the mission is over at once, and nothing else would end what its "
                 "robots do by themselves")
        .hints = {"`mlab run --headless --for SECONDS` lets them act so long, and ends as done"};
  }

  const Crew& crew_;
  const mission::Mission& plan_;
  text::Diagnostics& sink_;
  std::set<std::uint32_t> told_;  // types that never report, as told
  std::set<std::uint32_t> idle_;  // types that take no part, as told
};

}  // namespace

void check_orders(const Crew& crew, text::Diagnostics& sink) {
  OrderCheck(crew, sink).run();
}

}  // namespace mlab::run
