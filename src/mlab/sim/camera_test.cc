#include "mlab/sim/camera.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "mlab/base/angle.h"
#include "mlab/sim/simulator.h"

namespace mlab::sim {
namespace {

using base::radians;
using std::numbers::pi;

TEST(Camera, TurnsAtOnceWhereNothingLimitsIt) {
  EXPECT_DOUBLE_EQ(turned_camera({}, 0.0, 2.0, 0.1), 2.0);
}

TEST(Camera, TurnsNoFasterThanItCan) {
  const CameraSpec camera{.max_pan_rate = 1.0};
  EXPECT_DOUBLE_EQ(turned_camera(camera, 0.0, 2.0, 0.1), 0.1);
  EXPECT_DOUBLE_EQ(turned_camera(camera, 0.0, -2.0, 0.1), -0.1);
  EXPECT_DOUBLE_EQ(turned_camera(camera, 1.95, 2.0, 0.1), 2.0);
}

TEST(Camera, TakesTheShortWayRoundUnlessAnEndStopIsThere) {
  const CameraSpec endless{.max_pan_rate = 1.0};
  EXPECT_NEAR(turned_camera(endless, radians(170), radians(-170), 0.1), radians(170) + 0.1, 1e-12);
  const CameraSpec stopped{.max_pan = radians(175), .max_pan_rate = 1.0};
  EXPECT_NEAR(turned_camera(stopped, radians(170), radians(-170), 0.1), radians(170) - 0.1, 1e-12);
}

TEST(Camera, StopsAtItsLimits) {
  const CameraSpec camera{.max_pan = 1.0};
  EXPECT_DOUBLE_EQ(turned_camera(camera, 0.0, 2.0, 0.1), 1.0);
  EXPECT_DOUBLE_EQ(turned_camera(camera, 0.0, -2.0, 0.1), -1.0);
}

TEST(Camera, IgnoresAWishThatIsNoNumber) {
  EXPECT_EQ(turned_camera({}, 0.5, std::numeric_limits<double>::quiet_NaN(), 0.1), 0.5);
  EXPECT_EQ(turned_camera({}, 0.5, std::numeric_limits<double>::infinity(), 0.1), 0.5);
}

TEST(FieldOfView, HoldsWhatLiesWithinHalfItsAngleOfTheAxis) {
  const FieldOfView narrow({.field_of_view = radians(60)}, radians(90));
  EXPECT_TRUE(narrow.contains({0.0, 5.0, 0.0}));
  EXPECT_TRUE(narrow.contains(geom::polar(5.0, radians(119))));
  EXPECT_FALSE(narrow.contains(geom::polar(5.0, radians(121))));
  EXPECT_FALSE(narrow.contains({5.0, 0.0, 0.0}));
  const FieldOfView wide({.field_of_view = radians(300)}, 0.0);
  EXPECT_TRUE(wide.contains(geom::polar(5.0, radians(149))));
  EXPECT_FALSE(wide.contains(geom::polar(5.0, radians(-151))));
}

TEST(FieldOfView, OfAllRoundHoldsEverything) {
  const FieldOfView all({}, 1.0);
  for (int degree = 0; degree < 360; ++degree) EXPECT_TRUE(all.contains(geom::polar(1.0, radians(degree))));
}

struct Watcher {
  Simulator simulator{world()};
  SenseBuffer buffer;
  BodyIndex body;

  explicit Watcher(CameraSpec camera) {
    BodySpec spec;
    spec.camera = camera;
    body = simulator.add_body({.spec = spec, .pose = {{0, 0}, 0}, .robot = {1}, .unit = 0})->body;
  }
  static World world() {
    World out;
    out.objects.push_back({.id = {1}, .center = {5, 0}, .carrier = {}, .basket = {}});
    out.objects.push_back({.id = {2}, .center = {0, 6}, .carrier = {}, .basket = {}});
    return out;
  }
  percept::Percepts look(double pan) {
    percept::Action action;
    action.looks = true;
    action.pan = pan;
    simulator.step({&action, 1}, 0.1);
    percept::Percepts out;
    simulator.sense(body, {{percept::Sensor::kObjects, 100}}, buffer, out);
    return out;
  }
};

TEST(Simulator, ShowsOnlyTheObjectsInTheCamerasFieldOfView) {
  Watcher w({.field_of_view = radians(60)});
  percept::Percepts ahead = w.look(0.0);
  ASSERT_EQ(ahead.objects.size(), 1U);
  EXPECT_EQ(ahead.objects[0].id.value, 1U);
  percept::Percepts aside = w.look(pi / 2);
  ASSERT_EQ(aside.objects.size(), 1U);
  EXPECT_EQ(aside.objects[0].id.value, 2U);
  EXPECT_DOUBLE_EQ(aside.camera.pan, pi / 2);
  EXPECT_DOUBLE_EQ(aside.camera.field_of_view, radians(60));
}

TEST(Simulator, ShowsAllObjectsToACameraThatSeesAllRound) {
  Watcher w({});
  EXPECT_EQ(w.look(1.0).objects.size(), 2U);
}

TEST(Simulator, LeavesTheCameraWhereItIsUntilItIsTurned) {
  Watcher w({.field_of_view = radians(60)});
  w.look(1.0);
  percept::Action action;
  action.pan = 0.3;
  w.simulator.step({&action, 1}, 0.1);
  percept::Percepts out;
  w.simulator.sense(w.body, {}, w.buffer, out);
  EXPECT_DOUBLE_EQ(out.camera.pan, 1.0);
}

}  // namespace
}  // namespace mlab::sim
