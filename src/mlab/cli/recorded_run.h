#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mlab/cli/commands.h"
#include "mlab/history/replay.h"
#include "mlab/run/report.h"

namespace mlab::cli {

/// A recorded run that is computed again.
struct RecordedRun {
  std::shared_ptr<const history::History> history;  ///< null: it can't be read, which was told
  std::unique_ptr<history::Replay> replay;          ///< null: it can't be computed again, which was told
  bool is_damaged = false;  ///< something of what was recorded is missing, or was changed: that is no success
};

/// Reads a recording, and tells on standard error what is wrong with it.
/// @return null where it can't be read
std::shared_ptr<history::History> read_history(const std::string& path);

/// Reads the recording, and tells on standard error what is wrong with it. How it was recorded by another
/// program, or on another machine, and how far it can be read, is told as well.
RecordedRun open_recording(const ReplayOptions& options);

/// From its beginning.
/// @return null where it can't be computed again, which was told
std::unique_ptr<history::Replay> replay_of(const std::shared_ptr<const history::History>& history,
                                           const ReplayOptions& options);

/// That it was recorded by another program, or on another machine: sentences.
std::vector<std::string> remarks_on(const wire::HistoryBeginning& beginning);

/// How a run that was computed again up to its end came to that: what outcome was recorded tells it apart
/// from one that somebody ended. Where nothing was recorded of it, somebody did.
run::RunEnd end_of(const history::Replay& replay);

/// What became of a run that was computed again, as a line; what is not as it was comes first.
std::string outcome_of(const history::Replay& replay);

}  // namespace mlab::cli
