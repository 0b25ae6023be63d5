#pragma once

#include <cstdint>
#include <expected>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "mlab/lang/mdl/mdl.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/run/crew.h"
#include "mlab/run/mission_run.h"
#include "mlab/study/plan.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/files.h"

namespace mlab::study {

/// Reads each file once: all runs of a batch are of the same texts, whatever happens to the files meanwhile.
/// For any number of threads.
class ReadOnce {
 public:
  text::Files files();
  /// A hash of all that was read, whatever the files are called.
  std::uint64_t fingerprint() const;

 private:
  struct Kept {
    mutable std::mutex mutex;
    std::map<std::string, text::Result<text::SourcePtr>> texts;
    std::map<std::string, bool> is_file;
  };
  std::shared_ptr<Kept> kept_ = std::make_shared<Kept>();
};

/// One version of a mission, ready to be run with any of a batch's settings. Its programs are built once.
class Scene {
 public:
  /// @param around   what the mission is read with; its `files` read everything else as well
  /// @param manner   of all runs, but for seed and environment
  Scene(const Definition& definition, const Plan& plan, Written mission_file, mdl::LoadOptions around,
        robot::ProgramSources sources, run::RunSettings manner);
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// Reads the mission with the settings of each combination, and builds its programs.
  /// @return  false: there were errors, all in `sink`
  bool prepare(text::Diagnostics& sink);

  /// A run, nothing of which has started. For any number of threads at once.
  /// @errors  why there is none, in one line
  std::expected<std::unique_ptr<run::MissionRun>, std::string> make_run(const RunKey& key) const;

  const std::string& mission_name() const { return name_; }

 private:
  std::shared_ptr<const run::Crew> read(std::uint64_t seed, std::vector<mdl::Setting> settings,
                                        overlay::EnvironmentChanges& environment,
                                        text::Diagnostics& sink) const;

  const Definition& definition_;
  const Plan& plan_;
  Written file_;
  std::string name_;
  mdl::LoadOptions around_;
  robot::ProgramSources sources_;
  run::RunSettings manner_;
  /// By combination. Where seeds or draws change it, only its programs are used again.
  struct Prepared {
    std::shared_ptr<const run::Crew> crew;
    overlay::EnvironmentChanges environment;
    bool is_of_all_runs = true;
  };
  std::vector<Prepared> prepared_;
};

}  // namespace mlab::study
