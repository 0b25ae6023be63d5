#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace mlab::robot {

/// Robots shared out among the processes of their program.
class ProcessShare {
 public:
  /// @param most  processes for each program
  ProcessShare(std::size_t processes, int most) : load_(processes, 0), most_(most) {}

  /// A robot is in that process; in none where there is none of that number.
  void count(std::size_t process) {
    if (process < load_.size()) ++load_[process];
  }
  /// Of the processes that fit the one with the fewest robots, the first of them; nothing as long as there
  /// may be one more.
  template <class Fits>
  std::optional<std::size_t> least_loaded(Fits&& fits) const {
    int fitting = 0;
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < load_.size(); ++i) {
      if (!fits(i)) continue;
      ++fitting;
      if (!best || load_[i] < load_[*best]) best = i;
    }
    return fitting >= most_ ? best : std::nullopt;
  }

 private:
  std::vector<std::size_t> load_;
  int most_;
};

}  // namespace mlab::robot
