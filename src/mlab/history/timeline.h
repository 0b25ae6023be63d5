#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "mlab/history/history.h"
#include "mlab/history/kept_checkpoints.h"
#include "mlab/history/replay.h"
#include "mlab/run/mission_run.h"
#include "mlab/text/diagnostic.h"

namespace mlab::history {

/// Any moment of a run, computed again from the nearest checkpoint before it. Checkpoints are laid by a first
/// pass over the history, which may be made piece by piece, and where somebody looks. Belongs to one thread
/// at a time.
class Timeline {
 public:
  struct Settings {
    /// That checkpoints take up: with two runs of a thousand robots it is 200 MB.
    std::size_t most_bytes = 185'000'000;
    double spacing = 0.01;    ///< from one checkpoint to the next, while there is room [s] of computing
    double most_share = 0.1;  ///< of the first pass's time that checkpoints may take; infinite: any
  };

  /// @param history  may be of a run that goes on: its line grows
  /// @return null where it can't be computed again, which is said in `sink`
  static std::unique_ptr<Timeline> make(std::shared_ptr<const History> history, ReplayTools tools,
                                        const Settings& settings, text::Diagnostics& sink);

  /// Called after each cycle of the first pass that is still to come, with the run as it is then.
  using Watcher = std::function<void(const run::MissionRun& run)>;
  void set_watcher(Watcher watcher) { watcher_ = std::move(watcher); }
  /// What the executive of the first pass decides, from now on.
  void set_observer(run::MissionRun::Observer observer) { front_->run().set_observer(std::move(observer)); }
  /// The run of the first pass; between two calls it does not change.
  const run::MissionRun& first_pass() const { return front_->run(); }
  /// The same run once more, at its beginning, for who wants to see each of its cycles.
  std::unique_ptr<Replay> again() const { return front_->again(); }

  struct Fork {
    std::unique_ptr<Replay> own;    ///< this run
    std::unique_ptr<Replay> other;  ///< the other one
  };
  /// Both at the last checkpoint up to a cycle, or at their beginning where there is none.
  /// @param other  a history that is this one up to the cycle, but for what came in after it
  Fork fork(std::shared_ptr<const History> other, std::uint64_t cycle) const;

  /// Goes on with the first pass.
  /// @param seconds  that it may take, about; one cycle is computed in any case
  /// @return  true: there is more to do
  bool advance(double seconds);

  /// The run is then as it was after that cycle, before anything came in behind it; beyond the last one, as
  /// after the last. What of the first pass is missing is made.
  /// @errors  a sentence: the run can't be computed so far; it stays where it was
  std::optional<std::string> go_to(std::uint64_t cycle);
  /// The run is as it was when it was told of last: also what came in after the last cycle is there.
  /// @errors  likewise
  std::optional<std::string> go_to_end();

  /// At the moment that was gone to; at first the beginning. The same object for as long as there is a way
  /// back to where it was.
  const run::MissionRun& run() const { return shown_->run(); }
  const History& history() const { return front_->history(); }
  /// How far the first pass has come.
  std::uint64_t known_to() const { return front_->run().cycle(); }
  /// Where the run that is computed parts from what was written; no further one can go.
  const std::optional<Divergence>& divergence() const { return front_->divergence(); }
  /// Why there are no checkpoints, as a sentence: to go back takes as long as to compute all from the
  /// beginning. Empty: there are.
  const std::string& why_slow() const { return why_slow_; }
  const KeptCheckpoints& checkpoints() const { return kept_; }

 private:
  Timeline(std::unique_ptr<Replay> front, const Settings& settings);
  bool step_front();
  void lay(const Replay& replay);
  std::optional<std::string> go_back_before(std::uint64_t cycle);
  std::optional<std::string> replay_to(std::uint64_t cycle);

  Settings settings_;
  std::unique_ptr<Replay> front_;  // the first pass
  std::unique_ptr<Replay> shown_;
  KeptCheckpoints kept_;
  Watcher watcher_;
  std::string why_slow_;
  double since_laid_ = 0.0;    // the first pass has computed for so long since its last checkpoint [s]
  double cost_of_save_ = 0.0;  // of one checkpoint [s]
  bool is_between_ = true;     // what is shown has taken nothing since its last cycle
};

}  // namespace mlab::history
