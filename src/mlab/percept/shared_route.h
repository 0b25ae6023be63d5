#pragma once

#include <cstddef>
#include <span>

#include "mlab/geom/pose.h"

// The route of an order that a unit shares among its robots, as who gives the order makes it and who carries
// it out reads it.
namespace mlab::percept {

/// The most parts of it: places to visit, or pieces of a way to search.
inline constexpr std::size_t kMostParts = 128;
/// So many pieces of a SEARCH that follow each other are a robot's share.
inline constexpr std::size_t kPiecesOfAShare = 4;

/// Whether a piece of the route of a SEARCH begins with that point: where a point stands twice the next piece
/// begins where the one before ends; where it stands three times the way to it belongs to neither.
inline bool begins_piece(std::span<const geom::Point> route, std::size_t i) {
  if (i == 0) return !route.empty();
  return route[i] == route[i - 1] && !(i + 1 < route.size() && route[i + 1] == route[i]);
}

/// How many pieces it has.
inline std::size_t piece_count(std::span<const geom::Point> route) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < route.size(); ++i) count += begins_piece(route, i) ? 1 : 0;
  return count;
}

/// A piece, from 0; empty where there is none.
inline std::span<const geom::Point> piece(std::span<const geom::Point> route, std::size_t number) {
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= route.size(); ++i) {
    if (i < route.size() && !begins_piece(route, i)) continue;
    if (number-- > 0) {
      begin = i;
      continue;
    }
    const bool leads_on = i >= 2 && i < route.size() && route[i - 1] == route[i - 2] && i - begin > 2;
    return route.subspan(begin, i - begin - (leads_on ? 2 : 0));
  }
  return {};
}

}  // namespace mlab::percept
