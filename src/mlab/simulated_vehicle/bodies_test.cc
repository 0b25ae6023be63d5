#include "mlab/vehicle/bodies.h"

#include <deque>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "mlab/sim/simulated_binding.h"
#include "mlab/vehicle/messages.h"

namespace mlab::vehicle {
namespace {

constexpr std::uint64_t kSession = 7;

/// A vehicle's process that says what the test wants, and remembers what it was told.
struct Radio {
  std::deque<std::string> said;
  std::vector<wire::VehicleCommand> told;
};

class RadioLine final : public Line {
 public:
  explicit RadioLine(std::shared_ptr<Radio> radio) : radio_(std::move(radio)) {}
  std::optional<std::string> hear() override {
    if (radio_->said.empty()) return std::nullopt;
    std::string out = std::move(radio_->said.back());
    radio_->said.clear();
    return out;
  }
  void tell(const wire::VehicleCommand& command) override { radio_->told.push_back(command); }

 private:
  std::shared_ptr<Radio> radio_;
};

class VehicleBodies : public testing::Test {
 protected:
  VehicleBodies() { crew(); }
  /// @param refusal  as Crewed::refusal
  void crew(const std::string& refusal = "") {
    sim::World world;
    world.area_low = {0.0, 0.0};
    world.area_high = {100.0, 50.0};
    world.discs = {{{13.0, 20.0}, 1.0}};  // of the map: the vehicle does not see it by that
    Crewed crewed;
    crewed.name = "veh-1";
    crewed.kind = "MAVLink rover at udp:14550";
    crewed.limits.kinematics.drive = binding::Drive::kDifferential;
    crewed.limits.kinematics.max_speed = 0.5;
    crewed.limits.radius = 0.4;
    if (!refusal.empty()) crewed.limits = {};
    crewed.refusal = refusal;
    crewed.line = std::make_unique<RadioLine>(radio_);
    std::vector<Crewed> all;
    all.push_back(std::move(crewed));
    bodies_ = std::make_unique<Bodies>(std::make_unique<sim::SimulatedBinding>(std::move(world)),
                                       std::move(all), kSession);
  }
  void say(const geom::Pose& pose, bool is_global = true, Readiness readiness = Readiness::kReady,
           std::uint64_t held_by = kSession) {
    Report report;
    report.readiness = readiness;
    report.is_global = is_global;
    report.motion = Motion{pose, 0.2, 0.0, {}};
    Scan scan;
    scan.step = std::numbers::pi / 2.0;
    scan.farthest = 10.0;
    scan.distances = {std::numeric_limits<float>::infinity(), 2.0F, std::numeric_limits<float>::infinity(),
                      std::numeric_limits<float>::infinity()};
    report.scans.push_back(scan);
    if (battery_) report.battery = Battery{*battery_, 24.5, {}};
    wire::VehicleReport message;
    encode(report, {}, message);
    message.set_number(++number_);
    message.set_held_by(held_by);
    message.set_command(carried_out_);
    radio_->said.push_back(message.SerializeAsString());
  }
  std::expected<binding::Placement, std::string> embody(std::uint32_t robot, double x, double y) {
    binding::BodySetup setup;
    setup.robot = {robot};
    setup.pose.position = {x, y};
    if (robot != 2) setup.vehicle = "veh-1";
    hear();
    return bodies_->embody(setup);
  }
  geom::Pose pose(binding::BodyIndex body) {
    geom::Pose out;
    bodies_->poses({&body, 1}, {&out, 1});
    return out;
  }
  // As a run does between two cycles.
  void hear() {
    std::vector<binding::Heard> heard;
    bodies_->hear(heard);
    for (const binding::Heard& one : heard) {
      heard_.push_back(one);
      bodies_->take(one);
    }
  }
  std::string ailment() {
    hear();
    std::vector<binding::Ailment> out;
    bodies_->health(out);
    return out.empty() ? "" : out.front().what;
  }
  void carry_out(std::vector<percept::Action> actions) { bodies_->carry_out(actions, 0.1); }
  percept::Percepts sense(binding::BodyIndex body) {
    const percept::Needs needs{
        {percept::Sensor::kObstacles, 20.0}, {percept::Sensor::kRobots, 50.0}, {percept::Sensor::kRanges}};
    percept::Percepts out;
    const binding::Sensing sensing{body, &needs, &out};
    bodies_->percepts({&sensing, 1}, 0);
    return out;
  }
  static percept::Action ahead(double speed) {
    percept::Action out;
    out.drives = true;
    out.velocity = {speed, 0.0, 0.0};
    return out;
  }

  std::shared_ptr<Radio> radio_ = std::make_shared<Radio>();
  std::unique_ptr<Bodies> bodies_;
  std::uint64_t number_ = 0;
  std::uint64_t carried_out_ = 0;
  std::optional<double> battery_;
  std::vector<binding::Heard> heard_;
};

TEST_F(VehicleBodies, HaveARobotWhereTheVehicleSaysThatItIs) {
  EXPECT_EQ(embody(1, 10.0, 20.0).error(), "nothing is heard of its vehicle `veh-1`");
  say({{12.0, 21.0}, 0.5});
  const auto placed = embody(1, 10.0, 20.0);
  ASSERT_TRUE(placed) << placed.error();
  EXPECT_TRUE(placed->moved) << "it is not where the mission wants it";
  EXPECT_EQ(pose(placed->body), (geom::Pose{{12.0, 21.0}, 0.5})) << "on the obstacle of the map";
  EXPECT_EQ(bodies_->capabilities(placed->body).radius, 0.4);
  EXPECT_TRUE(bodies_->capabilities(placed->body).overlooks);
}

TEST_F(VehicleBodies, DriveAsFarAsTheVehicleSays) {
  say({{12.0, 21.0}, 0.0});
  const auto placed = embody(1, 10.0, 20.0);
  ASSERT_TRUE(placed) << placed.error();
  for (int i = 1; i <= 10; ++i) {
    say({{12.0 + 0.1 * i, 21.0}, 0.0});  // through the obstacle of the map, which is not there
    hear();
    carry_out({ahead(0.5)});
  }
  const binding::BodyState body = bodies_->view().body(placed->body);
  EXPECT_NEAR(body.distance_driven, 1.0, 1e-9);
  EXPECT_EQ(body.contacts, 0U);
  EXPECT_NEAR(body.velocity.x, 0.2, 1e-9) << "as it says";
}

TEST_F(VehicleBodies, KnowElsewhereWhatTheVehicleHasSeen) {
  say({{1.0, 0.0}, std::numbers::pi / 2.0}, false);
  const auto placed = embody(1, 10.0, 30.0);
  ASSERT_TRUE(placed) << placed.error();
  // Two metres to its left; it was put there with a heading of 0.
  const auto seen =
      bodies_->view().sense_at(placed->body, {{10.0, 31.0}, 0.0}, {{percept::Sensor::kObstacles, 20.0}});
  ASSERT_EQ(seen.obstacles.size(), 1U);
  EXPECT_NEAR(seen.obstacles[0].center.x, 0.0, 0.1);
  EXPECT_NEAR(seen.obstacles[0].center.y, 1.0, 0.1);
}

TEST_F(VehicleBodies, BeginAtTheMissionsPlaceWhereTheVehicleOnlyCountsItsWay) {
  say({{1.0, 0.0}, std::numbers::pi / 2.0}, false);
  const auto placed = embody(1, 10.0, 30.0);
  ASSERT_TRUE(placed);
  EXPECT_EQ(pose(placed->body), (geom::Pose{{10.0, 30.0}, 0.0}));
  say({{1.0, 2.0}, std::numbers::pi / 2.0}, false);  // 2 m ahead
  EXPECT_EQ(ailment(), "");
  EXPECT_NEAR(pose(placed->body).position.x, 12.0, 1e-9);
  EXPECT_NEAR(pose(placed->body).position.y, 30.0, 1e-9);
}

TEST_F(VehicleBodies, TellTheVehicleWhatItsRobotWantsAndWhatThatAnswers) {
  say({{50.0, 20.0}, 0.0});
  const auto placed = embody(1, 50.0, 20.0);
  ASSERT_TRUE(placed);
  carry_out({ahead(1.0)});
  ASSERT_EQ(radio_->told.size(), 1U);
  EXPECT_EQ(radio_->told[0].session(), kSession);
  EXPECT_EQ(radio_->told[0].answers(), number_);
  EXPECT_EQ(radio_->told[0].velocity_x(), 1.0);
  EXPECT_TRUE(radio_->told[0].drives());
  EXPECT_EQ(pose(placed->body).position.x, 50.0) << "it is where it says, not where it was sent";
  carry_out({percept::Action{}});
  EXPECT_FALSE(radio_->told[1].drives());
  bodies_->release(placed->body);
  EXPECT_TRUE(radio_->told.back().leaves());
}

TEST_F(VehicleBodies, SenseByWhatTheVehicleHas) {
  say({{10.0, 20.0}, 0.0});
  const auto placed = embody(1, 10.0, 20.0);
  ASSERT_TRUE(placed);
  const percept::Percepts seen = sense(placed->body);
  ASSERT_EQ(seen.obstacles.size(), 1U) << "what its scanner saw, not what the map says";
  EXPECT_NEAR(seen.obstacles[0].center.y, 2.0, 1e-6);
  ASSERT_EQ(seen.ranges.size(), 4U);
  EXPECT_TRUE(seen.ranges[1].hit);
  EXPECT_NEAR(seen.ranges[1].distance, 1.6, 1e-6) << "from its surface";
  EXPECT_TRUE(seen.objects.empty());
}

TEST_F(VehicleBodies, ArePerceivedByTheOthersWhereTheyAre) {
  say({{50.0, 20.0}, 0.0});
  ASSERT_TRUE(embody(1, 50.0, 20.0));
  const auto simulated = embody(2, 60.0, 20.0);
  ASSERT_TRUE(simulated);
  say({{55.0, 20.0}, 0.0});
  EXPECT_EQ(ailment(), "");
  const percept::Percepts seen = sense(simulated->body);
  ASSERT_EQ(seen.robots.size(), 1U);
  EXPECT_NEAR(geom::length(seen.robots[0].center), 5.0, 1e-9);
  // A body that is simulated keeps off one that is not.
  carry_out({percept::Action{}, ahead(-1.0)});  // it turns round, and goes ahead from then on
  for (int i = 0; i < 100; ++i) carry_out({percept::Action{}, ahead(1.0)});
  const double gap = geom::distance(pose(simulated->body).position, {55.0, 20.0});
  EXPECT_GE(gap, 0.6 - 1e-9);
  EXPECT_LT(gap, 0.7);
}

TEST_F(VehicleBodies, AreNotWellWhereNothingIsHeardAnyMore) {
  say({{50.0, 20.0}, 0.0});
  ASSERT_TRUE(embody(1, 50.0, 20.0));
  for (int i = 0; i < 49; ++i) carry_out({ahead(1.0)});
  EXPECT_EQ(ailment(), "");
  for (int i = 0; i < 5; ++i) carry_out({ahead(1.0)});
  EXPECT_EQ(ailment(), "is the vehicle `veh-1`, of which nothing was heard for 5 s");
}

TEST_F(VehicleBodies, AreNotWellWhereTheVehicleWouldNotMoveThoughItShould) {
  say({{50.0, 20.0}, 0.0});
  ASSERT_TRUE(embody(1, 50.0, 20.0));
  for (int i = 0; i < 105; ++i) {
    say({{50.0, 20.0}, 0.0}, true, Readiness::kNotReady);
    const std::string what = ailment();
    EXPECT_TRUE(i > 90 || what.empty()) << what;
    carry_out({ahead(1.0)});
  }
  EXPECT_EQ(ailment(), "is the vehicle `veh-1`, which is not ready");
}

TEST_F(VehicleBodies, SayWhenAnotherRunHasTheVehicle) {
  say({{50.0, 20.0}, 0.0});
  ASSERT_TRUE(embody(1, 50.0, 20.0));
  for (int i = 0; i < 105; ++i) {
    say({{50.0, 20.0}, 0.0}, true, Readiness::kReady, 8);
    ailment();
    carry_out({ahead(1.0)});
  }
  EXPECT_EQ(ailment(), "is the vehicle `veh-1`, which another run drives");
}

TEST_F(VehicleBodies, HaveOneRobotEach) {
  say({{50.0, 20.0}, 0.0});
  ASSERT_TRUE(embody(1, 50.0, 20.0));
  EXPECT_EQ(embody(3, 10.0, 20.0).error(), "another robot has the vehicle `veh-1`");
}

TEST_F(VehicleBodies, DoTheSameWhenTheSameIsTakenAgain) {
  say({{50.0, 20.0}, 0.0});
  const auto placed = embody(1, 50.0, 20.0);
  ASSERT_TRUE(placed);
  say({{50.5, 20.0}, 0.0});
  hear();
  carry_out({ahead(1.0)});
  const percept::Percepts then = sense(placed->body);
  const geom::Vector seen = then.obstacles[0].center;

  sim::World world;
  auto again =
      recorded_bodies(std::make_unique<sim::SimulatedBinding>(std::move(world)), bodies_->vehicles());
  again->take(heard_[0]);
  binding::BodySetup setup;
  setup.vehicle = "veh-1";
  const auto there = again->embody(setup);
  ASSERT_TRUE(there) << there.error();
  again->take(heard_[1]);
  const percept::Action action = ahead(1.0);
  again->carry_out({&action, 1}, 0.1);
  bodies_ = nullptr;
  const percept::Needs needs{{percept::Sensor::kObstacles, 20.0}};
  percept::Percepts now;
  const binding::Sensing sensing{there->body, &needs, &now};
  again->percepts({&sensing, 1}, 0);
  EXPECT_EQ(now.pose, then.pose);
  ASSERT_EQ(now.obstacles.size(), 1U);
  EXPECT_EQ(now.obstacles[0].center, seen);
  // What is recorded can be gone back to; what is there can't.
  const auto kept = again->save();
  ASSERT_TRUE(kept);
  for (int i = 0; i < 60; ++i) again->carry_out({&action, 1}, 0.1);
  std::vector<binding::Ailment> ailments;
  again->health(ailments);
  EXPECT_EQ(ailments.size(), 1U);
  ASSERT_TRUE(again->restore(**kept));
  ailments.clear();
  again->health(ailments);
  EXPECT_TRUE(ailments.empty());
}

TEST_F(VehicleBodies, AreToldToPeopleAsTheVehicleSaysThatItIs) {
  using State = binding::VehicleState;
  EXPECT_EQ(bodies_->vehicle("veh-2"), std::nullopt);
  const auto unheard = bodies_->vehicle("veh-1");
  ASSERT_TRUE(unheard);
  EXPECT_EQ(unheard->readiness, State::Readiness::kUnheard);
  EXPECT_EQ(unheard->kind, "MAVLink rover at udp:14550");
  battery_ = 0.42;
  say({{10.0, 20.0}, 0.0}, false, Readiness::kNotReady, 0);
  ASSERT_TRUE(embody(1, 10.0, 20.0));
  const auto waiting = bodies_->vehicle("veh-1");
  EXPECT_EQ(waiting->readiness, State::Readiness::kNotReady);
  EXPECT_EQ(waiting->why, "is not ready");
  EXPECT_EQ(waiting->driver, State::Driver::kNobody);
  EXPECT_FALSE(waiting->is_global);
  ASSERT_TRUE(waiting->battery);
  EXPECT_EQ(waiting->battery->share, 0.42);
  EXPECT_EQ(waiting->battery->voltage, 24.5);
  ASSERT_EQ(waiting->sensors.size(), 1U);
  EXPECT_EQ(waiting->sensors[0].beams, 4U);
  EXPECT_EQ(waiting->sensors[0].farthest, 10.0);

  // Nothing more is told of its battery, and a pilot takes it.
  battery_.reset();
  for (int i = 0; i < 4; ++i) carry_out({ahead(0.5)});
  say({{10.2, 20.0}, 0.0}, false, Readiness::kTaken);
  hear();
  carry_out({ahead(0.5)});
  const auto taken = bodies_->vehicle("veh-1");
  EXPECT_EQ(taken->driver, State::Driver::kThisRun);
  EXPECT_EQ(taken->readiness, State::Readiness::kTaken);
  EXPECT_NEAR(taken->age, 0.1, 1e-9);
  ASSERT_TRUE(taken->battery) << "it has not become unknown what it said";
  EXPECT_NEAR(taken->battery->age, 0.5, 1e-9);
}

TEST_F(VehicleBodies, KnowHowLongACommandTakesToTheVehicleAndBack) {
  say({{10.0, 20.0}, 0.0});
  ASSERT_TRUE(embody(1, 10.0, 20.0));
  EXPECT_EQ(bodies_->vehicle("veh-1")->trip, std::nullopt);
  for (int i = 0; i < 5; ++i) carry_out({ahead(0.5)});  // the commands 1 to 5
  carried_out_ = 3;
  say({{10.0, 20.0}, 0.0});
  hear();
  ASSERT_TRUE(bodies_->vehicle("veh-1")->trip);
  EXPECT_NEAR(*bodies_->vehicle("veh-1")->trip, 0.3, 1e-9);
  carried_out_ = 99;  // that was never sent
  say({{10.0, 20.0}, 0.0});
  hear();
  EXPECT_EQ(bodies_->vehicle("veh-1")->trip, std::nullopt);
}

TEST_F(VehicleBodies, SayWhatFailsafesLookAt) {
  say({{10.0, 20.0}, 0.0});
  const auto vehicle = embody(1, 10.0, 20.0);
  const auto other = embody(2, 30.0, 20.0);
  ASSERT_TRUE(vehicle && other);
  EXPECT_FALSE(bodies_->view().body(other->body).upkeep) << "it is made up";
  for (int i = 0; i < 20; ++i) carry_out({ahead(0.5), {}});
  auto upkeep = bodies_->view().body(vehicle->body).upkeep;
  ASSERT_TRUE(upkeep);
  EXPECT_NEAR(upkeep->motion_age, 2.0, 1e-9);
  EXPECT_EQ(upkeep->battery, std::nullopt);
  EXPECT_NEAR(upkeep->battery_age, 2.0, 1e-9) << "for so long it could have told";
  battery_ = 0.7;
  say({{10.0, 20.0}, 0.0});
  hear();
  carry_out({ahead(0.5), {}});
  upkeep = bodies_->view().body(vehicle->body).upkeep;
  EXPECT_EQ(upkeep->battery, 0.7);
  EXPECT_NEAR(upkeep->battery_age, 0.1, 1e-9);
  EXPECT_NEAR(upkeep->motion_age, 0.1, 1e-9);
}

TEST_F(VehicleBodies, RefuseARobotAVehicleWhoseLimitsCanNotBe) {
  const std::string is = "says limits that can't be: its radius is -1, expected 0 to 100";
  crew("its radius is -1, expected 0 to 100");
  say({{10.0, 20.0}, 0.0});
  EXPECT_EQ(embody(1, 10.0, 20.0).error(), "its vehicle `veh-1` " + is);
  EXPECT_EQ(bodies_->vehicle("veh-1")->readiness, binding::VehicleState::Readiness::kFaulty);
  EXPECT_EQ(bodies_->vehicle("veh-1")->why, is);
  // Its recording tells the same; `said` of it can't be read.
  const auto again =
      recorded_bodies(std::make_unique<sim::SimulatedBinding>(sim::World{}), bodies_->vehicles());
  binding::BodySetup setup;
  setup.vehicle = "veh-1";
  EXPECT_EQ(again->embody(setup).error(), "its vehicle `veh-1` " + is);
  EXPECT_EQ(recorded_names(bodies_->vehicles()).count("veh-1"), 1U);
}

TEST_F(VehicleBodies, ThatAreThereCanNotBePutBack) {
  EXPECT_FALSE(bodies_->save());
}

}  // namespace
}  // namespace mlab::vehicle
