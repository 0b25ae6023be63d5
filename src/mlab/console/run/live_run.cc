#include "mlab/console/run/live_run.h"

#include <utility>
#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mlab/base/angle.h"
#include "mlab/lang/mdl/options.h"
#include "mlab/mission/command.h"
#include "mlab/run/report.h"

namespace mlab::console {

using mission::effect::Tell;

LiveRun::LiveRun(std::shared_ptr<const run::Crew> crew, std::unique_ptr<run::MissionRun> run, EventLog& log,
                 std::unique_ptr<history::Recorder> recorder)
    : crew_(std::move(crew)),
      run_(std::move(run)),
      log_(log),
      recorder_(std::move(recorder)),
      options_(run_->mission().options) {
  run_->set_observer([this](const mission::Effect& effect) { see(effect); });
  for (const mission::Print& wanted : run_->mission().prints) print(wanted.robot_info);
}

LiveRun::~LiveRun() {
  if (recorder_) recorder_->end(run::outcome_name(*run_, run::RunEnd::kInterrupted));
}

// When there is one, and when it does not go on.
void LiveRun::tell_recording() {
  if (const std::string& path = recorder_->path(); path != told_path_) {
    told_path_ = path;
    log_.add(run_->time(), {Log::MESSAGE, fmt::format("this run is recorded in {}", path), 0, "", {}, false});
  }
  if (const std::string& problem = recorder_->problem(); problem != told_problem_) {
    told_problem_ = problem;
    log_.add(run_->time(), {Log::WARNING,
                            fmt::format("the recording of this run does not go on: {}", problem),
                            0,
                            "",
                            {},
                            true});
  }
}

void LiveRun::edit(std::shared_ptr<const run::Crew> crew) {
  crew_ = std::move(crew);
  run_->edit(crew_);
  transitions_.change(*run_);
  has_news_ = true;
}

std::expected<run::Takeover, std::string> LiveRun::take_over(std::shared_ptr<const run::Crew> crew) {
  auto out = run_->take_over(crew);
  if (out) crew_ = std::move(crew);
  transitions_.change(*run_);
  has_news_ = true;
  return out;
}

run::MissionRun::Progress LiveRun::step() {
  const run::MissionRun::Progress progress = run_->step();
  if (recorder_) {
    if (progress == run::MissionRun::Progress::kStepped)
      recorder_->note_cycle();
    else
      recorder_->note_rest();
    tell_recording();
  }
  estimates_.look(run_->state());
  if (progress != run::MissionRun::Progress::kStepped) return progress;
  alarms_.look(*run_, log_);
  trails_.look(*run_);
  series_.look(*run_);
  transitions_.look(*run_);
  return progress;
}

bool LiveRun::was_started() const {
  return !run_->state().steps.empty() || run_->state().mode != mission::State::Mode::kIdle ||
         run_->cycle() > 0;
}

void LiveRun::see(const mission::Effect& effect) {
  has_news_ = true;
  if (recorder_) recorder_->see(effect);
  if (const auto* told = std::get_if<Tell>(&effect)) tell(*told);
  if (const auto* ask = std::get_if<mission::effect::Ask>(&effect)) {
    asked_[ask->question] = run_->time();
    texts_[ask->question] = ask->text;
    const bool is_robots = ask->robot.value != 0;
    log_.add(run_->time(), {Log::MESSAGE,
                            ask->text,
                            ask->robot.value,
                            is_robots ? std::string() : run_->state().commands[ask->command].unit,
                            {},
                            false});
  }
  if (const auto* set = std::get_if<mission::effect::Set>(&effect))
    std::visit([&](const auto& option) { mdl::apply_set(option, options_); }, set->option);
  if (const auto* wanted = std::get_if<mission::effect::Print>(&effect)) print(wanted->robot_info);
}

void LiveRun::tell(const Tell& told) {
  constexpr Log::Kind kKinds[] = {Log::STEP,    Log::STEP,    Log::COMMAND, Log::COMMAND,
                                  Log::MESSAGE, Log::WARNING, Log::MISSION};
  EventLog::Entry entry;
  entry.kind = kKinds[static_cast<std::size_t>(told.kind)];
  entry.text = told.text;
  entry.is_alert = told.kind == Tell::Kind::kWarning;
  const mission::State& state = run_->state();
  const bool of_command = told.kind == Tell::Kind::kCommandStarted || told.kind == Tell::Kind::kCommandEnded;
  if (of_command && told.command < state.commands.size()) {
    const mission::CommandRecord& record = state.commands[told.command];
    entry.unit = record.unit;
    entry.is_alert = record.outcome == mission::Outcome::kFailed;
    for (const mission::Run& run : state.runs) {
      if (run.record == told.command && !run.command->place_name.empty())
        entry.place = mission::goal_of(*run.command);
    }
  }
  log_.add(run_->time(), std::move(entry));
}

void LiveRun::print(bool robot_info) {
  const auto say = [&](std::string text) {
    log_.add(run_->time(), {Log::MESSAGE, std::move(text), 0, "", {}, false});
  };
  if (robot_info) {
    for (const fleet::FleetRobot& robot : run_->fleet().robots()) {
      const geom::Pose pose = run_->fleet().pose(robot);
      log_.add(run_->time(), {Log::MESSAGE,
                              fmt::format("robot {}: {}, {}, at ({:.2f}, {:.2f}), heading {:.1f} deg",
                                          robot.id.value, robot.type, name(robot.life), pose.position.x,
                                          pose.position.y, base::degrees(pose.heading)),
                              robot.id.value, "", pose.position, false});
    }
    return;
  }
  for (const overlay::ControlMeasure& measure : run_->mission().overlay.measures) {
    const geom::Point at = measure.center();
    log_.add(run_->time(),
             {Log::MESSAGE,
              fmt::format("{} {} at ({:.2f}, {:.2f})", keyword(measure.kind), measure.name, at.x, at.y), 0,
              "", at, false});
  }
  for (const mission::Unit& unit : run_->mission().units) {
    if (unit.name.empty()) continue;
    std::vector<std::uint32_t> ids;
    for (const base::RobotId id : unit.members) ids.push_back(id.value);
    say(fmt::format("unit {}: robots {}", unit.name, fmt::join(ids, " ")));
  }
}

}  // namespace mlab::console
