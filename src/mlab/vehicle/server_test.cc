#include "mlab/vehicle/server.h"

#include <chrono>
#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace mlab::vehicle {
namespace {

using std::chrono::milliseconds;

/// Does what it is told, at once.
class Told final : public Device {
 public:
  Told() {
    limits_.kinematics.drive = binding::Drive::kDifferential;
    limits_.kinematics.max_speed = 2.0;
    report_.readiness = Readiness::kReady;
  }
  const std::string& name() const override { return name_; }
  const Limits& limits() const override { return limits_; }
  void work(Clock::time_point /*now*/) override {}
  const Report& report(Clock::time_point /*now*/) override { return report_; }
  void drive(const Command& command, Clock::time_point /*now*/) override { command_ = command; }
  void stop(Clock::time_point /*now*/) override {
    if (report_.readiness != Readiness::kTaken) command_ = {};
  }
  void stop_in_emergency(Clock::time_point /*now*/) override { command_ = {}; }
  void engage(Clock::time_point /*now*/) override { ++engaged_; }

  Report report_;
  Command command_;
  int engaged_ = 0;

 private:
  std::string name_ = "told";
  Limits limits_;
};

class ServerTest : public testing::Test {
 protected:
  std::uint64_t report() {
    wire::VehicleReport out;
    EXPECT_TRUE(out.ParseFromString(server_.report(now_)));
    held_by_ = out.held_by();
    told_ = static_cast<Readiness>(out.readiness());
    return out.number();
  }
  wire::VehicleCommand command(std::uint64_t answers, double speed = 1.0) {
    wire::VehicleCommand out;
    out.set_session(7);
    out.set_number(++number_);
    out.set_answers(answers);
    out.set_drives(true);
    out.set_velocity_x(speed);
    out.set_period(0.1);
    return out;
  }
  void hear(const wire::VehicleCommand& command, const std::string& sender = "run") {
    server_.hear(sender, command.SerializeAsString(), now_);
  }
  double speed_after(milliseconds later) {
    now_ += later;
    server_.work(now_);
    return device_.command_.speed;
  }

  Told device_;
  bool is_stopped_ = false;
  Server server_{device_, [this] { return is_stopped_; }};
  Clock::time_point now_{std::chrono::seconds(100)};
  std::uint64_t number_ = 0;
  std::uint64_t held_by_ = 0;
  Readiness told_ = Readiness::kAbsent;
};

TEST_F(ServerTest, DrivesByLiveCommandsAndStandsWhenTheyAreOver) {
  EXPECT_EQ(speed_after(milliseconds(0)), 0.0);
  hear(command(report()));
  EXPECT_EQ(speed_after(milliseconds(20)), 1.0);
  EXPECT_EQ(speed_after(milliseconds(400)), 1.0);
  EXPECT_EQ(speed_after(milliseconds(100)), 0.0) << "nothing has come for half a second";
}

TEST_F(ServerTest, CarriesNothingOutThatAnswersWhatIsLongPast) {
  const std::uint64_t old = report();
  now_ += milliseconds(600);
  hear(command(old));
  EXPECT_EQ(speed_after(milliseconds(1)), 0.0) << "it was on its way for too long";
  hear(command(1'000'000));
  EXPECT_EQ(speed_after(milliseconds(1)), 0.0) << "there was no such report";
}

TEST_F(ServerTest, CarriesNothingOutThatAnsweredTheProcessBefore) {
  const std::uint64_t of_before = report();
  for (const int ahead : {-1, 1, 40}) {
    Server anew(device_, [] { return false; });
    now_ += milliseconds(500);
    wire::VehicleReport first;
    ASSERT_TRUE(first.ParseFromString(anew.report(now_)));
    EXPECT_GT(first.number(), of_before + 40);
    // It answers what will be said only later, or what the other process said.
    const std::uint64_t answers = ahead < 0 ? of_before : first.number() + static_cast<std::uint64_t>(ahead);
    anew.hear("run", command(answers).SerializeAsString(), now_);
    for (int i = 0; i < 60; ++i) {
      now_ += milliseconds(50);
      anew.report(now_);
      anew.work(now_);
      EXPECT_EQ(device_.command_.speed, 0.0);
    }
  }
}

TEST_F(ServerTest, TakesNoOlderCommandForANewerOne) {
  const std::uint64_t answers = report();
  const wire::VehicleCommand first = command(answers, 0.5);
  const wire::VehicleCommand second = command(answers, 1.0);
  hear(second);
  hear(first);
  EXPECT_EQ(speed_after(milliseconds(1)), 1.0);
}

TEST_F(ServerTest, StandsUnderTheEmergencyStopWhateverItIsTold) {
  hear(command(report()));
  EXPECT_EQ(speed_after(milliseconds(1)), 1.0);
  is_stopped_ = true;
  EXPECT_EQ(speed_after(milliseconds(1)), 0.0);
  hear(command(report()));
  EXPECT_EQ(speed_after(milliseconds(1)), 0.0);
}

TEST_F(ServerTest, IsDrivenByOneRunAtATime) {
  hear(command(report()));
  wire::VehicleCommand other = command(report(), 2.0);
  other.set_session(8);
  hear(other, "other");
  EXPECT_EQ(speed_after(milliseconds(1)), 1.0);
  report();
  EXPECT_EQ(held_by_, 7U);
  // Somebody else may not speak for it either.
  wire::VehicleCommand forged = command(report(), 2.0);
  hear(forged, "other");
  EXPECT_EQ(speed_after(milliseconds(1)), 1.0);
  // Who is silent has lost it.
  now_ += milliseconds(2100);
  other.set_answers(report());
  hear(other, "other");
  EXPECT_EQ(speed_after(milliseconds(1)), 2.0);
}

TEST_F(ServerTest, IsFreeAtOnceWhenItsRunLeaves) {
  hear(command(report()));
  wire::VehicleCommand leave = command(report());
  leave.set_leaves(true);
  hear(leave);
  EXPECT_FALSE(server_.is_driven());
  EXPECT_EQ(speed_after(milliseconds(1)), 0.0);
  EXPECT_EQ(server_.standing(), "no run drives it");
}

TEST_F(ServerTest, LeavesAVehicleAloneThatNoRunDrives) {
  device_.command_ = {0.7, 0.0};  // by somebody else
  EXPECT_EQ(speed_after(milliseconds(20)), 0.7);
  hear(command(report()));
  EXPECT_EQ(speed_after(milliseconds(20)), 1.0);
  EXPECT_EQ(speed_after(milliseconds(3000)), 0.0) << "its run is silent";
  device_.command_ = {0.7, 0.0};
  EXPECT_EQ(speed_after(milliseconds(20)), 0.0) << "it is seen to that it stands";
  now_ += milliseconds(5000);
  device_.command_ = {0.7, 0.0};
  EXPECT_EQ(speed_after(milliseconds(20)), 0.7);
  is_stopped_ = true;
  EXPECT_EQ(speed_after(milliseconds(20)), 0.0);
}

TEST_F(ServerTest, IsFreeWhenItsRunIsGone) {
  hear(command(report()));
  server_.lose("another");
  EXPECT_TRUE(server_.is_driven());
  server_.lose("run");
  EXPECT_EQ(speed_after(milliseconds(1)), 0.0);
}

TEST_F(ServerTest, IsNotMadeReadyByARobotThatStands) {
  device_.report_.readiness = Readiness::kNotReady;
  device_.command_ = {9.0, 0.0};  // whatever was before
  wire::VehicleCommand stands = command(report());
  stands.set_drives(false);
  hear(stands);
  EXPECT_EQ(speed_after(milliseconds(1)), 0.0);
  EXPECT_EQ(server_.standing(), "its robot does not drive");
}

TEST_F(ServerTest, LeavesAVehicleToWhoTookIt) {
  const auto go = [&] {
    hear(command(report()));
    return speed_after(milliseconds(20));
  };
  EXPECT_EQ(go(), 1.0);
  device_.report_.readiness = Readiness::kTaken;  // a pilot has changed its mode
  device_.command_ = {0.3, 0.0};                  // and drives
  EXPECT_EQ(go(), 0.3);
  EXPECT_EQ(server_.standing(), "somebody else has taken it");
  EXPECT_EQ(speed_after(milliseconds(700)), 0.3) << "it is not stopped either";
  is_stopped_ = true;
  EXPECT_EQ(go(), 0.0) << "but by the emergency stop";
  is_stopped_ = false;
  device_.command_ = {0.3, 0.0};
  EXPECT_EQ(go(), 0.3);
  // The link is gone for a while, and back: that is nobody's word.
  now_ += milliseconds(3000);
  server_.work(now_);
  EXPECT_FALSE(server_.is_driven());
  EXPECT_EQ(go(), 0.3);
  // Nor is it that he has let go of it.
  device_.report_.readiness = Readiness::kReady;
  EXPECT_EQ(go(), 0.3);
  report();
  EXPECT_EQ(told_, Readiness::kTaken) << "it would not do what its robot wants";
  // A person has the robot take it again.
  const int before = device_.engaged_;
  wire::VehicleCommand anew = command(report());
  anew.set_engagement(1);
  hear(anew);
  EXPECT_EQ(speed_after(milliseconds(20)), 1.0);
  EXPECT_EQ(device_.engaged_, before + 1);
}

TEST_F(ServerTest, WaitsForWhoHadTheVehicleBefore) {
  device_.report_.readiness = Readiness::kTaken;
  device_.command_ = {0.3, 0.0};
  hear(command(report()));
  EXPECT_EQ(speed_after(milliseconds(20)), 0.3);
  EXPECT_EQ(speed_after(milliseconds(600)), 0.3) << "a routine stop does not take it from him";
  device_.report_.readiness = Readiness::kStandby;
  hear(command(report()));
  EXPECT_EQ(speed_after(milliseconds(20)), 1.0) << "it was not taken from its robot";
}

// Whether somebody has made it unready, or a stop of this, its device knows.
TEST_F(ServerTest, MakesAVehicleReadyAgainOfWhichItsDeviceSaysThatNobodyHasTakenIt) {
  hear(command(report()));
  EXPECT_EQ(speed_after(milliseconds(20)), 1.0);
  EXPECT_EQ(speed_after(milliseconds(600)), 0.0) << "nothing has come for half a second";
  for (int i = 0; i < 40; ++i) {
    device_.report_.readiness = i < 20 ? Readiness::kStandby : Readiness::kReady;
    hear(command(report()));
    EXPECT_EQ(speed_after(milliseconds(100)), 1.0);
  }
}

TEST_F(ServerTest, LeavesAVehicleToWhoTookItRightAfterItWasToldToStop) {
  hear(command(report()));
  EXPECT_EQ(speed_after(milliseconds(20)), 1.0);
  EXPECT_EQ(speed_after(milliseconds(600)), 0.0) << "nothing has come for half a second";
  hear(command(report()));
  EXPECT_EQ(speed_after(milliseconds(20)), 1.0);
  device_.report_.readiness = Readiness::kTaken;  // somebody has put it into another mode
  device_.command_ = {};
  hear(command(report()));
  EXPECT_EQ(speed_after(milliseconds(20)), 0.0);
  EXPECT_EQ(server_.standing(), "somebody else has taken it");
  device_.report_.readiness = Readiness::kStandby;
  hear(command(report()));
  EXPECT_EQ(speed_after(milliseconds(20)), 0.0) << "who has let go of it has not given it back";
}

TEST_F(ServerTest, GoesOnWithAVehicleThatHadTroubleOfItsOwn) {
  hear(command(report()));
  EXPECT_EQ(speed_after(milliseconds(20)), 1.0);
  device_.report_.readiness = Readiness::kNotReady;  // it does not know where it is, for a moment
  EXPECT_EQ(speed_after(milliseconds(20)), 1.0);
  device_.report_.readiness = Readiness::kReady;
  hear(command(report(), 0.5));
  EXPECT_EQ(speed_after(milliseconds(20)), 0.5);
}

TEST_F(ServerTest, GoesOnWithAVehicleThatWasSilent) {
  const auto go = [&](Readiness readiness) {
    device_.report_.readiness = readiness;
    hear(command(report()));
    return speed_after(milliseconds(20));
  };
  EXPECT_EQ(go(Readiness::kReady), 1.0);
  go(Readiness::kSilent);
  EXPECT_EQ(go(Readiness::kNotReady), 1.0) << "it is driven, which may make it ready";
}

TEST_F(ServerTest, ReadsNothingOutOfNonsense) {
  server_.hear("run", "no message", now_);
  wire::VehicleCommand command = this->command(report());
  command.set_velocity_x(std::numeric_limits<double>::quiet_NaN());
  hear(command);
  EXPECT_FALSE(server_.is_driven());
}

}  // namespace
}  // namespace mlab::vehicle
