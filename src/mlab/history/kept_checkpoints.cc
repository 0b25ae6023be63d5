#include "mlab/history/kept_checkpoints.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace mlab::history {
namespace {

// So many mean distances from where somebody looks, being near does not count any more.
constexpr double kNear = 4.0;

}  // namespace

void KeptCheckpoints::add(const Replay::Checkpoint& checkpoint) {
  const std::size_t bytes = checkpoint.run.bytes();
  const std::uint64_t cycle = checkpoint.run.cycle();
  if (!by_cycle_.try_emplace(cycle, checkpoint).second) return;
  bytes_ += bytes;
  while (bytes_ > most_bytes_ && by_cycle_.size() > 2) thin();
}

const Replay::Checkpoint* KeptCheckpoints::before(std::uint64_t cycle) const {
  const auto after = by_cycle_.upper_bound(cycle);
  return after == by_cycle_.begin() ? nullptr : &std::prev(after)->second;
}

// The first and the last stay: what is before or behind them nobody else knows.
void KeptCheckpoints::thin() {
  const auto all = static_cast<double>(by_cycle_.rbegin()->first);
  const double far = std::max(1.0, kNear * all / static_cast<double>(by_cycle_.size()));
  auto worst = by_cycle_.end();
  double least = std::numeric_limits<double>::infinity();
  for (auto at = std::next(by_cycle_.begin()); std::next(at) != by_cycle_.end(); ++at) {
    const auto gap = static_cast<double>(std::next(at)->first - std::prev(at)->first);
    const double away = std::abs(static_cast<double>(at->first) - static_cast<double>(looked_at_));
    const double loss = gap / std::clamp(away, 1.0, far);
    if (loss >= least) continue;
    least = loss;
    worst = at;
  }
  bytes_ -= worst->second.run.bytes();
  by_cycle_.erase(worst);
}

}  // namespace mlab::history
