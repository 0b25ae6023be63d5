#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "mlab/fleet/fleet.h"
#include "mlab/history.pb.h"
#include "mlab/run/crew.h"
#include "mlab/run/mission_run.h"

namespace mlab::history {

/// Notes what robots of a run answer whose programs can't be computed again: those in executables, and in
/// real time all that are elsewhere. Of all others, that their programs failed. Belongs to the run's thread.
class AnswerWriter final : public fleet::AnswerWitness {
 public:
  /// @param run  outlives this
  explicit AnswerWriter(const run::MissionRun& run);

  /// The run has that crew from now on.
  void take_up(const run::Crew& crew);
  /// Some program has failed since `take`.
  bool has_failures() const { return noted_.failed_size() > 0 || noted_.not_started_size() > 0; }
  /// A cycle has passed, in which programs ran or not.
  void note_cycle();
  /// What was noted since, with the cycle up to which it tells; nothing: there is none.
  std::optional<wire::HistoryEntry> take();

  /// What has to be known of the program beside its answers.
  wire::HistoryExecutable describe(const robot::RobotProgram& program);

  void note_start(const fleet::FleetRobot& robot) override;
  void note_asked(std::span<const fleet::FleetRobot> robots) override;
  void note_answered(std::span<const fleet::FleetRobot> robots) override;

 private:
  /// What was said of a robot last in the entry that is being made, each part as its bytes.
  struct Said {
    bool is_there = false;
    std::string action;
    std::string needs;
    std::string hearing;
  };
  bool is_answered_for(const fleet::FleetRobot& robot) const;
  void note_failure(const fleet::FleetRobot& robot);
  void note(const fleet::FleetRobot& robot, std::size_t index);

  const run::MissionRun& run_;
  const bool are_late_;     // robots elsewhere are not waited for
  bool is_needed_ = false;  // the crew has such programs, or one before had
  std::uint64_t to_ = 0;    // what is noted is complete up to this cycle
  double time_ = 0.0;       // of it [s]
  std::uint64_t taken_ = 0;
  std::vector<percept::Needs> asked_;  // by index of the fleet's robots
  std::map<base::RobotId, Said> said_;
  wire::HistoryAnswers noted_;  // `before` holds the cycle until it is taken
  // By path of the executable, program, build in another recording.
  std::map<std::tuple<std::string, const void*, std::uint64_t>, std::uint32_t> builds_;
  std::vector<std::shared_ptr<const flow::Program>> built_;  // those that builds_ names stay
};

}  // namespace mlab::history
