#pragma once

#include <cstdint>
#include <expected>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "mlab/cell/permission.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/overlay/environment_change.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/run/crew.h"
#include "mlab/run/mission_run.h"
#include "mlab/study/scene.h"
#include "mlab/text/diagnostic.h"

namespace mlab::python {

/// A mission that runs are made of: its texts are read once, so all its runs are of the same ones, whatever
/// happens to the files meanwhile. Never changed; for any number of threads.
class MissionFile : public std::enable_shared_from_this<MissionFile> {
 public:
  /// What it is read with.
  struct Request {
    std::string path;
    std::vector<mdl::Setting> settings = {};
    std::string environment = {};  ///< file; empty: none
    cell::Permission permission;
  };
  /// @param ends  nobody waits for it any more
  /// @return  null where there were errors, all in `sink`
  static std::shared_ptr<const MissionFile> load(Request request, std::stop_token ends,
                                                 text::Diagnostics& sink);

  /// A run, nothing of which has started.
  /// @param settings  all but the environment
  /// @errors  all in `sink`
  std::unique_ptr<run::MissionRun> make_run(run::RunSettings settings, text::Diagnostics& sink) const;

  /// A line that somebody types, for a run of this mission.
  /// @return  nothing where there were errors, all in `sink`
  std::optional<mdl::Immediate> read_line(const std::string& line, const run::MissionRun& run,
                                          text::Diagnostics& sink) const;
  /// The crew of a run's mission after such a line.
  std::shared_ptr<const run::Crew> crew_after(const mdl::Immediate& line, const run::MissionRun& run,
                                              text::Diagnostics& sink) const;

  const std::string& path() const { return request_.path; }
  const run::Crew& crew() const { return *crew_; }

 private:
  explicit MissionFile(Request request);
  mdl::LoadOptions options(std::uint64_t seed) const;
  std::shared_ptr<const run::Crew> read(std::uint64_t seed, overlay::EnvironmentChanges& environment,
                                        text::Diagnostics& sink) const;

  Request request_;
  study::ReadOnce once_;
  text::Files files_;
  robot::ProgramSources sources_;
  std::shared_ptr<const run::Crew> crew_;
  overlay::EnvironmentChanges environment_;
};

}  // namespace mlab::python
