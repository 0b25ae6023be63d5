#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "mlab/cell/permission.h"
#include "mlab/history/history.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/robot/host/limits.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/run/crew.h"
#include "mlab/run/mission_run.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/files.h"

namespace mlab::history {

/// What a run is made again with, on this machine.
struct ReplayTools {
  cell::Permission permission;    ///< whether code that the history brings may be compiled and run
  std::string include_root = {};  ///< as robot::ProgramSources
  std::string version = {};       ///< likewise
  robot_host::Limits limits = {};
  int threads = 1;
  bool in_own_processes = false;  ///< as robot::ProgramSources
};

/// Makes missions and programs out of a history's texts, and reads nothing else, by whatever name. Where the
/// history is a stranger's, so are these.
class Remaker {
 public:
  /// @param history  may grow
  Remaker(std::shared_ptr<const History> history, ReplayTools tools)
      : all_(std::move(history)), history_(*all_), tools_(std::move(tools)) {}

  /// A version's mission alone, without programs: for who only looks at it.
  /// @param version  all its texts are there
  /// @return null where it can't be read, which is said in `sink`
  std::shared_ptr<const mission::Mission> read(const wire::HistoryMission& version, text::Diagnostics& sink);
  /// The run before anything came in. Once.
  /// @return null where there were errors, all in `sink`
  std::unique_ptr<run::MissionRun> begin(text::Diagnostics& sink);
  /// The same once more, of the same programs. After `begin`.
  std::unique_ptr<run::MissionRun> begin_again() const;
  /// What came in, with what its texts mean now; to be asked in order.
  /// @return nothing where it can't be understood, which is said in `sink`
  std::optional<run::Input> understand(const wire::HistoryInput& input, text::Diagnostics& sink);
  /// In place of `begin`: as one that has understood so much, with the programs of another one.
  /// @param from    of a history that begins as this one does
  /// @param crew    that the last exchange among these inputs brought; null: none was among them
  /// @param inputs  of History::inputs, which `from` has understood
  void take_up(const Remaker& from, std::shared_ptr<const run::Crew> crew, std::size_t inputs);
  const ReplayTools& tools() const { return tools_; }

 private:
  using MissionPtr = std::shared_ptr<const mission::Mission>;

  run::RunSettings::Recorded recorded() const;
  robot::ProgramSources prepare(const wire::HistoryMission& version);
  std::shared_ptr<const run::Crew> make(const wire::HistoryMission& version, const run::Crew* before,
                                        text::Diagnostics& sink);
  MissionPtr mission_of(const wire::HistoryMission& version, text::Diagnostics& sink);
  std::optional<run::Input> typed(const std::string& line, text::Diagnostics& sink);

  const std::shared_ptr<const History> all_;
  const History& history_;
  const ReplayTools tools_;
  std::shared_ptr<const run::Crew> first_;
  run::RunSettings settings_;
  text::Files files_;         // of the version in force,
  mdl::LoadOptions options_;  // and what its texts are read with
  std::shared_ptr<const run::Crew> crew_;
  wire::HistoryMission version_;
  // By the line that the last version came from, where it was typed: it was read against the version before.
  std::optional<std::pair<std::string, std::vector<mission::Command>>> typed_;
};

}  // namespace mlab::history
