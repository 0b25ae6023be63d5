// Networks in the words of the historic toolset: its procedure and port names, degrees, constants in braces.

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "../testing/network.h"

namespace mlab::library_test {
namespace {

using geom::Point;

constexpr std::string_view kGoTo = R"(
node stick_x is DATABASE_DOUBLE with key = {"joystick_x"}; initial = 0; nend
node stick_y is DATABASE_DOUBLE with key = {"joystick_y"}; initial = 0; nend
node stick_gain is DATABASE_DOUBLE with key = {"joystick_magnitude"}; initial = 0; nend
node mode is DATABASE_INT with key = {"telop_mode"}; initial = 0; nend
node here is GET_LOCATION with nend
node place is GET_XY with cur_pos = here; nend
node heading is GET_HEADING with cur_pos = here; nend
node goal is GLOBAL_TO_EGOCENTRIC with global = {100, 50}; robot_location = place; robot_heading = heading; nend
node seek is MOVE_TO with goal_rel_loc = goal; have_a_goal = {true}; nend
node around is DETECT_OBSTACLES with max_sensor_range = {1000}; nend
node avoid is AVOID_OBSTACLES with sphere = {3.0}; safety_margin = {0.5}; readings = around; nend
node wander is NOISE with persistence = {10}; robot_heading = heading; nend
node stick is TELOP |the operator| with
  telop_mode = mode; robot_heading = heading; joystick_x = stick_x; joystick_y = stick_y; joystick2_x = 0;
  joystick2_y = 0; slider_1 = 0; slider_2 = 0; joy_buttons = 0;
nend
node joy is SCALE_VECTOR with v = stick; multiplier = stick_gain; nend
node sum is COOP with
  members = seek;   members = avoid;  members = wander; members = joy;
  weight = {1.0};   weight = {0.5};   weight = {0.0};   weight = {1.0};
nend
node wheels is DRIVE_W_SPIN with
  v = sum; max_vel = {2.0}; base_vel = {1.0}; cautious_vel = {0.1}; cautious_mode = {false};
nend
)";

TEST(HistoricNetwork, GoesToItsGoalWhereverItLooks) {
  const auto program = program_of("go_to.cnl", kGoTo);
  ASSERT_NE(program, nullptr);
  for (const double heading : {0.0, kNorth, -3.0}) {
    flow::Frame frame = program->make_frame();
    percept::Percepts percepts;
    percepts.pose = {{100.0, 40.0}, heading};
    percept::Action action;
    program->step(frame.data(), percepts, action, 1, 1);
    const geom::Offset v = percepts.pose.to_world(action.velocity);
    EXPECT_NEAR(v.x, 0.0, 1e-12);
    EXPECT_NEAR(v.y, 1.0, 1e-12);
    EXPECT_FALSE(action.spins);
  }
}

TEST(HistoricNetwork, TellsItsHeadingInDegrees) {
  const auto program = program_of("go_to.cnl", kGoTo);
  ASSERT_NE(program, nullptr);
  const flow::Port* heading = program->find("heading");
  ASSERT_NE(heading, nullptr);
  EXPECT_EQ(heading->edge_unit, "deg");
}

constexpr std::string_view kCompass = R"(
node here is GET_LOCATION with nend
node heading is GET_HEADING with cur_pos = here; nend
node ahead is MOVE_AHEAD with heading = {90}; nend
node is_north is ISFACING with desired_heading = 90; accuracy = 2; robot_heading = heading; nend
sequence motion of Vector with
  start state Going is ahead;
    when is_north goto Resting;
  final state Resting is stop;
nend
node stop is NOOP with nend
node wheels is DRIVE with v = motion; max_vel = 1; base_vel = 1; cautious_vel = 1; cautious_mode = false; nend
)";

TEST(HistoricNetwork, TakesAnglesInDegrees) {
  const auto program = program_of("compass.cnl", kCompass, true);  // the heading node: its readers ignore it
  ASSERT_NE(program, nullptr);
  flow::Frame frame = program->make_frame();
  const auto velocity = [&](double heading) {
    percept::Percepts percepts;
    percepts.pose.heading = heading;
    percept::Action action;
    program->step(frame.data(), percepts, action, 1, 1);
    return percepts.pose.to_world(action.velocity);
  };
  EXPECT_NEAR(velocity(0.0).y, 1.0, 1e-12);
  EXPECT_NEAR(velocity(kNorth - 0.05).y, 1.0, 1e-12);
  EXPECT_NEAR(velocity(kNorth - 0.03).y, 0.0, 1e-12);
}

}  // namespace
}  // namespace mlab::library_test
