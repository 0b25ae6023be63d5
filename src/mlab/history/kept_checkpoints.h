#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

#include "mlab/history/replay.h"

namespace mlab::history {

/// Checkpoints of one run, within a budget of memory. Where it is exceeded, those go first that leave the
/// fewest cycles to be computed again: they end up evenly spread over the run, but denser where somebody
/// looks.
class KeptCheckpoints {
 public:
  explicit KeptCheckpoints(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  /// Where there is one of that cycle already, it stays.
  void add(const Replay::Checkpoint& checkpoint);
  /// The last one up to the cycle; null: there is none.
  const Replay::Checkpoint* before(std::uint64_t cycle) const;
  bool has(std::uint64_t cycle) const { return by_cycle_.contains(cycle); }
  /// Somebody looks there.
  void look_at(std::uint64_t cycle) { looked_at_ = cycle; }

  std::size_t size() const { return by_cycle_.size(); }
  std::size_t bytes() const { return bytes_; }

 private:
  void thin();

  std::size_t most_bytes_;
  std::size_t bytes_ = 0;
  std::uint64_t looked_at_ = 0;
  std::map<std::uint64_t, Replay::Checkpoint> by_cycle_;
};

}  // namespace mlab::history
