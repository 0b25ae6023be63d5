#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "mlab/base/random.h"
#include "mlab/statistics/shares.h"
#include "mlab/study/definition.h"
#include "mlab/study/plan.h"
#include "mlab/study/results_file.h"
#include "mlab/study/row.h"
#include "mlab/study/scene.h"
#include "mlab/study/shared_results.h"

namespace mlab::study {

/// The runs of one version of the mission with one combination of values.
struct Cell {
  std::vector<Row> rows;  ///< in the order of their seeds, without a gap
  statistics::Count successes;
};

/// How far a batch is.
struct Progress {
  std::uint64_t done = 0;    ///< runs that count
  std::uint64_t all = 0;     ///< at most
  std::uint64_t before = 0;  ///< of those done, that were there when it began
  std::uint64_t failed = 0;
};

/// Carries out the runs of a plan on several threads, each run on one of them. What comes out does not depend
/// on how many threads there are, or on which run ends first: runs count in the order of their seeds, and
/// what was run past the end of a combination counts for nothing.
///
/// Where several processes do one batch, each begins with every n-th run, and then helps the others with what
/// none of them has done yet. So none is waited for, and what one that died leaves behind is done by the
/// rest.
class Batch {
 public:
  /// All outlive it.
  /// @param scenes  of each version; prepared
  /// @param kept    where runs are kept as they end; null: nowhere
  /// @param share   this process's, where several do the batch
  Batch(const Definition& definition, const Plan& plan, const std::vector<std::unique_ptr<Scene>>& scenes,
        Keeper* kept, Share share = {});

  /// Runs that were done before.
  void take(std::vector<Row> rows);

  enum class End : std::uint8_t {
    kDone,
    kInterrupted,
    kNotKept,
    kOver  ///< another process has written table and page
  };
  /// @param wants_end  asked by all threads, often
  /// @param look       called by this thread several times a second
  End run(int threads, const std::function<bool()>& wants_end,
          const std::function<void(const Progress&)>& look);

  /// Not while it runs.
  Progress progress() const;
  bool is_complete() const;
  /// By version, then combination.
  const std::vector<Cell>& cells() const { return cells_; }
  const Cell& cell(std::uint32_t version, std::uint32_t combination) const {
    return cells_[version * plan_.combinations() + combination];
  }

 private:
  struct Open {
    std::map<std::uint32_t, Row> waiting;  // by run: done, but one before them is not
    bool is_closed = false;
  };
  std::size_t index(const RunKey& key) const { return key.version * plan_.combinations() + key.combination; }
  /// A run that somebody in this process carries out.
  struct Running {
    RunKey key;
    std::uint64_t place = 0;
    std::atomic<bool> is_needless = false;  ///< it does not count any more, or another process has done it
  };
  std::shared_ptr<Running> next();
  bool is_counted(const RunKey& key) const;
  std::shared_ptr<Running> begin(std::uint64_t place);
  void forget(const Running& running);
  /// What other processes have done.
  void hear();
  /// Of the runs that are nobody's any more, or that another process has not come to yet.
  std::optional<std::uint64_t> place_of_others();
  void work(const std::function<bool()>& wants_end);
  Row carry_out_one(const RunKey& key, const std::function<bool()>& wants_end, bool& is_given_up) const;
  void finish(Row row, const Running& running);
  void count(Row row);
  bool is_enough(const Cell& cell) const;

  const Definition& definition_;
  const Plan& plan_;
  const std::vector<std::unique_ptr<Scene>>& scenes_;
  Keeper* kept_;
  const Share share_;

  mutable std::mutex mutex_;  // of all below
  std::vector<Cell> cells_;
  std::vector<Open> open_;
  std::uint64_t next_ = 0;
  std::vector<std::uint64_t> others_;  // places of other processes, the first ones last
  base::Random choice_;                // among them; no result hangs on it
  std::vector<std::shared_ptr<Running>> running_;
  std::chrono::steady_clock::time_point heard_;
  bool is_over_ = false;  // another process says so
  std::uint64_t before_ = 0;
  bool is_not_kept_ = false;
};

/// The interval of a share as the definition wants it: exact, or one for who looked again and again.
statistics::Interval interval_of(const Definition& definition, statistics::Count count, double confidence);

}  // namespace mlab::study
