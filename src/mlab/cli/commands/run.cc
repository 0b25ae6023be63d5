#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include <fmt/core.h>

#include "mlab/agents/ending_watchdog.h"
#include "mlab/base/counted.h"
#include "mlab/cli/clock.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/files.h"
#include "mlab/cli/fleet_stop.h"
#include "mlab/cli/fleet_words.h"
#include "mlab/cli/input.h"
#include "mlab/cli/interrupt.h"
#include "mlab/cli/other_language.h"
#include "mlab/cli/output.h"
#include "mlab/cli/permission.h"
#include "mlab/cli/plot.h"
#include "mlab/cli/run_bodies.h"
#include "mlab/cli/run_recording.h"
#include "mlab/cli/run_screen.h"
#include "mlab/cli/run_settings.h"
#include "mlab/cli/terminal.h"
#include "mlab/cli/terminal_operator.h"
#include "mlab/cli/version.h"
#include "mlab/lang/envchange/envchange.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/run/mission_run.h"
#include "mlab/run/pace.h"
#include "mlab/run/report.h"

namespace mlab::cli {
namespace {

// Until the time is over, or until somebody wants an end.
void pass_time(double seconds) {
  const double end = steady_seconds() + seconds;
  while (!was_interrupted() && steady_seconds() < end)
    std::this_thread::sleep_for(std::chrono::duration<double>(std::min(0.1, end - steady_seconds())));
}

struct Prepared {
  RunBodies bodies;
  std::unique_ptr<run::MissionRun> run;
  MissionClock clock;
  double speed = 0.0;
  std::shared_ptr<run::StopLine> stop_line;  // null: there is none
  std::shared_ptr<preflight::Gate> gate;     // before vehicles; null: there are none
  text::Diagnostics warnings;                // of loading
  std::unique_ptr<RunRecording> recording;   // null: the run is not recorded
};

std::shared_ptr<const mission::Mission> load(const RunOptions& options, const robot::ProgramSources& sources,
                                             std::vector<mdl::Setting> settings, text::Diagnostics& sink) {
  mdl::LoadOptions around = load_options(options, sources);
  around.settings = std::move(settings);
  if (!is_standard_input(options.mission)) return mdl::load_mission(options.mission, sink, around);
  const text::Result<text::SourcePtr> source = read_input(options.mission);
  if (source) return mdl::check_mission(*source, "", sink, around);
  sink.report(source.error());
  return nullptr;
}

// Everything that can be wrong before the first cycle. Diagnostics are printed here.
std::optional<Prepared> prepare(RunOptions options, int& status) {
  status = kBadInput;
  Prepared out;
  if (!out.bodies.open(options)) return std::nullopt;
  std::optional<RunManner> manner = run_manner(options, 0.0);
  if (!manner) return std::nullopt;
  out.clock = manner->clock;
  out.speed = manner->speed;
  out.stop_line = manner->settings.stop_line;
  out.gate = manner->gate;
  text::Diagnostics& sink = out.warnings;
  const std::string folder = std::filesystem::path(options.mission).parent_path().string();
  robot::ProgramSources sources =
      mission_sources(options, permission_to_run(options, cell::Grounds::People::kHere, folder));
  sources.is_vehicle = manner->settings.is_vehicle;
  auto set = settings_of(options);
  if (!set) return std::nullopt;
  const std::shared_ptr<const mission::Mission> mission = load(options, sources, std::move(*set), sink);
  if (mission) {
    run::RunSettings& settings = manner->settings;
    settings.goes_on_when_done = options.duration.has_value();
    if (!options.environment.empty()) {
      const text::Result<text::SourcePtr> source = read_input(options.environment);
      if (!source) sink.report(source.error());
      if (source)
        settings.environment =
            envchange::parse(*source, mission->overlay.origin, sink).value_or(overlay::EnvironmentChanges{});
    }
    if (!sink.has_errors()) out.run = out.bodies.make_run(mission, sources, settings, sink);
  }
  tell(told_of_run(sink, options));
  if (!out.run) return std::nullopt;
  if (options.strict && sink.warning_count() > 0) {
    fmt::print(stderr, "mlab run: not run, because of {} and --strict\n",
               base::counted(sink.warning_count(), "warning"));
    status = kFailed;
    return std::nullopt;
  }
  return out;
}

// Whether the vehicles are checked; what is against it is said here.
bool may_start(const Prepared& prepared) {
  const std::string why = prepared.gate ? prepared.gate->why_not_start(*prepared.run->crew()) : "";
  if (!why.empty()) fmt::print(stderr, "mlab run: {}\n", why);
  return why.empty();
}

// Starts the mission. What its vehicles were let pass by is in the log, and in the recording, which begins
// then.
void execute(const Prepared& prepared, RunScreen& screen) {
  const preflight::Gate::Passed passed = prepared.gate ? prepared.gate->passed() : preflight::Gate::Passed{};
  if (!passed.said.empty())
    screen.line(fmt::format("[{:9.1f} s] {}{}", prepared.run->time(),
                            passed.is_unchecked ? colored("warning: ", Color::kWarning) : "", passed.said));
  prepared.run->post(mission::event::Execute{});
  if (!passed.said.empty() && prepared.recording)
    prepared.recording->put_metadata({"preflight", {{"said", passed.said}, {"checklist", passed.checklist}}});
}

void start_recording(const RunOptions& options, Prepared& prepared) {
  if (options.record.empty()) return;
  prepared.recording = std::make_unique<RunRecording>(
      options.record, *prepared.run,
      history::Circumstances{kVersion, overlay_folders(), options.seed, wall_clock().epoch_seconds},
      options.records_for_viewers ? options.viewer_rate : 0.0);
}

/// Follows the emergency stop that the run shares with its fleet.
class SharedStop {
 public:
  SharedStop(run::MissionRun& run, RunScreen& screen, run::StopLine* line, const NetworkOptions& network)
      : run_(run), screen_(screen), line_(line), network_(network) {}

  void follow() {
    if (line_ == nullptr) return;
    line_->hear();
    for (const std::string& alert : line_->take_alerts()) say(colored("alert: ", Color::kBad) + alert);
    const run::StopLine::State state = line_->state();
    if (state.is_engaged != run_.is_stopped()) change(state);
    if (state.is_engaged && steady_seconds() - since_ > kConfirming) tell_unreached();
  }

 private:
  static constexpr double kConfirming = 1.0;  // who has not said by then that his robots stand is named [s]

  void change(const run::StopLine::State& state) {
    run_.set_emergency_stop(state.is_engaged);
    since_ = steady_seconds();
    told_.clear();
    say(state.is_engaged ? fmt::format("EMERGENCY STOP by {}: all robots stand; `{}` releases it", state.by,
                                       release_command(network_))
                         : fmt::format("the emergency stop was released by {}", state.by));
  }
  void tell_unreached() {
    std::vector<std::string> names;
    std::string listed;
    for (const run::StopLine::Unreached& one : line_->unreached()) {
      names.push_back(one.name);
      listed +=
          fmt::format("{}`{}`{}", listed.empty() ? "" : ", ", one.name, about_unreached(one.by, one.silent));
    }
    if (names == told_) return;
    told_ = std::move(names);
    say(told_.empty()
            ? "the emergency stop is confirmed by all"
            : fmt::format("the emergency stop is not confirmed by {}: stop those robots by other means",
                          listed));
  }
  void say(const std::string& text) { screen_.line(fmt::format("[{:9.1f} s] {}", run_.time(), text)); }

  run::MissionRun& run_;
  RunScreen& screen_;
  run::StopLine* line_;
  const NetworkOptions& network_;
  double since_ = 0.0;
  std::vector<std::string> told_;
};

// Where it can't be kept any more somebody has to know now, and not when the run has ended.
void keep(const Prepared& prepared, run::MissionRun::Progress progress, RunScreen& screen) {
  if (!prepared.recording) return;
  prepared.recording->note(progress);
  if (const std::string problem = prepared.recording->take_problem(); !problem.empty())
    screen.line(fmt::format("[{:9.1f} s] {}the run goes on, and is not recorded any more: {}",
                            prepared.run->time(), colored("alert: ", Color::kBad), problem));
}

/// Returns when the next cycle of a run is due.
void wait_for_cycle(run::Pace& pace, const run::MissionRun& run) {
  const double now = steady_seconds();
  // Robots that nobody waits for could not follow cycles that are made up for.
  if (run.is_in_real_time())
    pace.forgive_all(now, run.time(), run.cycle_duration());
  else
    pace.forgive(now, run.time());
  if (const double ahead = pace.due(run.time()) - now; ahead > 0.0) pass_time(ahead);
}

// Steps until the mission has ended, its time is up or somebody ends it.
run::RunEnd carry_out(Prepared& prepared, const RunOptions& options, RunScreen& screen,
                      TerminalOperator& person, Plot& plot) {
  run::MissionRun& run = *prepared.run;
  run::Pace pace(prepared.speed);
  SharedStop stop(run, screen, prepared.stop_line.get(), options.network);
  if (prepared.stop_line) prepared.stop_line->settle();
  execute(prepared, screen);
  // The mission's clock has stood still until now.
  const auto go_on_from_here = [&] { pace.start(steady_seconds(), run.time()); };
  go_on_from_here();
  while (!was_interrupted()) {
    if (const double ahead = person.ahead(); ahead > 0.0) {
      person.attend(static_cast<int>(std::min(ahead * 1000.0, 100.0)) + 1);
      go_on_from_here();
      continue;
    }
    if (options.limit && run.time() >= *options.limit) {
      screen.line(fmt::format("[{:9.1f} s] ended by --limit", run.time()));
      return run::RunEnd::kInterrupted;
    }
    if (options.duration && run.time() >= *options.duration) {
      screen.line(fmt::format("[{:9.1f} s] the time is up (--for)", run.time()));
      return run::RunEnd::kTimeIsUp;
    }
    stop.follow();
    const run::MissionRun::Progress progress = run.step();
    keep(prepared, progress, screen);
    if (run.is_stopped()) {
      if (progress == run::MissionRun::Progress::kWaits) {
        pass_time(0.05);
        go_on_from_here();
      } else {
        wait_for_cycle(pace, run);
      }
      continue;
    }
    if (progress == run::MissionRun::Progress::kOver) return run::RunEnd::kByItself;
    screen.show_progress(run);
    if (!options.plot.empty()) plot.note(run);
    const bool waits = progress == run::MissionRun::Progress::kWaits;
    if (person.is_needed()) {
      // A question that answers itself needs nobody.
      if (!person.attend(waits ? 100 : 0) &&
          (person.is_steering() || mission::awaits_only_operator(run.state()))) {
        screen.line(
            "no answer: standard input has ended. The mission is aborted; --proceed answers every question "
            "with yes");
        run.post(mission::event::Abort{});
        return run::RunEnd::kByItself;
      }
      if (waits) go_on_from_here();
    } else if (waits) {
      return run::RunEnd::kByItself;
    }
    wait_for_cycle(pace, run);
  }
  return run::RunEnd::kInterrupted;
}

}  // namespace

int run(const RunOptions& options) {
  if (const std::string why = other_language(options.mission, {assist::Language::kMission}); !why.empty())
    return usage_error(why);
  if (options.headless && options.resume)
    return usage_error("--resume goes on with a run of the console, so without --headless");
  if (!options.headless) return settings_of(options) ? run_console(options) : kBadInput;
  if (options.mission.empty()) return usage_error("--headless: expected a mission file (.mdl)");
  int status = kDone;
  std::atomic<bool> may_hang = false;
  agents::EndingWatchdog watchdog(
      "mlab run", [&] { return may_hang && was_interrupted() ? std::optional(kFailed) : std::nullopt; });
  std::optional<Prepared> prepared = prepare(options, status);
  if (!prepared) return status;
  if (!may_start(*prepared)) return kFailed;
  start_recording(options, *prepared);
  run::MissionRun& run = *prepared->run;
  RunScreen screen(options.quiet);
  TerminalOperator person(run, screen);
  Plot plot;
  run.set_observer([&](const mission::Effect& effect) {
    screen.show(run, effect);
    person.see(effect);
    if (prepared->recording) prepared->recording->see(effect);
  });
  run.set_meanwhile(was_interrupted);
  note_interrupts();

  run::Performance performance;
  performance.started_at = print(wall_clock());
  performance.mission_clock = print(prepared->clock);
  performance.program_version = kVersion;
  screen.show_start(run);
  for (const mission::Print& wanted : run.mission().prints)
    screen.show(run, mission::effect::Print{wanted.robot_info});
  const double began = steady_seconds();
  const double cpu_began = cpu_seconds();
  may_hang = options.robots == RobotsAt::kFleet;
  const run::RunEnd end = carry_out(*prepared, options, screen, person, plot);
  may_hang = false;  // what is written from here on may take its time
  performance.wall_seconds = steady_seconds() - began;
  performance.cpu_seconds = cpu_seconds() - cpu_began;

  const std::string outcome = run::outcome_name(run, end);
  screen.show_summary(run, outcome, performance.wall_seconds);
  screen.show_warnings(prepared->warnings);
  const bool is_as_recorded = prepared->bodies.conclude();
  const bool is_recorded = !prepared->recording || prepared->recording->end("mlab run", outcome);
  if (!options.report.empty() &&
      !deliver("mlab run", "report", options.report, run::report_json(run, performance, end)))
    return kFailed;
  if (!options.plot.empty() && !deliver("mlab run", "plot", options.plot, plot.svg(run))) return kFailed;
  return watchdog.expect_end(outcome == "done" && is_as_recorded && is_recorded ? kDone : kFailed);
}

}  // namespace mlab::cli
