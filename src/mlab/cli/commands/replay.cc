#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/core.h>

#include "mlab/base/counted.h"
#include "mlab/cli/clock.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/interrupt.h"
#include "mlab/cli/places.h"
#include "mlab/cli/recorded_run.h"
#include "mlab/cli/run_recording.h"
#include "mlab/cli/run_screen.h"
#include "mlab/cli/run_settings.h"
#include "mlab/cli/runs_folder.h"
#include "mlab/cli/terminal.h"
#include "mlab/cli/version.h"
#include "mlab/documents/project_folder.h"
#include "mlab/history/bookmark_file.h"
#include "mlab/history/history.h"
#include "mlab/history/recording_file.h"
#include "mlab/history/shelf.h"
#include "mlab/run/report.h"
#include "mlab/text/shown.h"

namespace mlab::cli {
namespace {

// What stands in the recording itself, for those that this program can't compute again, or only so far.
void show_recorded(const history::History& history, std::uint64_t after) {
  for (const history::EventEntry& event : history.events()) {
    if (event.cycle < after) continue;
    fmt::print("[{:9.1f} s] {}{}\n", event.time, event.is_warning ? "warning: " : "",
               text::shown(event.text, 400));
  }
  if (!history.poses().empty()) {
    const history::PosesEntry& last = history.poses().back();
    for (int i = 0; i < last.poses.robots_size(); ++i)
      fmt::print("  robot {}: at ({:.1f}, {:.1f}) after {:.1f} s\n", last.poses.robots(i), last.poses.x(i),
                 last.poses.y(i), last.time);
  }
  fmt::print("recorded: {} cycles, {:.1f} s{}\n", history.last_cycle(), history.last_time(),
             history.end() ? ", " + text::shown(history.end()->outcome) : "");
}

// Moments that people have marked, in the recording or beside it.
void show_bookmarks(const std::string& recording, const history::History& history) {
  const history::KeptBookmarks kept =
      history::read_bookmarks(recording, history::RunExtent{history.last_cycle(), history.last_time()});
  if (!kept.problem.empty()) fmt::print(stderr, "mlab replay: warning: {}\n", kept.problem);
  if (!kept.moved.empty()) fmt::print(stderr, "mlab replay: warning: of the bookmarks {}\n", kept.moved);
  if (kept.bookmarks.is_empty()) return;
  fmt::print("{}:\n", base::counted(kept.bookmarks.all().size(), "bookmark"));
  for (const history::Bookmark& one : kept.bookmarks.in_order())
    fmt::print("[{:9.1f} s] {}{}\n", one.time, one.note.empty() ? "no note" : text::shown(one.note, 600),
               one.by.empty() ? "" : fmt::format(" ({})", text::shown(one.by, 100)));
}

std::string size_text(std::uint64_t bytes) {
  return bytes < 1'000'000 ? fmt::format("{:.0f} kB", std::ceil(static_cast<double>(bytes) / 1e3))
                           : fmt::format("{:.1f} MB", static_cast<double>(bytes) / 1e6);
}

// Those that the console has recorded, the newest first.
int list_runs(const ReplayOptions& options) {
  const std::string project =
      documents::ProjectFolder({options.page.project.empty() ? "." : options.page.project, ""}).folder();
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
    const std::size_t bookmarks = history::read_bookmarks(run.path).bookmarks.all().size();
    fmt::print("{}{}\n    {}, {}{}\n", run.path, run.is_marked ? " (kept)" : "", what, size_text(run.bytes),
               bookmarks == 0 ? "" : ", " + base::counted(bookmarks, "bookmark"));
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

// @param recording  in which it is recorded once more; null: in none
bool compute(history::Replay& replay, RunScreen& screen, RunRecording* recording) {
  run::MissionRun& run = replay.run();
  run.set_observer([&](const mission::Effect& effect) {
    screen.show(run, effect);
    if (recording != nullptr) recording->see(effect);
  });
  run.set_meanwhile(was_interrupted);
  note_interrupts();
  while (!was_interrupted() && replay.step()) {
    screen.show_progress(run);
    if (recording != nullptr) recording->note(run::MissionRun::Progress::kStepped);
  }
  screen.clear_progress();
  return !was_interrupted();
}

// What was asked for and what there is of it. A report would be of a run that nobody had.
int tell_interrupted(const ReplayOptions& options, const RecordedRun& recorded, RunRecording* recording) {
  const run::MissionRun& run = recorded.replay->run();
  std::fflush(stdout);
  fmt::print(stderr, "mlab replay: interrupted after {:.1f} of {:.1f} s; what comes later was not compared\n",
             run.time(), recorded.history->last_time());
  if (!options.report.empty())
    fmt::print(stderr, "mlab replay: the report {} is not written\n", options.report);
  if (recording != nullptr && recording->end("mlab replay", "interrupted"))
    fmt::print(stderr, "mlab replay: the recording {} ends there\n", options.record);
  return kFailed;
}

int show_page(const ReplayOptions& options) {
  if (options.quiet || !options.report.empty() || !options.record.empty()) {
    fmt::print(stderr, "mlab replay: --report, --record and --quiet go with --headless\n");
    return kBadInput;
  }
  RunOptions page = options.page;
  page.recording = options.recording;
  page.limits = options.limits;
  page.threads = options.threads;
  return run_console(page);
}

// What they showed when the run was recorded.
void note_clocks(const wire::HistoryBeginning& then, run::Performance& performance) {
  performance.started_at = print(wall_clock(then.started_at()));
  performance.mission_clock = print({then.executive().epoch_seconds(), then.executive().zone_offset()});
}

// Null: it is not recorded once more.
std::unique_ptr<RunRecording> recording_of(const ReplayOptions& options, history::Replay& replay) {
  if (options.record.empty()) return nullptr;
  const wire::HistoryBeginning& then = replay.history().beginning();
  history::Circumstances circumstances{kVersion, {}, then.obstacle_seed(), then.started_at()};
  circumstances.overlay_folders = {then.overlay_folders().begin(), then.overlay_folders().end()};
  return std::make_unique<RunRecording>(options.record, replay.run(), circumstances,
                                        options.records_for_viewers ? options.viewer_rate : 0.0);
}

bool outputs_are_usable(const ReplayOptions& options) {
  std::error_code unknown;
  if (!options.record.empty() && std::filesystem::exists(options.record, unknown)) {
    fmt::print(
        stderr,
        "mlab replay: --record {}: there is such a file already, and a recording is never written over\n",
        options.record);
    return false;
  }
  const std::string problem = problem_with_outputs(
      {{"--report", options.report}, {"--record", options.record}}, {{"recording", options.recording}});
  if (!problem.empty()) fmt::print(stderr, "mlab replay: {}\n", problem);
  return problem.empty();
}

}  // namespace

int replay(const ReplayOptions& options) {
  if (options.recording.empty() && (options.keep || options.no_keep)) {
    fmt::print(stderr, "mlab replay: --keep and --no-keep: expected the recording that is meant\n");
    return kBadInput;
  }
  if (options.recording.empty() && !options.page.against.empty()) {
    fmt::print(stderr, "mlab replay: --against: expected the recording that it is shown beside\n");
    return kBadInput;
  }
  if (options.recording.empty()) return list_runs(options);
  if (options.keep || options.no_keep) return mark(options);
  if (!options.headless) return show_page(options);
  if (!outputs_are_usable(options)) return kBadInput;
  const RecordedRun recorded = open_recording(options);
  if (!recorded.history) return kBadInput;
  if (!recorded.replay) {
    show_recorded(*recorded.history, 0);
    show_bookmarks(options.recording, *recorded.history);
    return kFailed;
  }
  RunScreen screen(options.quiet);
  screen.show_start(recorded.replay->run());
  run::Performance performance;
  performance.program_version = kVersion;
  note_clocks(recorded.history->beginning(), performance);
  const double began = steady_seconds();
  const double cpu_began = cpu_seconds();
  const std::unique_ptr<RunRecording> recording = recording_of(options, *recorded.replay);
  if (!compute(*recorded.replay, screen, recording.get()))
    return tell_interrupted(options, recorded, recording.get());
  performance.wall_seconds = steady_seconds() - began;
  performance.cpu_seconds = cpu_seconds() - cpu_began;
  const run::MissionRun& run = recorded.replay->run();
  const run::RunEnd how = end_of(*recorded.replay);
  const std::string outcome = run::outcome_name(run, how);
  screen.show_summary(run, outcome, performance.wall_seconds);
  fmt::print("{}\n", outcome_of(*recorded.replay));
  if (recorded.is_damaged) fmt::print("what comes after that can't be read: the recording is damaged\n");
  if (recorded.replay->divergence()) {
    fmt::print("from there on, as it was recorded:\n");
    show_recorded(*recorded.history, recorded.replay->divergence()->cycle);
  }
  show_bookmarks(options.recording, *recorded.history);
  // As it was told then, even where it is computed otherwise now.
  const std::optional<history::EndEntry>& end = recorded.history->end();
  if (recording && !recording->end("mlab replay", end ? end->outcome : outcome)) return kFailed;
  if (!options.report.empty() &&
      !deliver("mlab replay", "report", options.report, run::report_json(run, performance, how)))
    return kFailed;
  return recorded.replay->divergence() || recorded.is_damaged ? kFailed : kDone;
}

}  // namespace mlab::cli
