#include "mlab/study/one_run.h"

#include <algorithm>
#include <set>
#include <string>
#include <variant>

#include <fmt/core.h>

#include "mlab/mission/executive.h"

namespace mlab::study {
namespace {

// What a person would have to do, and nobody does.
class Unattended {
 public:
  void see(const mission::Effect& effect) {
    if (const auto* ask = std::get_if<mission::effect::Ask>(&effect)) asked_.insert(ask->question);
    if (const auto* gone = std::get_if<mission::effect::Withdraw>(&effect)) asked_.erase(gone->question);
    const auto* told = std::get_if<mission::effect::Tell>(&effect);
    if (told != nullptr && told->kind == mission::effect::Tell::Kind::kCommandEnded)
      steered_.erase(told->command);
    if (const auto* open = std::get_if<mission::effect::OpenTeleoperation>(&effect))
      steered_.insert(open->command);
  }
  bool is_needed() const { return !asked_.empty() || !steered_.empty(); }
  // Nothing but a person moves things on.
  bool is_waited_for_in_vain(const mission::State& state) const {
    return mission::awaits_only_operator(state) ||
           std::ranges::any_of(state.runs, [this](const mission::Run& run) {
             return steered_.contains(run.record) && !run.ends;
           });
  }

 private:
  std::set<std::uint32_t> asked_;
  std::set<std::uint32_t> steered_;  // commands
};

struct Cause {
  std::string text;
  std::string message;
};

// Of the first command that failed.
std::optional<Cause> failed_command(const mission::State& state) {
  for (const mission::StepRecord& step : state.steps) {
    for (std::uint32_t i = 0; i < step.command_count; ++i) {
      const mission::CommandRecord& record = state.commands[step.first_command + i];
      if (record.outcome != mission::Outcome::kFailed) continue;
      const std::string where =
          step.label.empty() ? record.text : fmt::format("step {}: {}", step.label, record.text);
      return Cause{fmt::format("{}: {}", where, name(record.failure)),
                   fmt::format("{}: {}", where, record.message)};
    }
  }
  return std::nullopt;
}

std::optional<Cause> fault(const run::MissionRun& run) {
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    const fleet::Fault kind = fault_of(robot);
    if (kind == fleet::Fault::kNone) continue;
    return Cause{fmt::format("a robot stands: {}", name(kind)),
                 fmt::format("robot {}: {}", robot.id.value, failure_of(robot))};
  }
  return std::nullopt;
}

Cause cause_of(const run::MissionRun& run, const Row& row, const Definition& definition) {
  if (auto command = failed_command(run.state()); command && row.outcome == "failed") return *command;
  if (auto broken = fault(run); broken && row.outcome == "failed") return *broken;
  if (row.outcome == "interrupted" && definition.limit) {
    const std::string text = fmt::format("not over after {} s (limit)", *definition.limit);
    return {text, text};
  }
  if (definition.success && row.outcome == "done") {
    const std::string text = "not so: " + definition.success->unfulfilled(row);
    return {text, text};
  }
  return {row.outcome, row.outcome};
}

void measure_formations(const run::MissionRun& run, Row& row) {
  run::UnitMetrics all;
  double straight = 0.0;
  for (const run::UnitMetrics& unit : run.unit_metrics()) {
    all.error_sum += unit.error_sum;
    all.max_error = std::max(all.max_error, unit.max_error);
    all.samples += unit.samples;
    all.driven += unit.driven;
    straight += unit.straight();
    all.out_of_formation += unit.out_of_formation;
  }
  if (all.samples == 0) return;
  row[Number::kFormationError] = all.mean_error();
  row[Number::kWorstFormationError] = all.max_error;
  row[Number::kOutOfFormation] = all.out_share();
  if (straight > 0.0) row[Number::kPathRatio] = all.driven / straight;
}

void measure_robots(const run::MissionRun& run, Row& row) {
  double distance = 0.0;
  double contacts = 0.0;
  double faults = 0.0;
  for (const fleet::FleetRobot& robot : run.fleet().robots()) {
    if (!failure_of(robot).empty()) faults += 1.0;
    if (robot.life == fleet::RobotLife::kNotStarted) continue;
    const binding::BodyState body = run.world().body(robot.body);
    distance += body.distance_driven;
    contacts += static_cast<double>(body.contacts);
  }
  row[Number::kDistance] = distance;
  row[Number::kContacts] = contacts;
  row[Number::kFaults] = faults;
}

}  // namespace

std::optional<run::RunEnd> carry_out(run::MissionRun& run, const Definition& definition,
                                     const std::function<bool()>& wants_end, history::Recorder* recorder) {
  Unattended person;
  run.set_observer([&](const mission::Effect& effect) {
    person.see(effect);
    if (recorder != nullptr) recorder->see(effect);
  });
  run.set_meanwhile(wants_end);
  run.post(mission::event::Execute{});
  std::optional<run::RunEnd> end;
  while (!end) {
    if (wants_end()) break;
    if (definition.limit && run.time() >= *definition.limit) {
      end = run::RunEnd::kInterrupted;
      break;
    }
    if (definition.duration && run.time() >= *definition.duration) {
      end = run::RunEnd::kTimeIsUp;
      break;
    }
    const run::MissionRun::Progress progress = run.step();
    if (recorder != nullptr && progress == run::MissionRun::Progress::kStepped) recorder->note_cycle();
    if (progress == run::MissionRun::Progress::kOver) end = run::RunEnd::kByItself;
    if (person.is_needed() && !end) {
      if (!person.is_waited_for_in_vain(run.state())) continue;
      run.post(mission::event::Abort{});
      end = run::RunEnd::kByItself;
    } else if (progress == run::MissionRun::Progress::kWaits) {
      end = run::RunEnd::kByItself;
    }
  }
  run.set_observer({});
  run.set_meanwhile({});
  return end;
}

Row row_of(const run::MissionRun& run, run::RunEnd end, const Definition& definition) {
  Row row;
  row.seed = run.seed();
  row.outcome = run::outcome_name(run, end);
  row[Number::kDuration] = run.time();
  row[Number::kStepsDone] = static_cast<double>(run.steps_done());
  row[Number::kDeliveries] = static_cast<double>(run.deliveries().size());
  row[Number::kFailsafes] = static_cast<double>(run.failsafes().size());
  measure_robots(run, row);
  measure_formations(run, row);
  // As in the report: micrometres and microseconds are more than anybody reads.
  for (double& number : row.numbers) number = std::round(number * 1e6) / 1e6;
  row.success = definition.success ? definition.success->holds(row) : row.outcome == "done";
  if (!row.success) {
    Cause cause = cause_of(run, row, definition);
    row.cause = std::move(cause.text);
    row.message = std::move(cause.message);
  }
  return row;
}

Row row_of_none(const std::string& why) {
  Row row;
  row.outcome = "not run";
  row.cause = "could not be run: " + why;
  row.message = row.cause;
  return row;
}

}  // namespace mlab::study
