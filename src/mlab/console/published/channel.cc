#include "mlab/console/published/channel.h"

#include <algorithm>

namespace mlab::console {

void Channel::watch(const Watch& wanted) {
  ++watch_number_;
  constexpr double kDefaultRate = 30.0;
  watch_ = wanted;
  const auto cut = [](auto& list, std::size_t most) {
    if (list.size() > static_cast<int>(most))
      list.DeleteSubrange(static_cast<int>(most), list.size() - static_cast<int>(most));
  };
  if (watch_.details_size() > static_cast<int>(kMostDetails))
    watch_.mutable_details()->Truncate(kMostDetails);
  cut(*watch_.mutable_series(), kMostSeries);
  cut(*watch_.mutable_ports(), kMostPorts);
  interval_ = 1.0 / (wanted.rate() == 0 ? kDefaultRate : std::clamp<double>(wanted.rate(), 1.0, 60.0));
  seen = 0;
  next_ = 0.0;
  std::map<std::uint32_t, double> kept;
  for (const Series& series : watch_.series()) {
    if (const auto at = series_seen.find(series.id()); at != series_seen.end()) kept.insert(*at);
  }
  series_seen = std::move(kept);
  failsafes_seen.clear();
}

double Channel::next_frame() const {
  constexpr double kFar = 1e18;
  return has_room() ? next_ : kFar;
}

std::uint64_t Channel::begin_frame(double wall) {
  // The rate holds on average where a frame is a little late, and does not race after a long gap.
  next_ = std::max(next_ + interval_, wall + 0.5 * interval_);
  under_way_.push_back(++last_frame_);
  return last_frame_;
}

void Channel::acknowledge(std::uint64_t frame) {
  while (!under_way_.empty() && under_way_.front() <= frame) under_way_.pop_front();
}

}  // namespace mlab::console
