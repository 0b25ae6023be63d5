#include "mlab/robot/wire/percepts_wire.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "mlab/robot/wire/testing/any_value.h"
#include "mlab/robot/wire/testing/same_bits.h"

namespace mlab::robot_wire {
namespace {

TEST(PerceptsWire, KeepsEveryBitOfWhatARobotPerceives) {
  DecodedPercepts decoded;  // the same for all, as a robot program uses it
  wire::Percepts message;
  EXPECT_TRUE(rc::check("decode(encode(percepts)) == percepts", [&] {
    const testing::AnyPercepts any;
    encode(any.percepts, message);
    wire::Percepts arrived;
    RC_ASSERT(arrived.ParseFromString(message.SerializeAsString()));
    RC_ASSERT(!decoded.decode(arrived));
    RC_ASSERT(testing::same(decoded.percepts(), any.percepts));
  }));
}

TEST(PerceptsWire, KeepsTheSignOfAZero) {
  percept::Percepts percepts;
  percepts.pose.heading = -0.0;
  percepts.time = -0.0;
  wire::Percepts message;
  encode(percepts, message);
  wire::Percepts arrived;
  ASSERT_TRUE(arrived.ParseFromString(message.SerializeAsString()));
  DecodedPercepts decoded;
  ASSERT_FALSE(decoded.decode(arrived));
  EXPECT_TRUE(testing::same(decoded.percepts().pose.heading, -0.0));
  EXPECT_TRUE(testing::same(decoded.percepts().time, -0.0));
}

TEST(PerceptsWire, TellsVelocitiesOnlyWhereSomethingMoves) {
  std::vector<percept::Obstacle> obstacles{{{1.0, 2.0}, 0.5}, {{3.0, 4.0}, 0.5}};
  percept::Percepts percepts;
  percepts.obstacles = obstacles;
  wire::Percepts message;
  encode(percepts, message);
  EXPECT_EQ(message.obstacles().velocity_x_size(), 0);
  obstacles[1].velocity = {-0.0, 1.5, 0.0};
  encode(percepts, message);
  EXPECT_EQ(message.obstacles().velocity_x_size(), 2);
  DecodedPercepts decoded;
  ASSERT_FALSE(decoded.decode(message));
  EXPECT_TRUE(testing::same(decoded.percepts(), percepts));
}

TEST(PerceptsWire, RefusesColumnsOfDifferentLengths) {
  const auto problem = [](auto change) {
    wire::Percepts message;
    change(message);
    DecodedPercepts decoded;
    return decoded.decode(message).value_or("none");
  };
  EXPECT_EQ(problem([](wire::Percepts& m) { m.mutable_obstacles()->add_x(1.0); }),
            "the columns of the obstacles are not equally long");
  EXPECT_EQ(problem([](wire::Percepts& m) { m.mutable_obstacles()->add_velocity_x(1.0); }),
            "the columns of the obstacles are not equally long");
  EXPECT_EQ(problem([](wire::Percepts& m) {
              wire::Obstacles& obstacles = *m.mutable_obstacles();
              for (int i = 0; i < 2; ++i) {
                obstacles.add_x(i);
                obstacles.add_y(i);
                obstacles.add_z(i);
                obstacles.add_radius(i);
              }
              obstacles.add_velocity_x(1.0);
              obstacles.add_velocity_y(1.0);
              obstacles.add_velocity_z(1.0);
            }),
            "the columns of the obstacles are not equally long");
  EXPECT_EQ(problem([](wire::Percepts& m) { m.mutable_robots()->add_is_unit_mate(true); }),
            "the columns of the robots are not equally long");
  EXPECT_EQ(problem([](wire::Percepts& m) { m.mutable_objects()->add_id(1); }),
            "the columns of the objects are not equally long");
  EXPECT_EQ(problem([](wire::Percepts& m) { m.mutable_ranges()->add_hit(true); }),
            "the columns of the ranges are not equally long");
  EXPECT_EQ(problem([](wire::Percepts& m) { m.mutable_radio()->add_strength(1.0); }),
            "the columns of the radio are not equally long");
  EXPECT_EQ(problem([](wire::Percepts& m) { m.mutable_order()->mutable_route()->add_y(1.0); }),
            "the columns of the route are not equally long");
  EXPECT_EQ(problem([](wire::Percepts& m) { m.mutable_shared_places()->add_time(1.0); }),
            "the columns of the shared places are not equally long");
  EXPECT_EQ(problem([](wire::Percepts& m) { m.mutable_asked_passages()->add_cost(1.0); }),
            "the columns of the asked passages are not equally long");
  EXPECT_EQ(problem([](wire::Percepts& m) { m.mutable_ground()->add_disc_radius(1.0); }),
            "the columns of the ground are not equally long");
  EXPECT_EQ(problem([](wire::Percepts& m) { m.mutable_ground()->mutable_wall_a()->add_x(1.0); }),
            "the columns of the ground are not equally long");
  EXPECT_EQ(problem([](wire::Percepts& m) { m.mutable_claims()->add_robot(1); }),
            "the columns of the claims are not equally long");
  EXPECT_EQ(problem([](wire::Percepts& m) { m.mutable_contracts()->add_task(1); }),
            "the columns of the contracts are not equally long");
}

TEST(PerceptsWire, TellsWhichWallsAreEdges) {
  const std::vector<geom::Segment> walls{{{1.0, 2.0}, {3.0, 4.0}}, {{5.0, 6.0}, {7.0, 8.0}}};
  percept::Percepts percepts;
  percepts.ground = {1, {}, walls, {}, 1};
  wire::Percepts message;
  encode(percepts, message);
  DecodedPercepts decoded;
  ASSERT_FALSE(decoded.decode(message));
  EXPECT_FALSE(decoded.percepts().ground.is_edge(0));
  EXPECT_TRUE(decoded.percepts().ground.is_edge(1));
  message.mutable_ground()->set_edges(3);
  EXPECT_EQ(decoded.decode(message), "of the ground more walls are edges than there are");
}

TEST(PerceptsWire, RefusesNumbersThatStandForNothing) {
  DecodedPercepts decoded;
  wire::Percepts message;
  message.set_carried_class(static_cast<wire::ObjectClass>(11));
  EXPECT_EQ(decoded.decode(message), "what is carried is of a class that there is not");
  message.Clear();
  message.mutable_order()->set_task(static_cast<wire::Order::Task>(-1));
  EXPECT_EQ(decoded.decode(message), "the order has a task, formation or reference that there is not");
  message.Clear();
  wire::SharedPlaces& places = *message.mutable_shared_places();
  places.add_from(1);
  places.add_object(0);
  places.add_object_class(static_cast<wire::ObjectClass>(11));
  places.add_x(0.0);
  places.add_y(0.0);
  places.add_time(0.0);
  EXPECT_EQ(decoded.decode(message), "a shared place is of a class that there is not");
  message.Clear();
  wire::Contracts& contracts = *message.mutable_contracts();
  contracts.add_task(1);
  contracts.add_object(0);
  contracts.add_x(0.0);
  contracts.add_y(0.0);
  contracts.add_state(static_cast<wire::Contracts::State>(5));
  contracts.add_manager(1);
  contracts.add_contractor(0);
  contracts.add_reneged(0);
  contracts.add_time(0.0);
  EXPECT_EQ(decoded.decode(message), "a contract is in a state that there is not");
  message.Clear();
  message.mutable_unit()->set_rank(std::numeric_limits<std::uint16_t>::max() + 1U);
  EXPECT_EQ(decoded.decode(message), "the unit is larger than units are");
}

}  // namespace
}  // namespace mlab::robot_wire
