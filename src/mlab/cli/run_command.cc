#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <variant>

#include <fmt/core.h>

#include "mlab/cli/clock.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/files.h"
#include "mlab/cli/plot.h"
#include "mlab/cli/run_screen.h"
#include "mlab/cli/run_settings.h"
#include "mlab/cli/version.h"
#include "mlab/fleet/mission_run.h"
#include "mlab/fleet/report.h"
#include "mlab/lang/envchange/envchange.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/text/shown.h"

namespace mlab::cli {
namespace {

volatile std::sig_atomic_t run_interrupts = 0;

// The first Ctrl-C ends the run in an orderly way; who presses it again wants out at once.
void on_run_interrupt(int) {
  run_interrupts = run_interrupts + 1;
  if (run_interrupts > 1) _exit(kFailed);
}

// One line of standard input, without blocking for longer than `wait_ms`.
class Answers {
 public:
  enum class Kind { kNone, kLine, kEnd };
  Kind poll_line(int wait_ms, std::string& line) {
    if (const std::size_t end = pending_.find('\n'); end != std::string::npos) {
      line = pending_.substr(0, end);
      pending_.erase(0, end + 1);
      return Kind::kLine;
    }
    if (is_over_) return Kind::kEnd;
    pollfd fd{STDIN_FILENO, POLLIN, 0};
    if (::poll(&fd, 1, wait_ms) <= 0) return Kind::kNone;
    char block[512];
    const ssize_t n = ::read(STDIN_FILENO, block, sizeof block);
    if (n > 0) {
      pending_.append(block, static_cast<std::size_t>(n));
    } else {
      is_over_ = true;
      if (!pending_.empty()) pending_ += '\n';
    }
    return poll_line(0, line);
  }

 private:
  std::string pending_;
  bool is_over_ = false;
};

// The operator at a terminal: shows what is asked and takes the answers.
class TerminalOperator {
 public:
  TerminalOperator(fleet::MissionRun& run, RunScreen& screen) : run_(run), screen_(screen) {}

  void see(const mission::Effect& effect) {
    if (const auto* ask = std::get_if<mission::effect::Ask>(&effect)) {
      asked_[ask->question] = ask->text;
      is_prompted_ = false;
    }
    if (const auto* gone = std::get_if<mission::effect::Withdraw>(&effect)) {
      if (is_prompted_ && !asked_.empty() && asked_.begin()->first == gone->question) {
        fmt::print("\n");
        is_prompted_ = false;
      }
      asked_.erase(gone->question);
    }
    const auto* told = std::get_if<mission::effect::Tell>(&effect);
    if (told != nullptr && told->kind == mission::effect::Tell::Kind::kCommandEnded && teleoperated_ &&
        run_.state().commands[told->command].unit == run_.mission().units[*teleoperated_].name)
      teleoperated_.reset();
    if (const auto* open = std::get_if<mission::effect::OpenTeleoperation>(&effect)) {
      teleoperated_ = open->unit;
      screen_.line(fmt::format("  unit {} is teleoperated, and there is no stick here: press Enter to end it",
                               text::shown(run_.mission().units[open->unit].name)));
    }
  }
  bool is_needed() const { return !asked_.empty() || teleoperated_.has_value(); }
  // A unit is under the stick: nothing but a person ends that.
  bool is_steering() const { return teleoperated_.has_value(); }

  // Asks and waits for at most `wait_ms`. False where nobody is left to answer.
  bool attend(int wait_ms) {
    if (!asked_.empty() && !std::exchange(is_prompted_, true)) {
      screen_.clear_progress();
      fmt::print("{} [y/n] ", text::shown(asked_.begin()->second, 200));
      std::fflush(stdout);
    }
    std::string line;
    const Answers::Kind kind = answers_.poll_line(wait_ms, line);
    if (kind == Answers::Kind::kEnd) {
      if (!asked_.empty() && !std::exchange(is_over_, true)) fmt::print("\n");
      return false;
    }
    if (kind == Answers::Kind::kLine) {
      if (isatty(STDIN_FILENO) == 0) fmt::print("{}\n", text::shown(line));
      take(line);
    }
    return true;
  }

 private:
  void take(std::string line) {
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
    if (asked_.empty()) {
      if (teleoperated_)
        run_.post(mission::event::TeleoperationComplete{*std::exchange(teleoperated_, std::nullopt)});
      return;
    }
    is_prompted_ = false;
    const bool yes = line == "y" || line == "Y" || line == "yes" || line == "proceed" || line == "PROCEED";
    const bool no = line == "n" || line == "N" || line == "no" || line == "abort" || line == "ABORT";
    if (!yes && !no) {
      screen_.line("  y lets the unit proceed, n aborts the mission");
      return;
    }
    const std::uint32_t question = asked_.begin()->first;
    asked_.erase(asked_.begin());
    run_.post(mission::event::Answer{question, yes});
  }

  fleet::MissionRun& run_;
  RunScreen& screen_;
  Answers answers_;
  std::map<std::uint32_t, std::string> asked_;
  std::optional<std::uint32_t> teleoperated_;
  bool is_prompted_ = false;
  bool is_over_ = false;  // nobody will answer any more
};

struct Prepared {
  std::unique_ptr<fleet::MissionRun> run;
  MissionClock clock;
  double speed = 0.0;
};

// Everything that can be wrong before the first cycle. Diagnostics are printed here.
std::optional<Prepared> prepare(const RunOptions& options, int& status) {
  status = kBadInput;
  Prepared out;
  std::optional<RunManner> manner = run_manner(options, 0.0);
  if (!manner) return std::nullopt;
  out.clock = manner->clock;
  out.speed = manner->speed;
  text::Diagnostics sink;
  const std::shared_ptr<const mission::Mission> mission =
      mdl::load_mission(options.mission, sink, {options.seed, overlay_folders()});
  if (mission) {
    fleet::RunSettings& settings = manner->settings;
    const robot::ProgramSources sources =
        program_sources(std::filesystem::path(options.mission).parent_path().string(), options.allow_native);
    if (!options.environment.empty()) {
      settings.environment = envchange::load(options.environment, mission->overlay.origin, sink)
                                 .value_or(overlay::EnvironmentChanges{});
    }
    if (!sink.has_errors()) out.run = fleet::MissionRun::create(mission, sources, settings, sink);
  }
  fmt::print(stderr, "{}", text::render(sink));
  if (!out.run) return std::nullopt;
  if (options.strict && sink.warning_count() > 0) {
    fmt::print(stderr, "mlab run: not run, because of {} warning{} and --strict\n", sink.warning_count(),
               sink.warning_count() == 1 ? "" : "s");
    status = kFailed;
    return std::nullopt;
  }
  return out;
}

// Steps until the mission has ended or somebody ends it. True where it was interrupted.
bool carry_out(Prepared& prepared, const RunOptions& options, RunScreen& screen, TerminalOperator& person,
               Plot& plot) {
  fleet::MissionRun& run = *prepared.run;
  const double began = steady_seconds();
  double idle = 0.0;  // time that passed while the simulation stood still does not count against its pace
  run.post(mission::event::Execute{});
  while (run_interrupts == 0) {
    if (options.limit && run.time() >= *options.limit) {
      screen.line(fmt::format("[{:9.1f} s] ended by --limit", run.time()));
      return true;
    }
    const fleet::MissionRun::Progress progress = run.step();
    if (progress == fleet::MissionRun::Progress::kOver) return false;
    screen.show_progress(run);
    if (!options.plot.empty()) plot.note(run);
    const bool waits = progress == fleet::MissionRun::Progress::kWaits;
    if (person.is_needed()) {
      const double before = steady_seconds();
      // A question that answers itself needs nobody.
      if (!person.attend(waits ? 100 : 0) &&
          (person.is_steering() || mission::awaits_only_operator(run.state()))) {
        screen.line(
            "no answer: standard input has ended. The mission is aborted; --proceed answers every question "
            "with yes");
        run.post(mission::event::Abort{});
        return false;
      }
      if (waits) idle += steady_seconds() - before;
    } else if (waits) {
      return false;
    }
    if (prepared.speed > 0.0) {
      const double ahead = run.time() / prepared.speed - (steady_seconds() - began - idle);
      if (ahead > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(std::min(ahead, 1.0)));
    }
  }
  return true;
}

}  // namespace

int run(const RunOptions& options) {
  if (!options.headless) return run_console(options);
  if (options.mission.empty()) return usage_error("--headless: expected a mission file (.mdl)");
  int status = kDone;
  std::optional<Prepared> prepared = prepare(options, status);
  if (!prepared) return status;
  fleet::MissionRun& run = *prepared->run;
  RunScreen screen(options.quiet);
  TerminalOperator person(run, screen);
  Plot plot;
  run.set_observer([&](const mission::Effect& effect) {
    screen.show(run, effect);
    person.see(effect);
  });
  std::signal(SIGINT, on_run_interrupt);
  std::signal(SIGTERM, on_run_interrupt);

  fleet::Performance performance;
  performance.started_at = print(wall_clock());
  performance.mission_clock = print(prepared->clock);
  performance.program_version = kVersion;
  screen.show_start(run);
  const double began = steady_seconds();
  const double cpu_began = cpu_seconds();
  const bool interrupted = carry_out(*prepared, options, screen, person, plot);
  performance.wall_seconds = steady_seconds() - began;
  performance.cpu_seconds = cpu_seconds() - cpu_began;

  const std::string outcome = fleet::outcome_name(run, interrupted);
  screen.show_summary(run, outcome, performance.wall_seconds);
  if (!options.report.empty() &&
      !deliver("report", options.report, fleet::report_json(run, performance, interrupted)))
    return kFailed;
  if (!options.plot.empty() && !deliver("plot", options.plot, plot.svg(run))) return kFailed;
  return outcome == "done" ? kDone : kFailed;
}

}  // namespace mlab::cli
