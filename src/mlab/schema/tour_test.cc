#include "mlab/schema/tour.h"

#include <vector>

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

using geom::Point;

// A square of 100 m; robots that go round it tell where they are.
class Stretches : public testing::Test {
 protected:
  Stretches() {
    percepts_.order.task = percept::Task::kPatrol;
    percepts_.order.sequence = 3;
    percepts_.order.route = tour_;
    percepts_.time = 10.0;
  }

  void tell(std::uint32_t robot, std::size_t leg, Point place, double time = 10.0,
            bool comes_to_none = false) {
    told_.push_back({{robot},
                     tour_code(percepts_.order, {.leg = leg, .comes_to_none = comes_to_none}),
                     percept::ObjectClass::kUnknown,
                     place,
                     time});
  }

  std::vector<Stretch> all() {
    percepts_.shared_places = told_;
    return stretches(percepts_, 5.0, 0.2, 5.0);
  }

  // Of the robots, in their order.
  std::vector<std::uint32_t> robots() {
    std::vector<std::uint32_t> out;
    for (const Stretch& one : all()) out.push_back(one.robot.value);
    return out;
  }

  const std::vector<Point> tour_ = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
  percept::Percepts percepts_;
  std::vector<percept::SharedPlace> told_;
};

TEST_F(Stretches, ReachFromEachRobotToTheNextOne) {
  tell(7, 1, {20, 3});
  tell(4, 3, {50, 98});
  const std::vector<Stretch> out = all();
  ASSERT_EQ(out.size(), 2U);
  EXPECT_EQ(out[0].robot.value, 7U);
  EXPECT_EQ(out[0].way, (std::vector<Point>{{20, 0}, {100, 0}, {100, 100}, {50, 100}}));
  EXPECT_EQ(out[1].robot.value, 4U);
  EXPECT_EQ(out[1].way, (std::vector<Point>{{50, 100}, {0, 100}, {0, 0}, {20, 0}}));
}

TEST_F(Stretches, AreAllOfTheRoundForOneThatIsAlone) {
  tell(1, 2, {100, 30});
  const std::vector<Stretch> out = all();
  ASSERT_EQ(out.size(), 1U);
  EXPECT_EQ(out[0].way, (std::vector<Point>{{100, 30}, {100, 100}, {0, 100}, {0, 0}, {100, 0}, {100, 30}}));
}

TEST_F(Stretches, LeadRoundWhatIsKnownToStandThere) {
  const std::vector<ways::Round> discs = {{{50, 0}, 10.0}};
  percepts_.ground = {1234, discs, {}, {-200, -200, 200, 200}, 0};
  tell(1, 1, {20, -8});
  tell(2, 2, {100, 50});
  const std::vector<Stretch> out = all();
  ASSERT_EQ(out.size(), 2U);
  EXPECT_GT(out[0].way.size(), 3U) << "round the disc";
  for (const Point corner : out[0].way) EXPECT_GE(distance(corner, discs[0].center), 15.0);
  EXPECT_EQ(out[0].way.back(), (Point{100, 50}));
  EXPECT_EQ(out[1].way.back(), out[0].way.front());
}

TEST_F(Stretches, StayOnALegThatTwoAreOn) {
  tell(1, 1, {80, 0});
  tell(2, 1, {30, 0});
  const std::vector<Stretch> out = all();
  ASSERT_EQ(out.size(), 2U);
  EXPECT_EQ(out[0].robot.value, 2U);
  EXPECT_EQ(out[0].way, (std::vector<Point>{{30, 0}, {80, 0}}));
  EXPECT_EQ(out[1].way.size(), 6U) << "the rest of the round";
}

TEST_F(Stretches, OfRobotsSideBySideEndAtTheOneOfTheLowerNumber) {
  tell(2, 1, {50, 0});
  tell(5, 1, {50, 0});
  EXPECT_EQ(robots(), (std::vector<std::uint32_t>{5, 2}));
  EXPECT_EQ(all()[0].way, (std::vector<Point>{{50, 0}, {50, 0}}));
}

TEST_F(Stretches, AtACornerGoOnWithTheLegThatARobotIsOn) {
  tell(1, 2, {100, 0});
  tell(2, 1, {100, 0});
  const std::vector<Stretch> out = all();
  ASSERT_EQ(out.size(), 2U);
  EXPECT_EQ(out[0].robot.value, 2U);
  EXPECT_EQ(out[0].way, (std::vector<Point>{{100, 0}, {100, 0}, {100, 0}}));
}

TEST_F(Stretches, AreOfNobodyWhoIsSilentOrComesToNoPlaceOrFollowsAnotherOrder) {
  tell(1, 1, {20, 0}, 4.0);
  tell(2, 2, {100, 20}, 10.0, true);
  tell(3, 3, {50, 100});
  ++percepts_.order.sequence;
  tell(4, 0, {0, 50});
  EXPECT_EQ(robots(), (std::vector<std::uint32_t>{4}));
}

}  // namespace
}  // namespace mlab::schema
