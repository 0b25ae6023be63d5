#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "mlab/comparison/comparison.h"
#include "mlab/comparison/parting.h"
#include "mlab/history/history.h"
#include "mlab/history/replay.h"

namespace mlab::comparison {

/// A recording that is compared with another one.
struct Recorded {
  std::string name;                                 ///< for people: of its file
  std::shared_ptr<const history::History> history;  ///< has begun
  std::unique_ptr<history::Replay> replay;          ///< at its beginning; null: it can't be computed again
  std::string why_not;                              ///< as a sentence, where there is no `replay`
  std::vector<std::string> remarks;                 ///< what else is to be known of it
};

/// Compares two runs: computes both again in step, and looks after each cycle at all that is in them. Where
/// one of them can't be computed again, what was recorded is compared instead. What it keeps does not grow
/// with the runs' length.
class Comparer {
 public:
  explicit Comparer(Both<Recorded> runs);

  /// One cycle of both, or of the one that is behind. False: there is none any more.
  bool step();
  /// How much of both is done: 0 .. 1.
  double share_done() const;
  /// What came out; once. Whoever stops before `step` is false gets what is known by then.
  Comparison finish();

  /// Where each of them stands; null: it is not computed again.
  const history::Replay* replay(std::size_t side) const { return runs_[side].replay.get(); }

  /// So many robots are followed, at most.
  static constexpr std::size_t kMostRobots = 2000;

 private:
  bool advance(std::size_t side);
  void look();
  void note_robots();
  void note_sample();
  void thin();
  RobotRow* row_of(base::RobotId id);
  Side side_of(std::size_t side) const;
  /// Why the run that is computed is not the one that was recorded, as a sentence; empty: it is.
  std::string divergence_of(std::size_t side) const;
  void give_up_computing();
  void add_totals();

  Both<Recorded> runs_;
  Comparison out_;
  PartingFinder finder_;
  Both<bool> is_over_{};
  bool is_done_ = false;
  std::map<std::uint32_t, RobotRow> robots_;
  std::size_t most_samples_ = 0;
  std::uint64_t stride_ = 1;   // aligned cycles from one sample to the next
  std::uint64_t aligned_ = 0;  // cycles after which both stood at the same time
};

}  // namespace mlab::comparison
