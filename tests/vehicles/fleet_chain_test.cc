// All that lies between a vehicle and the robot of a run that has it: a rover, its device, its process, and
// the run's bodies, on the clock of a test.

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>

#include "line_rig.h"
#include "mlab/base/angle.h"
#include "mlab/mavlink/rover_device.h"
#include "mlab/model_vehicles/mavlink_rover_model.h"
#include "mlab/sim/simulated_binding.h"
#include "mlab/vehicle/bodies.h"
#include "mlab/vehicle/server.h"

namespace mlab::vehicle {
namespace {

constexpr geom::Point kFar{8000.0, 6000.0};  // 10 km from the origin of the map
constexpr double kCycleTime = 0.1;           // of the run [s]

class FleetChain : public testing::Test {
 protected:
  /// What the vehicle's process says, and what it is told, without any losses.
  class Way final : public Line {
   public:
    explicit Way(FleetChain& chain) : chain_(chain) {}
    std::optional<std::string> hear() override { return std::exchange(chain_.said_, std::nullopt); }
    void tell(const wire::VehicleCommand& command) override {
      if (chain_.server_) chain_.server_->hear("run", command.SerializeAsString(), chain_.now_);
    }

   private:
    FleetChain& chain_;
  };

  /// @param map       of the mission
  /// @param obstacle  that only the vehicle's world has
  void begin(const std::optional<geography::Projection>& map, const geom::Pose& place, geom::Point obstacle) {
    overlay::Overlay world;
    world.projection = map;
    world.area = {20e3, 20e3};
    overlay::ObstacleDisc& disc = world.obstacles.emplace_back();
    disc.center = obstacle;
    disc.radius = 0.5;
    model_vehicles::MavlinkRoverSpec spec;
    spec.place = place;
    spec.max_turn_rate = 2.0;
    spec.scan_lag = 0.26;
    const auto make_device = [&](std::unique_ptr<Stream> stream) -> LineRig::Made {
      mavlink::RoverSettings settings;
      settings.limits.kinematics.max_speed = spec.max_speed;
      settings.limits.kinematics.max_turn_rate = spec.max_turn_rate;
      return std::make_unique<mavlink::RoverDevice>(std::move(stream), settings);
    };
    rig_ = std::make_unique<LineRig>(
        1, Facts{}, std::make_unique<model_vehicles::MavlinkRoverModel>(world, spec), make_device);
    server_ = std::make_unique<Server>(rig_->device(), [] { return false; });
    std::vector<Crewed> crew;
    crew.push_back({"veh-1", rig_->device().limits(), std::make_unique<Way>(*this)});
    bodies_ = std::make_unique<Bodies>(std::make_unique<sim::SimulatedBinding>(sim::world_of(world)),
                                       std::move(crew), 7, map);
  }
  ~FleetChain() override { bodies_.reset(); }

  void cycle(const percept::Action& action) {
    for (int i = 0; i < 5; ++i) {
      now_ = rig_->step();
      server_->work(now_);
      if (i % 2 == 0) said_ = server_->report(now_);
    }
    std::vector<binding::Heard> heard;
    bodies_->hear(heard);
    for (const binding::Heard& one : heard) bodies_->take(one);
    bodies_->carry_out({&action, 1}, kCycleTime);
  }
  void go(double seconds, double speed, double turn_rate) {
    percept::Action action;
    action.drives = action.spins = true;
    action.velocity = {speed, 0.0, 0.0};
    action.spin = turn_rate;
    for (double t = 0.0; t < seconds; t += kCycleTime) cycle(action);
  }
  std::expected<binding::Placement, std::string> embody(const geom::Pose& start) {
    binding::BodySetup setup;
    setup.robot = {1};
    setup.pose = start;
    setup.vehicle = "veh-1";
    auto placed = bodies_->embody(setup);
    if (placed) body_ = placed->body;
    return placed;
  }
  geom::Pose pose() const {
    geom::Pose out;
    bodies_->poses({&body_, 1}, {&out, 1});
    return out;
  }
  std::vector<percept::Obstacle> obstacles() {
    const percept::Needs needs{{percept::Sensor::kObstacles, 20.0}};
    percept::Percepts out;
    const binding::Sensing sensing{body_, &needs, &out};
    bodies_->percepts({&sensing, 1}, 0);
    return {out.obstacles.begin(), out.obstacles.end()};
  }

  std::unique_ptr<LineRig> rig_;
  std::unique_ptr<Server> server_;
  std::unique_ptr<Bodies> bodies_;
  std::optional<std::string> said_;
  Clock::time_point now_;
  binding::BodyIndex body_;
};

double off(double a, double b) {
  return std::abs(base::wrap_angle(a - b));
}

TEST_F(FleetChain, PutsARoverWhereItIsOnTheEarthToACentimetre) {
  const auto map = geography::Projection::around({48.2082, 16.3738});
  begin(map, {kFar, 0.7}, {kFar.x + 50.0, kFar.y});
  go(8.0, 0.0, 0.0);
  const auto placed = embody({{10.0, 10.0}, 0.0});
  ASSERT_TRUE(placed) << placed.error();
  EXPECT_TRUE(placed->moved) << "it is where it says, not where the mission wants it";
  EXPECT_LE(geom::distance(pose().position, rig_->truth().pose.position), 0.01);
  EXPECT_LE(off(pose().heading, rig_->truth().pose.heading), 1e-4) << "its north is not the map's";
  go(6.0, 0.8, 0.3);
  EXPECT_GT(geom::distance(kFar, rig_->truth().pose.position), 1.0);
  go(1.5, 0.0, 0.0);
  EXPECT_LE(geom::distance(pose().position, rig_->truth().pose.position), 0.01);
  EXPECT_LE(off(pose().heading, rig_->truth().pose.heading), 1e-4);
}

TEST_F(FleetChain, PutsARoverWhereTheMissionHasItWithoutAMapOfTheEarth) {
  begin({}, {{3.0, 4.0}, 0.0}, {50.0, 0.0});
  go(8.0, 0.0, 0.0);
  ASSERT_TRUE(embody({{10.0, 10.0}, 0.5}));
  EXPECT_LE(geom::distance(pose().position, {10.0, 10.0}), 1e-9);
}

// At 2 rad/s what was measured a quarter of a second ago is 30 degrees, here 2 m, farther round by now.
TEST_F(FleetChain, LeavesObstaclesWhereTheyAreWhileTheVehicleTurns) {
  const geom::Point obstacle{14.0, 10.0};
  begin({}, {{10.0, 10.0}, 0.0}, obstacle);
  go(8.0, 0.0, 0.0);
  ASSERT_TRUE(embody({{10.0, 10.0}, 0.0}));
  go(3.0, 0.0, 2.0);
  double worst = 0.0;
  for (int i = 0; i < 60; ++i) {
    go(kCycleTime / 2.0, 0.0, 2.0);
    const auto seen = obstacles();
    ASSERT_FALSE(seen.empty());
    for (const percept::Obstacle& one : seen)
      worst = std::max(worst, geom::distance(pose().point_at(one.center), obstacle));
  }
  // Its front is what is seen of it, by beams that are 0.35 m apart there.
  EXPECT_LE(worst, 0.75);
  EXPECT_GT(std::abs(rig_->truth().turn_rate), 1.9);
}

}  // namespace
}  // namespace mlab::vehicle
