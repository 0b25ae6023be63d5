#pragma once

namespace mlab::overlay {

/// A coordinate or size past this is a mistake, not a map: UTM northings end at ten million [m].
inline constexpr double kMaxCoordinate = 1e8;

}  // namespace mlab::overlay
