#pragma once

#include <memory>

#include "mlab/cli/commands.h"
#include "mlab/fleet/mission_run.h"
#include "mlab/mission/mission.h"
#include "mlab/recording/recorded_binding.h"
#include "mlab/robot/robot_program.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cli {

/// The bodies of a run as the command line wants them: simulated ones, whose percepts may be written to a
/// file, or out of such a file.
class RunBodies {
 public:
  /// @param settings  of the run; the seed is the file's where bodies come out of one
  /// @return null where there were errors, all in `sink`
  std::unique_ptr<fleet::MissionRun> make_run(const std::shared_ptr<const mission::Mission>& mission,
                                              const robot::ProgramSources& sources, const RunOptions& options,
                                              fleet::RunSettings& settings, text::Diagnostics& sink);

  /// After the run, which is still there: finishes the file that is written, and tells how robots acted
  /// otherwise than in the one that was read.
  /// @return  false: they did, or the file could not be written, which is told
  bool conclude();

 private:
  std::shared_ptr<recording::PerceptsWriter> written_;
  const recording::RecordedBinding* read_ = nullptr;  // the run's
};

}  // namespace mlab::cli
