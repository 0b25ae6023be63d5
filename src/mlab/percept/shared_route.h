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

/// Visits the pieces that the route of a SEARCH has, in order, until visit(piece) gives false. Where a point
/// stands twice the next piece begins where the one before ends; where it stands three times the way to it
/// belongs to neither.
template <class Visit>
void each_piece(std::span<const geom::Point> route, Visit&& visit) {
  const auto repeats = [&](std::size_t i) { return i > 0 && i < route.size() && route[i] == route[i - 1]; };
  std::size_t begin = 0;
  for (std::size_t end = 1; end <= route.size(); ++end) {
    if (end < route.size() && (!repeats(end) || repeats(end + 1))) continue;
    const bool is_three = end < route.size() && end - begin > 2 && repeats(end - 1);
    if (!visit(route.subspan(begin, end - begin - (is_three ? 2 : 0)))) return;
    begin = end;
  }
}

/// How many pieces it has.
inline std::size_t piece_count(std::span<const geom::Point> route) {
  std::size_t count = 0;
  each_piece(route, [&](std::span<const geom::Point>) { return ++count > 0; });
  return count;
}

/// A piece, from 0; empty where there is none.
inline std::span<const geom::Point> piece(std::span<const geom::Point> route, std::size_t number) {
  std::span<const geom::Point> out;
  each_piece(route, [&](std::span<const geom::Point> one) {
    const bool goes_on = number-- > 0;
    if (!goes_on) out = one;
    return goes_on;
  });
  return out;
}

}  // namespace mlab::percept
