#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mlab/console.pb.h"
#include "mlab/console/run/event_log.h"

namespace mlab::console {

/// What was told of one of two runs alone.
struct ToldApart {
  static constexpr std::size_t kMost = 300;  ///< of each; alerts before all else

  std::array<std::vector<Log::Entry>, 2> alone;  ///< by time, the first one's first
  std::uint64_t left_out = 0;
};

/// The same words, in the same order, are the same event, whenever they were told. Changes of robots' states
/// are not among them: they are on the time line of each robot.
ToldApart told_apart(const EventLog& own, const EventLog& other);

}  // namespace mlab::console
