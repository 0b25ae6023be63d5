#pragma once

#include <functional>
#include <memory>
#include <string>

#include "mlab/run/mission_run.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/files.h"

namespace mlab::console {

/// A mission that has no file: made by somebody who wants to see something run. It takes the place of the
/// mission that was open.
struct Trial {
  std::string who;           ///< for the log
  std::string path;          ///< that the mission's file would have, as ProjectFolder names it
  std::string text;          ///< MDL
  std::string overlay_path;  ///< of an overlay that has no file either; empty: there is none
  std::string overlay_text;
  /// How configurations and networks are read, from any thread; null: from disk.
  std::shared_ptr<const text::Files> files;
  bool execute = false;  ///< starts at once
  /// Instead of a new run: the run of the same trial goes on, with what its programs are now. Nothing but
  /// them may have changed.
  bool takes_over = false;
};

/// What became of it.
struct TrialResult {
  std::string error;       ///< one sentence; empty: its run stands ready, or goes on
  std::string taken_over;  ///< what became of robots that run: `robots 1 to 3 took over a change`; else empty
  text::Diagnostics problems;  ///< all that was said of the mission and its programs, warnings too
};

/// Called once, on the session's thread, with the run as it stands between two cycles; null: there is none.
/// Must not keep the pointer, and must not take long.
using RunLook = std::function<void(const run::MissionRun* run)>;

/// Called once, on the session's thread; must not block.
using TrialDone = std::function<void(TrialResult result)>;

}  // namespace mlab::console
