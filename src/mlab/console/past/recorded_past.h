#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mlab/console.pb.h"
#include "mlab/console/past/past_run.h"
#include "mlab/console/past/past_texts.h"
#include "mlab/console/run/event_log.h"
#include "mlab/history/history.h"
#include "mlab/history/remaker.h"

namespace mlab::console {

/// Any moment of a recording that can't be computed again: what was written of it, and nothing else. Where
/// robots were stands there about once a second, and what was told; the map and the plan are shown as far as
/// the recorded texts can be read. Belongs to one thread at a time.
class RecordedPast {
 public:
  /// Robots that are shown, the first by number.
  static constexpr std::size_t kMostRobots = 10'000;

  /// @param history  has begun
  RecordedPast(std::shared_ptr<const history::History> history, history::ReplayTools tools);

  /// As PastRun::picture; it can always be shown.
  PastPicture picture(const PastWish& wish);
  /// All that was told.
  const EventLog& log() const { return log_; }

 private:
  /// What the run was of, between two changes of its mission.
  struct Version {
    std::uint64_t number = 0;                         ///< from 1
    std::uint64_t begin = 0;                          ///< cycle
    std::shared_ptr<const mission::Mission> mission;  ///< null: it can't be read
    overlay::Overlay overlay;
    std::optional<PastTexts> texts;
  };

  const Version& version_at(std::uint64_t cycle);
  Version read(const wire::HistoryMission& told) const;
  const history::PosesEntry* poses_at(std::uint64_t cycle) const;
  double time_of(std::uint64_t cycle) const;
  std::uint64_t cycle_at(double time) const;
  void tell_version(const Version& version, PastPicture& out) const;
  void tell_roster(const Version& version, Roster& out) const;
  void tell_trails(std::uint64_t cycle, Trails& out) const;

  std::shared_ptr<const history::History> history_;
  const history::ReplayTools tools_;
  EventLog log_;
  std::vector<std::uint32_t> robots_;                      // that were ever seen, ascending
  std::vector<std::pair<std::uint64_t, double>> moments_;  // cycles with their times [s], ascending
  std::vector<std::pair<std::uint64_t, const wire::HistoryMission*>> changes_;  // of the mission, by cycle
  std::optional<Version> version_;                                              // that was asked for last
};

}  // namespace mlab::console
