#include "mlab/fleet/assignment.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/random.h"

namespace mlab::fleet {
namespace {

using Points = std::vector<geom::Point>;
using Ranks = std::vector<std::uint32_t>;

Points random_points(std::size_t count, base::Random& random) {
  Points out;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 100 * random.uniform();
    out.push_back({x, 100 * random.uniform()});
  }
  return out;
}

double all_ways(const Points& robots, const Points& stations, const Ranks& taken) {
  double out = 0.0;
  for (std::size_t i = 0; i < robots.size(); ++i) out += distance(robots[i], stations[taken[i]]);
  return out;
}

bool is_permutation(const Ranks& taken) {
  Ranks all(taken.size());
  std::iota(all.begin(), all.end(), 0U);
  return std::ranges::is_permutation(all, taken);
}

TEST(Assignment, NeedsNoMoreWayThanAnyOther) {
  base::Random random(7);
  for (int trial = 0; trial < 60; ++trial) {
    const std::size_t count = 2 + random.below(6);
    const Points robots = random_points(count, random);
    const Points stations = random_points(count, random);
    const Ranks taken = assign_stations(robots, stations);
    ASSERT_TRUE(is_permutation(taken));
    Ranks any(count);
    std::iota(any.begin(), any.end(), 0U);
    double best = 1e9;
    do best = std::min(best, all_ways(robots, stations, any));
    while (std::ranges::next_permutation(any).found);
    EXPECT_NEAR(all_ways(robots, stations, taken), best, 1e-9);
  }
}

TEST(Assignment, CrossesNoTwoWays) {
  base::Random random(8);
  const Points robots = random_points(60, random);
  const Points stations = random_points(60, random);
  const Ranks taken = assign_stations(robots, stations);
  for (std::size_t i = 0; i < 60; ++i) {
    for (std::size_t j = i + 1; j < 60; ++j)
      EXPECT_FALSE(intersects(geom::Segment{robots[i], stations[taken[i]]},
                              geom::Segment{robots[j], stations[taken[j]]}));
  }
}

TEST(Assignment, LetsEachKeepItsOwnWhereNothingIsGained) {
  EXPECT_EQ(assign_stations(Points{{0, 0}, {0, 0}, {0, 0}}, Points{{5, 0}, {-5, 0}, {0, 5}}),
            (Ranks{0, 1, 2}));
}

TEST(Assignment, OfManyIsNeverWorseThanTheirOwnOrder) {
  base::Random random(9);
  const Points robots = random_points(1000, random);
  const Points stations = random_points(1000, random);
  Ranks own(1000);
  std::iota(own.begin(), own.end(), 0U);
  const Ranks taken = assign_stations(robots, stations);
  EXPECT_TRUE(is_permutation(taken));
  EXPECT_LT(all_ways(robots, stations, taken), 0.5 * all_ways(robots, stations, own));
}

TEST(Assignment, TurnsAFormationRoundInPlace) {
  using percept::Formation;
  for (const Formation formation : {Formation::kColumn, Formation::kLine, Formation::kWedge}) {
    Group group;
    group.members = {0, 1, 2, 3};
    group.order.formation = formation;
    group.order.goal = {1000, 0};
    group.spacing = 20.0;
    std::vector<geom::Pose> poses(4);
    for (std::size_t i = 0; i < 4; ++i)
      poses[i].position =
          geom::Point{} + geom::Offset{percept::station(formation, static_cast<int>(i), 4, 20.0).x,
                                       percept::station(formation, static_cast<int>(i), 4, 20.0).y};
    const Ranks own = group.members;
    group.assigns_stations = true;
    assign_ranks(group, poses);
    EXPECT_EQ(group.members, own) << "all are in place";
    group.order.goal = {-1000, 0};
    group.assigns_stations = false;
    assign_ranks(group, poses);
    EXPECT_EQ(group.members, own) << "by rank unless it is told";
    group.assigns_stations = true;
    assign_ranks(group, poses);
    update_group(group, poses);
    double error = 0.0;
    for (std::size_t rank = 0; rank < 4; ++rank) error += station_error(group, rank, poses);
    if (formation == Formation::kWedge) {
      EXPECT_LE(error, 80.0) << "a wedge turns its point";
    } else {
      EXPECT_LT(error, 1e-9) << "nobody has to move";
    }
    group.reference = percept::FormationReference::kLeader;
    const std::uint32_t leader = group.members.front();
    group.order.goal = {0, 1000};
    assign_ranks(group, poses);
    EXPECT_EQ(group.members.front(), leader) << "who others measure from keeps its place";
  }
}

}  // namespace
}  // namespace mlab::fleet
