#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mlab/cli/commands.h"
#include "mlab/cli/places.h"
#include "mlab/mission/mission.h"
#include "mlab/recording/recorded_binding.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/run/mission_run.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cli {

/// The bodies of a run as the command line wants them: simulated ones, whose percepts may be written to a
/// file, or out of such a file.
class RunBodies {
 public:
  /// Looks through the file of --percepts, where there is one; its seed is the run's from then on, of which
  /// the mission is read.
  /// @return  false: it can't be read, which is told
  bool open(RunOptions& options);
  /// Once, after `open`.
  /// @return null where there were errors, all in `sink`
  std::unique_ptr<run::MissionRun> make_run(const std::shared_ptr<const mission::Mission>& mission,
                                            const robot::ProgramSources& sources,
                                            const run::RunSettings& settings, text::Diagnostics& sink);

  /// After the run, which is still there: finishes the file that is written, and tells how robots acted
  /// otherwise than in the one that was read.
  /// @return  false: they did, or the file could not be written, which is told
  bool conclude();

 private:
  std::unique_ptr<recording::PerceptsReader> file_;  // until the run has it
  std::string save_path_;                            // empty: percepts are not written
  std::vector<NamedFile> outputs_;                   // of the run: no file is written over what it reads
  std::shared_ptr<recording::PerceptsWriter> written_;
  const recording::RecordedBinding* read_ = nullptr;  // the run's
};

}  // namespace mlab::cli
