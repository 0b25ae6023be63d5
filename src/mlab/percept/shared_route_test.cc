#include "mlab/percept/shared_route.h"

#include <array>
#include <vector>

#include <gtest/gtest.h>

namespace mlab::percept {
namespace {

using Route = std::vector<geom::Point>;

constexpr geom::Point kA{0, 0};
constexpr geom::Point kB{1, 0};
constexpr geom::Point kC{2, 0};
constexpr geom::Point kD{3, 0};

std::vector<Route> pieces_of(const Route& route) {
  std::vector<Route> out;
  for (std::size_t i = 0; i < piece_count(route); ++i) {
    const auto one = piece(route, i);
    out.emplace_back(one.begin(), one.end());
  }
  EXPECT_TRUE(piece(route, out.size()).empty());
  return out;
}

TEST(SharedRoute, BeginsAPieceWhereAPointStandsTwice) {
  EXPECT_EQ(pieces_of({}), std::vector<Route>{});
  EXPECT_EQ(pieces_of({kA}), (std::vector<Route>{{kA}}));
  EXPECT_EQ(pieces_of({kA, kB, kC}), (std::vector<Route>{{kA, kB, kC}}));
  EXPECT_EQ(pieces_of({kA, kB, kB, kC, kC, kD}), (std::vector<Route>{{kA, kB}, {kB, kC}, {kC, kD}}));
}

TEST(SharedRoute, DoesNotLeadToWhereAPointStandsThreeTimes) {
  EXPECT_EQ(pieces_of({kA, kB, kD, kD, kD, kC}), (std::vector<Route>{{kA, kB}, {kD, kC}}));
  EXPECT_EQ(pieces_of({kA, kB, kB, kC, kD, kD, kD, kA, kA, kB}),
            (std::vector<Route>{{kA, kB}, {kB, kC}, {kD, kA}, {kA, kB}}));
}

}  // namespace
}  // namespace mlab::percept
