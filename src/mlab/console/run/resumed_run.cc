#include "mlab/console/run/resumed_run.h"

#include <utility>

#include <fmt/core.h>

#include "mlab/history/recorded_names.h"
#include "mlab/history/recording_file.h"
#include "mlab/history/replay.h"

namespace mlab::console {
namespace {

bool is_of_same_run(const history::History& recording, const history::History& journal) {
  const history::RecordedNames names(journal.beginning().mission().folder());
  return recording.beginning().SerializeAsString() ==
             names.in_recording(journal.beginning()).SerializeAsString() &&
         recording.inputs().size() <= journal.inputs().size();
}

// Cycles that were recorded after the journal was written last; nothing had come in since, or the journal
// would say so.
void go_to_recorded(const std::string& file, history::History& history) {
  if (file.empty()) return;
  const auto recording = history::read_recording(file);
  if (!recording || !is_of_same_run(*recording->history, history)) return;
  wire::HistoryEntry reached;
  reached.set_cycle(recording->history->last_cycle());
  reached.set_time(recording->history->last_time());
  history.add(reached);  // where the journal knows more, that is refused
}

std::string first_of(const text::Diagnostics& problems) {
  for (const text::Diagnostic& one : problems.items()) {
    if (one.severity == text::Severity::kError) return one.message;
  }
  return "it can't be computed again";
}

history::Circumstances circumstances_of(const history::History& history, const std::string& version) {
  const wire::HistoryBeginning& beginning = history.beginning();
  return {version,
          {beginning.overlay_folders().begin(), beginning.overlay_folders().end()},
          beginning.obstacle_seed(),
          beginning.started_at()};
}

}  // namespace

ResumedRun resume_run(const journal::Kept& kept, const ResumeParts& parts,
                      const std::function<bool()>& is_unwanted) {
  ResumedRun out;
  out.log = std::make_unique<EventLog>();
  const std::string file = kept.stand.session.recording();
  go_to_recorded(file, *kept.history);
  if (std::string why = kept.history->why_not_gone_on(); !why.empty()) {
    out.why = std::move(why);
    return out;
  }
  text::Diagnostics problems;
  const auto replay = history::Replay::make(kept.history, parts.tools, problems);
  if (!replay) {
    out.why = first_of(problems);
    return out;
  }
  run::MissionRun& run = replay->run();
  auto recorder = std::make_unique<history::Recorder>(
      parts.place, run, circumstances_of(*kept.history, parts.version), parts.hear, true);
  auto live = std::make_unique<LiveRun>(run.crew(), replay->give_run(), *out.log, std::move(recorder));
  const wire::JournalProgress& progress = kept.stand.progress;
  while (!is_unwanted() && replay->step()) live->note_recomputed_cycle(run.cycle() <= progress.cycle());
  if (is_unwanted()) return out;
  if (replay->divergence()) {
    out.why = fmt::format("at {:.1f} s: {}", run.time(), replay->divergence()->why);
    return out;
  }
  if (progress.has_looked() && run.cycle() == progress.cycle() && !run.moment().has_looked) run.look();
  run.forget_known_failures();  // who could not be started then may be started now, in the same moment
  Log told;
  out.log->encode_since(progress.told(), told);
  out.told = {told.entries().begin(), told.entries().end()};
  live->recorder()->go_on(file);
  out.live = std::move(live);
  return out;
}

}  // namespace mlab::console
