#include "mlab/ways/lane_ends.h"

#include <algorithm>

namespace mlab::ways {

double LaneEnds::way(PieceEnd a, PieceEnd b) {
  if (place(a) == place(b)) return 0.0;
  const auto key = (static_cast<std::uint64_t>(std::min(a, b)) << 32U) | std::max(a, b);
  const auto [known, is_new] = ways_.try_emplace(key, kNoWay);
  if (is_new) {
    if (const auto found = planner_.find(place(a), place(b))) known->second = found->length;
  }
  return known->second;
}

void turn_part(std::vector<PieceEnd>& order, std::size_t first, std::size_t end) {
  std::reverse(order.begin() + static_cast<std::ptrdiff_t>(first),
               order.begin() + static_cast<std::ptrdiff_t>(end));
  for (std::size_t i = first; i < end; ++i) order[i] ^= 1U;
}

}  // namespace mlab::ways
