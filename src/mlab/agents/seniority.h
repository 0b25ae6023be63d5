#pragma once

#include "mlab/dds/message.h"

namespace mlab::agents {

/// One of two agents that say that the same name is theirs.
struct Claimant {
  dds::Guid guid;
  double uptime = 0.0;  ///< since it began, at the moment of asking [s]
};

/// Which of two agents of one name keeps it: the one that has been there for longer, since it may carry
/// robots. Of two that began within `kBeganTogether` of each other it is the one with the lower number, so
/// that what messages take on their way does not matter.
inline constexpr double kBeganTogether = 4.0;  // [s]
inline bool keeps_name(const Claimant& one, const Claimant& other) {
  const double ahead = one.uptime - other.uptime;
  if (ahead > kBeganTogether || ahead < -kBeganTogether) return ahead > 0.0;
  return one.guid < other.guid;
}

}  // namespace mlab::agents
