#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "mlab/cli/clock.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/interrupt.h"
#include "mlab/cli/places.h"
#include "mlab/cli/recorded_run.h"
#include "mlab/cli/run_screen.h"
#include "mlab/cli/run_settings.h"
#include "mlab/cli/runs_folder.h"
#include "mlab/cli/terminal.h"
#include "mlab/cli/version.h"
#include "mlab/documents/project_folder.h"
#include "mlab/history/history.h"
#include "mlab/history/recording_file.h"
#include "mlab/history/shelf.h"
#include "mlab/run/report.h"
#include "mlab/text/shown.h"

namespace mlab::cli {
namespace {

// What stands in the recording itself, for those that this program can't compute again.
void show_recorded(const history::History& history) {
  for (const history::EventEntry& event : history.events())
    fmt::print("[{:9.1f} s] {}{}\n", event.time, event.is_warning ? "warning: " : "",
               text::shown(event.text, 400));
  if (!history.poses().empty()) {
    const history::PosesEntry& last = history.poses().back();
    for (int i = 0; i < last.poses.robots_size(); ++i)
      fmt::print("  robot {}: at ({:.1f}, {:.1f}) after {:.1f} s\n", last.poses.robots(i), last.poses.x(i),
                 last.poses.y(i), last.time);
  }
  fmt::print("recorded: {} cycles, {:.1f} s{}\n", history.last_cycle(), history.last_time(),
             history.end() ? ", " + text::shown(history.end()->outcome) : "");
}

std::string size_text(std::uint64_t bytes) {
  return bytes < 1'000'000 ? fmt::format("{:.0f} kB", std::ceil(static_cast<double>(bytes) / 1e3))
                           : fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

// Those that the console has recorded, the newest first.
int list_runs(const ReplayOptions& options) {
  const std::string project =
      documents::ProjectFolder({options.project.empty() ? "." : options.project, ""}).folder();
  const std::vector<history::ShelvedRun> runs = history::Shelf(runs_folder(project)).runs();
  if (runs.empty()) {
    fmt::print(
        "No run of the project {} is recorded. The console records those that it carries out; "
        "`mlab run MISSION --headless --record FILE.mcap` records one, too.\n",
        project);
    return kDone;
  }
  for (const history::ShelvedRun& run : runs) {
    const auto summary = history::summarize_recording(run.path);
    const std::string what =
        !summary ? "can't be read: " + summary.error().message
                 : fmt::format("seed {}, {:.1f} s, {}", summary->seed, summary->length,
                               summary->outcome.empty() ? "cut off" : text::shown(summary->outcome));
    fmt::print("{}{}\n    {}, {}\n", run.path, run.is_marked ? " (kept)" : "", what, size_text(run.bytes));
  }
  return kDone;
}

// The console makes room by runs that have no mark.
int mark(const ReplayOptions& options) {
  const auto summary = history::summarize_recording(options.recording);
  if (!summary) {
    tell(summary.error());
    return kBadInput;
  }
  if (const auto marked = history::Shelf::set_mark(options.recording, options.keep); !marked) {
    fmt::print(stderr, "mlab replay: {}\n", marked.error());
    return kFailed;
  }
  fmt::print("{}: {}\n", options.recording, options.keep ? "kept" : "not kept for longer than others");
  return kDone;
}

bool compute(history::Replay& replay, RunScreen& screen) {
  run::MissionRun& run = replay.run();
  run.set_observer([&](const mission::Effect& effect) { screen.show(run, effect); });
  run.set_meanwhile(was_interrupted);
  note_interrupts();
  while (!was_interrupted() && replay.step()) screen.show_progress(run);
  screen.clear_progress();
  return !was_interrupted();
}

}  // namespace

int replay(const ReplayOptions& options) {
  if (options.recording.empty() && (options.keep || options.no_keep)) {
    fmt::print(stderr, "mlab replay: --keep and --no-keep: expected the recording that is meant\n");
    return kBadInput;
  }
  if (options.recording.empty()) return list_runs(options);
  if (options.keep || options.no_keep) return mark(options);
  if (!options.report.empty() && !is_writable(options.report)) {
    fmt::print(stderr, "mlab replay: --report {}: the file can't be written\n", options.report);
    return kBadInput;
  }
  const RecordedRun recorded = open_recording(options);
  if (!recorded.history) return kBadInput;
  if (!recorded.replay) {
    show_recorded(*recorded.history);
    return kFailed;
  }
  RunScreen screen(options.quiet);
  screen.show_start(recorded.replay->run());
  run::Performance performance;
  performance.program_version = kVersion;
  const double began = steady_seconds();
  const double cpu_began = cpu_seconds();
  if (!compute(*recorded.replay, screen)) return kFailed;
  performance.wall_seconds = steady_seconds() - began;
  performance.cpu_seconds = cpu_seconds() - cpu_began;
  const run::MissionRun& run = recorded.replay->run();
  const std::string outcome = run::outcome_name(run, run::RunEnd::kInterrupted);
  screen.show_summary(run, outcome, performance.wall_seconds);
  fmt::print("{}\n", outcome_of(*recorded.replay));
  if (!options.report.empty() &&
      !deliver("report", options.report, run::report_json(run, performance, run::RunEnd::kInterrupted)))
    return kFailed;
  return recorded.replay->divergence() ? kFailed : kDone;
}

}  // namespace mlab::cli
