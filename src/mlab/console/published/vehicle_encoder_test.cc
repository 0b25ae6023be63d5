#include "mlab/console/published/vehicle_encoder.h"

#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/console/run/vehicle_silence.h"
#include "mlab/console/testing/browser.h"
#include "mlab/history/history_writer.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/simulated/run.h"
#include "mlab/vehicle/bodies.h"
#include "mlab/vehicle/server.h"

namespace mlab::console {
namespace {

using vehicle::Clock;
using vehicle::Readiness;

/// Goes as fast as it is told, at once; its time is that of the test.
class Rover final : public vehicle::Device {
 public:
  Rover() {
    limits_.kinematics.drive = binding::Drive::kDifferential;
    limits_.kinematics.max_speed = 1.0;
    told.readiness = Readiness::kReady;
    told.is_global = true;
    told.motion = vehicle::Motion{{{20.0, 30.0}, 0.0}, 0.0, 0.0, {}};
  }
  const std::string& name() const override { return name_; }
  const vehicle::Limits& limits() const override { return limits_; }
  void work(Clock::time_point now) override {
    told.motion->pose.position.x += told.motion->speed * vehicle::seconds_between(last_, now);
    told.motion->at = last_ = now;
  }
  const vehicle::Report& report(Clock::time_point /*now*/) override { return told; }
  void drive(const vehicle::Command& command, Clock::time_point /*now*/) override {
    told.motion->speed = command.speed;
  }
  void stop(Clock::time_point /*now*/) override { told.motion->speed = 0.0; }

  vehicle::Report told;

 private:
  std::string name_ = "rover";
  vehicle::Limits limits_;
  Clock::time_point last_;
};

/// A vehicle and its process, a tenth of a second older with each look.
struct Vehicle {
  Rover rover;
  bool is_stopped = false;
  bool is_mute = false;
  Clock::time_point now;
  vehicle::Server server{rover, [this] { return is_stopped; }};
};

class Way final : public vehicle::Line {
 public:
  explicit Way(std::shared_ptr<Vehicle> vehicle) : vehicle_(std::move(vehicle)) {}
  std::optional<std::string> hear() override {
    vehicle_->now += std::chrono::milliseconds(100);
    vehicle_->server.work(vehicle_->now);
    if (vehicle_->is_mute) return std::nullopt;
    return vehicle_->server.report(vehicle_->now);
  }
  void tell(const wire::VehicleCommand& command) override {
    vehicle_->server.hear("run", command.SerializeAsString(), vehicle_->now);
  }

 private:
  std::shared_ptr<Vehicle> vehicle_;
};

class Vehicles : public ::testing::Test {
 protected:
  void make(const std::string& preamble = "") {
    const std::string text = preamble +
                             "MISSION-AREA 200 100\n"
                             "UNIT <a> ROBOT\n"
                             "UNIT <b> rover\n"
                             "COMMAND LIST:\n"
                             "0. UNIT b START 20 30\n"
                             "1. UNIT b MOVETO 90 30\n";
    text::Diagnostics sink;
    const auto source = std::make_shared<const text::Source>(
        "test.mdl", "NEW-ROBOT rover \"robot\" green \"veh-1\" (max_velocity = 1)\n" + text);
    const auto mission = mdl::check_mission(source, "", sink);
    ASSERT_NE(mission, nullptr) << text::render(sink);
    run::RunSettings settings;
    settings.vehicles = [this](const mission::Mission& /*any*/, std::unique_ptr<binding::Binding> simulated) {
      std::vector<vehicle::Crewed> crewed;
      crewed.push_back(
          {"veh-1", vehicle_->rover.limits(), std::make_unique<Way>(vehicle_), "a rover at ttyS1", refusal_});
      return std::make_unique<vehicle::Bodies>(std::move(simulated), std::move(crewed), 7);
    };
    robot::ProgramSources sources;
    sources.is_vehicle = [](const std::string& host) { return host == "veh-1"; };
    run_ = simulated::make_run(mission, sources, settings, sink);
    ASSERT_NE(run_, nullptr) << text::render(sink);
  }
  void execute() { run_->post(mission::event::Execute{}); }
  void pass(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(seconds * 10.0)); ++i) run_->step();
  }
  Status told() const {
    Status out;
    encode_vehicles(*run_, out);
    return out;
  }

  std::shared_ptr<Vehicle> vehicle_ = std::make_shared<Vehicle>();
  std::string refusal_;  // as vehicle::Crewed::refusal
  std::unique_ptr<run::MissionRun> run_;
};

TEST_F(Vehicles, AreToldBeforeTheirRobotsAreStarted) {
  vehicle_->rover.told.readiness = Readiness::kNotReady;
  vehicle_->rover.told.why = "is not armed";
  vehicle_->rover.told.battery = vehicle::Battery{0.5, 24.1, {}};
  make();
  EXPECT_EQ(told().vehicles(0).readiness(), Status::Vehicle::UNHEARD);
  run_->hear_bodies();
  const Status status = told();
  ASSERT_EQ(status.vehicles_size(), 1);
  const Status::Vehicle& one = status.vehicles(0);
  EXPECT_EQ(one.robot(), 2U);
  EXPECT_EQ(one.name(), "veh-1");
  EXPECT_EQ(one.kind(), "a rover at ttyS1");
  EXPECT_EQ(one.readiness(), Status::Vehicle::NOT_READY);
  EXPECT_EQ(one.why(), "is not armed");
  EXPECT_EQ(one.driver(), Status::Vehicle::NOBODY);
  EXPECT_TRUE(one.is_global());
  EXPECT_EQ(one.battery().share(), 0.5);
  EXPECT_EQ(one.battery().voltage(), 24.1);
}

TEST_F(Vehicles, AreToldWithTheirLinkWhileTheyAreDriven) {
  make();
  execute();
  pass(3.0);
  const Status::Vehicle driven = told().vehicles(0);
  EXPECT_EQ(driven.readiness(), Status::Vehicle::IS_READY);
  EXPECT_EQ(driven.driver(), Status::Vehicle::THIS_RUN);
  EXPECT_TRUE(driven.has_trip());
  EXPECT_LE(driven.trip(), 0.2 + 1e-9);
  EXPECT_LE(driven.age(), 0.1 + 1e-9);
  vehicle_->is_mute = true;
  pass(2.0);
  EXPECT_NEAR(told().vehicles(0).age(), driven.age() + 2.0, 1e-6);
}

TEST_F(Vehicles, ThatAPilotTakesAreToldSo) {
  make();
  execute();
  pass(2.0);
  vehicle_->rover.told.readiness = Readiness::kTaken;
  vehicle_->rover.told.why = "is in another mode: MANUAL";
  pass(0.5);
  EXPECT_EQ(told().vehicles(0).readiness(), Status::Vehicle::TAKEN);
  EXPECT_EQ(told().vehicles(0).why(), "is in another mode: MANUAL");
}

TEST_F(Vehicles, WhoseLimitsCanNotBeAreToldByTheRun) {
  refusal_ = "its radius is -1, expected 0 to 100";
  make();
  std::vector<std::string> warnings;
  run_->set_observer([&](const mission::Effect& effect) {
    const auto* told = std::get_if<mission::effect::Tell>(&effect);
    if (told != nullptr && told->kind == mission::effect::Tell::Kind::kWarning)
      warnings.push_back(told->text);
  });
  execute();
  pass(1.0);
  ASSERT_FALSE(warnings.empty());
  EXPECT_EQ(warnings.front(),
            "robot 2 can't start: its vehicle `veh-1` says limits that can't be: its "
            "radius is -1, expected 0 to 100");
  EXPECT_EQ(told().vehicles(0).readiness(), Status::Vehicle::FAULTY);
  EXPECT_EQ(told().vehicles(0).why(), "says limits that can't be: its radius is -1, expected 0 to 100");
}

TEST_F(Vehicles, ThatNobodyKnowsOfAreToldSo) {
  make();
  execute();
  pass(1.0);
  // Another mission's run, whose vehicle is not there: it has bodies of its own alone.
  text::Diagnostics sink;
  const auto source = std::make_shared<const text::Source>(
      "other.mdl", "NEW-ROBOT rover \"robot\" green \"veh-9\"\nUNIT <b> rover\nCOMMAND LIST:\n0. QUIT\n");
  robot::ProgramSources sources;
  sources.is_vehicle = [](const std::string&) { return true; };
  const auto other = simulated::make_run(mdl::check_mission(source, "", sink), sources, {}, sink);
  Status status;
  encode_vehicles(*other, status);
  ASSERT_EQ(status.vehicles_size(), 1);
  EXPECT_EQ(status.vehicles(0).readiness(), Status::Vehicle::UNHEARD);
  EXPECT_EQ(status.vehicles(0).why(), "is not in the fleet");
}

TEST_F(Vehicles, GrowOldByTheWallClockWhileTheRunStands) {
  make();
  VehicleSilence silence;
  const auto age = [&](double wall) {
    EXPECT_TRUE(silence.look(*run_, wall));
    Status status = told();
    silence.add(wall, status);
    return status.vehicles(0).age();
  };
  const auto heard = [&] { return run_->vehicle("veh-1")->number; };
  EXPECT_EQ(age(100.0), 0.0);
  const std::uint64_t before = heard();
  EXPECT_EQ(age(100.5), 0.0);
  EXPECT_EQ(heard(), before) << "not due";
  EXPECT_EQ(age(101.0), 0.0);
  EXPECT_EQ(heard(), before + 1);
  vehicle_->is_mute = true;
  EXPECT_EQ(age(102.9), 0.0) << "it is not late yet";
  EXPECT_NEAR(age(105.0), 4.0, 1e-9);
  vehicle_->is_mute = false;
  EXPECT_EQ(age(105.5), 0.0);
}

TEST_F(Vehicles, AreShownAsTheyWereByARecording) {
  make();
  const auto history = std::make_shared<history::History>();
  history::HistoryWriter writer(
      [&](const wire::HistoryEntry& entry) { EXPECT_EQ(history->add(entry), std::nullopt); });
  run_->set_observer([&](const mission::Effect& effect) { writer.see(effect); });
  writer.begin(*run_, {"test", {}, 0, 0.0});
  writer.note_cycle();
  execute();
  vehicle_->rover.told.battery = vehicle::Battery{0.64, 24.6, {}};
  std::vector<std::string> were = {""};  // by cycle
  for (int cycle = 1; cycle <= 40; ++cycle) {
    if (cycle == 20) vehicle_->rover.told.readiness = Readiness::kTaken;
    if (cycle == 20) vehicle_->rover.told.why = "is in mode MANUAL: a pilot steers it";
    if (cycle == 30) vehicle_->is_mute = true;
    run_->step();
    writer.note_cycle();
    were.push_back(told().vehicles(0).DebugString());
  }
  writer.end("interrupted");

  testing::TestSession session("", 1.0, [&](SessionSettings& s) { s.recording = {"rover", history}; });
  testing::Browser anna(session, "Anna");
  for (const std::uint64_t cycle : {10, 25, 40, 15}) {
    ToServer look;
    look.mutable_look_back()->set_time(static_cast<double>(cycle) * 0.1);
    ASSERT_EQ(testing::Browser::error_of(anna.ask(look)), "");
    ASSERT_TRUE(anna.wait([&] { return !anna.moment().is_coming() && anna.status().cycle() == cycle; }));
    ASSERT_EQ(anna.status().vehicles_size(), 1);
    EXPECT_EQ(anna.status().vehicles(0).DebugString(), were[cycle]) << cycle;
  }
  EXPECT_NE(were[10].find("readiness: IS_READY"), std::string::npos) << were[10];
  EXPECT_NE(were[25].find("readiness: TAKEN"), std::string::npos) << were[25];
}

TEST_F(Vehicles, WithoutABatteryAreHeldByARowThatLooksAtBatteries) {
  make("FAILSAFE BATTERY BELOW 30% AFTER 1 HOLD\n");
  vehicle_->rover.told.battery = vehicle::Battery{0.31, 0.0, {}};
  const auto acts = [&] {
    const fleet::FleetRobot* robot = run_->fleet().find({2});
    return robot != nullptr && !run_->fleet().failsafe(*robot).empty();
  };
  execute();
  for (int i = 0; i < 30; ++i) {
    vehicle_->rover.told.battery->at = vehicle_->now;
    pass(0.1);
  }
  EXPECT_FALSE(acts());
  EXPECT_GT(vehicle_->rover.told.motion->speed, 0.0);
  vehicle_->rover.told.battery->share = 0.29;
  for (int i = 0; i < 12; ++i) {
    vehicle_->rover.told.battery->at = vehicle_->now;
    pass(0.1);
  }
  EXPECT_TRUE(acts());
  EXPECT_EQ(vehicle_->rover.told.motion->speed, 0.0);
  vehicle_->rover.told.battery = vehicle::Battery{0.9, 0.0, vehicle_->now};
  pass(0.5);
  EXPECT_FALSE(acts());
  vehicle_->rover.told.battery.reset();
  pass(9.0);
  EXPECT_FALSE(acts()) << "it may not have been due to tell";
  pass(3.0);
  EXPECT_TRUE(acts()) << "nobody knows of it any more";
}

}  // namespace
}  // namespace mlab::console
