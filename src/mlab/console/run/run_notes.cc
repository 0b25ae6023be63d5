#include "mlab/console/run/run_notes.h"

#include <variant>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mlab/base/angle.h"
#include "mlab/lang/mdl/options.h"
#include "mlab/mission/command.h"

namespace mlab::console {

using mission::effect::Tell;

RunNotes::RunNotes(const run::MissionRun& run, EventLog& log)
    : run_(run), log_(&log), options_(run.mission().options) {
  const std::uint64_t before = log_->last();
  for (const mission::Print& wanted : run_.mission().prints) print(wanted.robot_info);
  told_ += log_->last() - before;
}

void RunNotes::change() {
  transitions_.change(run_);
  has_news_ = true;
}

void RunNotes::look(bool has_stepped) {
  estimates_.look(run_.state());
  if (has_stepped) note_cycle(*log_);
}

void RunNotes::look_again(bool is_known) {
  estimates_.look(run_.state());
  EventLog known;
  note_cycle(is_known ? known : *log_);
}

void RunNotes::note_cycle(EventLog& alarms) {
  alarms_.look(run_, alarms);
  trails_.look(run_);
  series_.look(run_);
  transitions_.look(run_);
}

void RunNotes::see(const mission::Effect& effect) {
  has_news_ = true;
  const std::uint64_t before = log_->last();
  add_seen(effect);
  told_ += log_->last() - before;
}

void RunNotes::add_seen(const mission::Effect& effect) {
  if (const auto* told = std::get_if<Tell>(&effect)) tell(*told);
  if (const auto* ask = std::get_if<mission::effect::Ask>(&effect)) {
    asked_[ask->question] = run_.time();
    texts_[ask->question] = ask->text;
    const bool is_robots = ask->robot.value != 0;
    log_->add(run_.time(), {Log::MESSAGE,
                            ask->text,
                            ask->robot.value,
                            is_robots ? std::string() : run_.state().commands[ask->command].unit,
                            {},
                            false});
  }
  if (const auto* set = std::get_if<mission::effect::Set>(&effect))
    std::visit([&](const auto& option) { mdl::apply_set(option, options_); }, set->option);
  if (const auto* wanted = std::get_if<mission::effect::Print>(&effect)) print(wanted->robot_info);
}

void RunNotes::tell(const Tell& told) {
  constexpr Log::Kind kKinds[] = {Log::STEP,    Log::STEP,    Log::COMMAND, Log::COMMAND,
                                  Log::MESSAGE, Log::WARNING, Log::MISSION};
  EventLog::Entry entry;
  entry.kind = kKinds[static_cast<std::size_t>(told.kind)];
  entry.text = told.text;
  entry.is_alert = told.kind == Tell::Kind::kWarning;
  const mission::State& state = run_.state();
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
  log_->add(run_.time(), std::move(entry));
}

void RunNotes::print(bool robot_info) {
  const auto say = [&](std::string text) {
    log_->add(run_.time(), {Log::MESSAGE, std::move(text), 0, "", {}, false});
  };
  if (robot_info) {
    for (const fleet::FleetRobot& robot : run_.fleet().robots()) {
      const geom::Pose pose = run_.fleet().pose(robot);
      log_->add(run_.time(), {Log::MESSAGE,
                              fmt::format("robot {}: {}, {}, at ({:.2f}, {:.2f}), heading {:.1f} deg",
                                          robot.id.value, robot.type, name(robot.life), pose.position.x,
                                          pose.position.y, base::degrees(pose.heading)),
                              robot.id.value, "", pose.position, false});
    }
    return;
  }
  for (const overlay::ControlMeasure& measure : run_.mission().overlay.measures) {
    const geom::Point at = measure.center();
    log_->add(run_.time(),
              {Log::MESSAGE,
               fmt::format("{} {} at ({:.2f}, {:.2f})", keyword(measure.kind), measure.name, at.x, at.y), 0,
               "", at, false});
  }
  for (const mission::Unit& unit : run_.mission().units) {
    if (unit.name.empty()) continue;
    std::vector<std::uint32_t> ids;
    for (const base::RobotId id : unit.members) ids.push_back(id.value);
    say(fmt::format("unit {}: robots {}", unit.name, fmt::join(ids, " ")));
  }
}

}  // namespace mlab::console
