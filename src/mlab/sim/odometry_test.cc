#include "mlab/sim/odometry.h"

#include <cmath>

#include <gtest/gtest.h>

#include "mlab/sim/simulator.h"

namespace mlab::sim {
namespace {

TEST(Odometry, CountsExactlyWithoutNoise) {
  base::Random random(1);
  const geom::Pose was{{1.0, 2.0}, 0.5};
  const OdometryStep step{{{10.0, 0.0}, 0.5}, {{11.0, 1.0}, 0.75}};
  const geom::Pose now = counted(was, step, 0.0, random);
  EXPECT_NEAR(now.position.x, 2.0, 1e-12);
  EXPECT_NEAR(now.position.y, 3.0, 1e-12);
  EXPECT_NEAR(now.heading, 0.75, 1e-12);
}

TEST(Odometry, StaysPutWhereNothingMoved) {
  base::Random random(1);
  const geom::Pose was{{1.0, 2.0}, 0.5};
  const geom::Pose now = counted(was, {{{5.0, 5.0}, 1.0}, {{5.0, 5.0}, 1.0}}, 0.2, random);
  EXPECT_EQ(now.position, was.position);
  EXPECT_DOUBLE_EQ(now.heading, was.heading);
}

// A robot that drives 20 m straight ahead and believes what its wheels say.
struct Drifting {
  explicit Drifting(double noise) {
    BodySetup setup;
    setup.robot = {1};
    setup.spec.odometry_noise = noise;
    body = simulator.add_body(setup)->body;
    std::vector<percept::Action> actions(1);
    actions[0].velocity = {1.0, 0.0, 0.0};
    actions[0].drives = true;
    for (int i = 0; i < 200; ++i) simulator.step(actions, 0.1);
  }
  geom::Pose believed() {
    simulator.sense(body, {}, buffer, percepts);
    return percepts.pose;
  }

  Simulator simulator{World{}};
  BodyIndex body;
  SenseBuffer buffer;
  percept::Percepts percepts;
};

TEST(Simulator, TellsThePoseThatTheWheelsCounted) {
  Drifting exact(0.0);
  EXPECT_EQ(exact.believed().position, exact.simulator.pose(exact.body).position);
  Drifting rough(0.05);
  const geom::Pose real = rough.simulator.pose(rough.body);
  const double error = distance(rough.believed().position, real.position);
  EXPECT_GT(error, 1e-3);
  EXPECT_LT(error, 1.0);
  EXPECT_NEAR(real.position.x, 20.0, 1e-9);
}

TEST(Simulator, LetsARobotCorrectWhatItCounted) {
  Drifting rough(0.05);
  std::vector<percept::Action> actions(1);
  percept::Request here;
  here.kind = percept::Request::Kind::kLocalize;
  here.place = {7.0, 8.0};
  here.heading = 1.0;
  actions[0].ask(here);
  rough.simulator.step(actions, 0.1);
  EXPECT_EQ(rough.believed().position, (geom::Point{7.0, 8.0}));
  EXPECT_DOUBLE_EQ(rough.believed().heading, 1.0);
  EXPECT_NEAR(rough.simulator.pose(rough.body).position.x, 20.0, 1e-9);
}

TEST(Simulator, PutsARobotThatKnowsItsPoseWhereItSaysThatItIs) {
  Drifting exact(0.0);
  std::vector<percept::Action> actions(1);
  percept::Request here;
  here.kind = percept::Request::Kind::kLocalize;
  here.place = {7.0, 8.0};
  here.heading = 1.0;
  actions[0].ask(here);
  exact.simulator.step(actions, 0.1);
  EXPECT_EQ(exact.simulator.pose(exact.body).position, (geom::Point{7.0, 8.0}));
  EXPECT_DOUBLE_EQ(exact.simulator.pose(exact.body).heading, 1.0);
  here.place = {NAN, 0.0};
  actions[0] = {};
  actions[0].ask(here);
  exact.simulator.step(actions, 0.1);
  EXPECT_EQ(exact.simulator.pose(exact.body).position, (geom::Point{7.0, 8.0}));
}

}  // namespace
}  // namespace mlab::sim
