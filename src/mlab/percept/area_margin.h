#pragma once

namespace mlab::percept {

/// How near to the edge of the mission area a robot's centre may come [m].
inline constexpr double kAreaMargin = 0.5;

}  // namespace mlab::percept
