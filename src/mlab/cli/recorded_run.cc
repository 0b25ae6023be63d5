#include "mlab/cli/recorded_run.h"

#include <optional>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/counted.h"
#include "mlab/cli/permission.h"
#include "mlab/cli/places.h"
#include "mlab/cli/terminal.h"
#include "mlab/cli/version.h"
#include "mlab/history/recording_file.h"
#include "mlab/robot/wire/arithmetic.h"
#include "mlab/text/shown.h"

namespace mlab::cli {
namespace {

void warn(const std::string& text) {
  fmt::print(stderr, "{}{}\n", colored("warning: ", Color::kWarning), text);
}

// Without a history where it can't be read, which was told.
history::Recording read_telling(const std::string& path) {
  auto recording = history::read_recording(path);
  if (!recording) {
    tell(recording.error());
    return {};
  }
  if (!recording->cut.empty()) warn(fmt::format("`{}`: {}", text::shown(path), recording->cut));
  for (const std::string& remark : remarks_on(recording->history->beginning())) warn(remark);
  return *std::move(recording);
}

}  // namespace

std::vector<std::string> remarks_on(const wire::HistoryBeginning& beginning) {
  std::vector<std::string> out;
  if (beginning.version() != kVersion)
    out.push_back(
        fmt::format("it was recorded by missionlab {}, and this is {}: what is computed again may differ",
                    text::shown(beginning.version()), kVersion));
  if (beginning.arithmetic() != robot_wire::arithmetic())
    out.emplace_back("it was recorded on a machine that rounds otherwise: what is computed again may differ");
  return out;
}

std::shared_ptr<history::History> read_history(const std::string& path) {
  return read_telling(path).history;
}

RecordedRun open_recording(const ReplayOptions& options) {
  RecordedRun out;
  const history::Recording recording = read_telling(options.recording);
  out.history = recording.history;
  out.is_damaged = recording.is_damaged;
  if (!out.history) return out;
  out.replay = replay_of(out.history, options);
  return out;
}

std::unique_ptr<history::Replay> replay_of(const std::shared_ptr<const history::History>& history,
                                           const ReplayOptions& options) {
  text::Diagnostics problems;
  auto out = history::Replay::make(
      history, {permission_to_replay(), include_root(), kVersion, options.limits, options.threads}, problems);
  if (!out) tell(problems);
  return out;
}

run::RunEnd end_of(const history::Replay& replay) {
  const std::optional<history::EndEntry>& then = replay.history().end();
  for (const run::RunEnd end : {run::RunEnd::kTimeIsUp, run::RunEnd::kByItself}) {
    if (then && replay.is_at_end() && run::outcome_name(replay.run(), end) == then->outcome) return end;
  }
  return run::RunEnd::kInterrupted;
}

std::string outcome_of(const history::Replay& replay) {
  if (const auto& divergence = replay.divergence())
    return fmt::format("not as recorded: by cycle {} ({:.1f} s) {}", divergence->cycle, replay.run().time(),
                       divergence->why);
  const std::string cycles = base::counted(replay.run().cycle(), "cycle");
  if (replay.equal_marks() == 0)
    return fmt::format("computed again: {}; the recording has nothing that they could be compared with",
                       cycles);
  return fmt::format("as recorded: {}, compared at {}", cycles, base::counted(replay.equal_marks(), "place"));
}

}  // namespace mlab::cli
