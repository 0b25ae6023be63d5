#include "mlab/cli/recorded_run.h"

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

void tell_circumstances(const wire::HistoryBeginning& beginning) {
  if (beginning.version() != kVersion)
    warn(fmt::format("it was recorded by missionlab {}, and this is {}: what is computed again may differ",
                     text::shown(beginning.version()), kVersion));
  if (beginning.arithmetic() != robot_wire::arithmetic())
    warn("it was recorded on a machine that rounds otherwise: what is computed again may differ");
}

}  // namespace

RecordedRun open_recording(const ReplayOptions& options) {
  RecordedRun out;
  auto recording = history::read_recording(options.recording);
  if (!recording) {
    tell(recording.error());
    return out;
  }
  out.history = std::move(recording->history);
  if (!recording->cut.empty()) warn(fmt::format("`{}`: {}", text::shown(options.recording), recording->cut));
  tell_circumstances(out.history->beginning());
  text::Diagnostics problems;
  out.replay = history::Replay::make(
      out.history, {permission_to_replay(), include_root(), kVersion, options.limits, options.threads},
      problems);
  if (!out.replay) tell(problems);
  return out;
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
