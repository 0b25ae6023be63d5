#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "mlab/history.pb.h"
#include "mlab/history/answer_writer.h"
#include "mlab/mission/effect.h"
#include "mlab/run/input.h"
#include "mlab/run/mission_run.h"

namespace mlab::history {

/// What a run was made with that it does not know itself.
struct Circumstances {
  std::string version;                       ///< of missionlab
  std::vector<std::string> overlay_folders;  ///< as mdl::LoadOptions
  std::uint64_t obstacle_seed = 0;           ///< likewise, its `seed`
  double started_at = 0.0;                   ///< wall clock, seconds since 1970-01-01 00:00 UTC
};

/// Watches a run, and says the entries of its history, in order. Belongs to the run's thread.
class HistoryWriter {
 public:
  /// Takes an entry, at once.
  using Sink = std::function<void(const wire::HistoryEntry& entry)>;
  explicit HistoryWriter(Sink sink) : sink_(std::move(sink)) {}

  /// The run is there, and nothing has come in yet. Everything that does is told from now on.
  /// @param run  outlives this, or `end` is called
  void begin(run::MissionRun& run, const Circumstances& circumstances);
  /// An effect of the run's executive, which its observer was told.
  void see(const mission::Effect& effect);
  /// A cycle has passed.
  void note_cycle();
  /// No time passes: all that is known of the run is told now.
  void note_rest();
  /// The run has ended, and is told of no more.
  void end(const std::string& outcome);
  /// The run is told of no more, whether or not it goes on.
  void leave();

 private:
  wire::HistoryEntry entry() const;
  void put(const wire::HistoryEntry& entry);
  std::uint32_t id_of(const text::SourcePtr& source);
  void put_mission(const run::Crew& crew, wire::HistoryMission& out);
  void note_input(const run::Moment& moment, const run::Input& input);
  void note_mark();
  void note_poses();

  Sink sink_;
  run::MissionRun* run_ = nullptr;
  std::unique_ptr<AnswerWriter> answers_;  // while there is a run
  std::map<std::pair<std::string, std::uint64_t>, std::vector<std::pair<text::SourcePtr, std::uint32_t>>>
      texts_;  // by path and hash
  std::uint32_t last_text_ = 0;
  double next_poses_ = 0.0;      // [s]
  std::uint64_t next_mark_ = 0;  // cycle
};

}  // namespace mlab::history
