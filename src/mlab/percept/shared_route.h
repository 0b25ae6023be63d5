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

/// How many pieces the route of a SEARCH has: where a point stands twice the next one begins.
inline std::size_t piece_count(std::span<const geom::Point> route) {
  std::size_t count = route.empty() ? 0 : 1;
  for (std::size_t i = 1; i < route.size(); ++i) count += route[i] == route[i - 1] ? 1 : 0;
  return count;
}

/// A piece, from 0; empty where there is none.
inline std::span<const geom::Point> piece(std::span<const geom::Point> route, std::size_t number) {
  std::size_t begin = 0;
  for (std::size_t i = 1; i <= route.size(); ++i) {
    if (i < route.size() && !(route[i] == route[i - 1])) continue;
    if (number-- == 0) return route.subspan(begin, i - begin);
    begin = i;
  }
  return {};
}

}  // namespace mlab::percept
