// Robots whose bodies are vehicles of a fleet: processes of their own, on other machines, in real time.

#include <csignal>

#include "fleets.h"

namespace mlab::testing {
namespace {

using network::Process;

const std::string& yard() {
  static const std::string kFolder = base::source_folder() + "/tests/fleets/vehicles/";
  return kFolder;
}

class Vehicles : public Fleets {
 protected:
  Process vehicle(const std::string& host, const std::string& name, const std::string& at) {
    Process out = net().host(host).start(
        {MLAB_COMMAND, "robot", "--binding", "simulated", "--fleet", "alpha", "--name", name, "--at", at,
         "--world", yard() + "yard.odl", "--network", net().host(host).address()},
        {.environment = {{"XDG_STATE_HOME", kAgentState}}});
    EXPECT_TRUE(out.prints("waits for a run to drive it", kFleetPatience)) << out.output() << out.errors();
    return out;
  }
  Process cross(const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"--real-time"};
    words.insert(words.end(), more.begin(), more.end());
    return run(yard() + "vehicles.mdl", words);
  }
  Json ends(Process& far, const std::string& status) {
    const auto ending = far.wait(2 * kFleetPatience);
    EXPECT_TRUE(ending) << far.output() << far.errors();
    EXPECT_EQ(ending ? ending->words() : "", status) << far.output() << far.errors();
    return report();
  }
};

TEST_F(Vehicles, TakePartInAMissionBesideSimulatedRobotsAndAreRecorded) {
  make_network(71);
  const Process first = vehicle("north", "veh-1", "8,12,0");
  const Process second = vehicle("south", "veh-2", "8,18,0");
  const Process agent = this->agent("north");
  net().set({.loss = 0.1, .delay = 20ms});
  Process far = cross({"--record", "/tmp/vehicles.mcap"});
  const Json told = ends(far, "exit status 0");
  ASSERT_TRUE(told.is_object());
  EXPECT_EQ(told["outcome"], "done");
  for (const Json& robot : told["robots"]) EXPECT_GT(robot["distance_m"].get<double>(), 3.0) << robot;
  EXPECT_NE(first.output().find("a run drives it"), std::string::npos) << first.output();
  EXPECT_TRUE(first.prints("no run drives it any more", kFleetPatience)) << first.output();

  Process again = base().start({MLAB_COMMAND, "replay", "/tmp/vehicles.mcap", "--headless"});
  const auto ending = again.wait(kFleetPatience);
  ASSERT_TRUE(ending) << again.output();
  EXPECT_EQ(ending->words(), "exit status 0") << again.output() << again.errors();
}

TEST_F(Vehicles, StandWhenWhoDrivesThemIsKilled) {
  make_network(72);
  const Process first = vehicle("north", "veh-1", "8,12,0");
  const Process second = vehicle("south", "veh-2", "8,18,0");
  const Process agent = this->agent("north");
  Process far = cross();
  ASSERT_TRUE(first.prints("a run drives it", kFleetPatience)) << far.output();
  ASSERT_TRUE(second.prints("a run drives it", kFleetPatience)) << far.output();
  far.signal(SIGKILL);
  EXPECT_TRUE(first.prints("it stands: what its run tells it is too old", kFleetPatience)) << first.output();
  EXPECT_TRUE(second.prints("no run drives it any more", kFleetPatience)) << second.output();
}

TEST_F(Vehicles, ThatAreKilledAreLostAndSaidToBe) {
  make_network(73);
  Process first = vehicle("north", "veh-1", "8,12,0");
  const Process second = vehicle("south", "veh-2", "8,18,0");
  const Process agent = this->agent("north");
  Process far = cross();
  ASSERT_TRUE(first.prints("a run drives it", kFleetPatience)) << far.output();
  first.signal(SIGKILL);
  EXPECT_TRUE(
      far.prints("its body is the vehicle `veh-1`, of which nothing was heard for 5 s", kFleetPatience))
      << far.output();
  far.signal(SIGTERM);
  EXPECT_TRUE(far.wait(kFleetPatience));
}

TEST_F(Vehicles, ObeyTheEmergencyStop) {
  make_network(74);
  const Process first = vehicle("north", "veh-1", "8,12,0");
  const Process second = vehicle("south", "veh-2", "8,18,0");
  const Process agent = this->agent("north");
  Process far = cross();
  ASSERT_TRUE(first.prints("a run drives it", kFleetPatience)) << far.output();
  Process stop = base().start({MLAB_COMMAND, "fleet", "alpha", "--network", base().address(), "--stop"});
  ASSERT_TRUE(stop.wait(kFleetPatience));
  EXPECT_TRUE(first.prints("EMERGENCY STOP by base: all robots here stand", kFleetPatience))
      << first.output();
  EXPECT_TRUE(first.prints("it stands: the emergency stop holds", kFleetPatience)) << first.output();
  Process release =
      base().start({MLAB_COMMAND, "fleet", "alpha", "--network", base().address(), "--release"});
  ASSERT_TRUE(release.wait(kFleetPatience));
  EXPECT_TRUE(first.prints("the emergency stop was released by base", kFleetPatience)) << first.output();
  EXPECT_FALSE(far.wait(1s)) << "the mission goes on: " << far.output();
  far.signal(SIGTERM);
  EXPECT_TRUE(far.wait(kFleetPatience));
}

TEST_F(Vehicles, AreAskedForByName) {
  make_network(75);
  const Process first = vehicle("north", "veh-1", "8,12,0");
  const Process agent = this->agent("north");
  Process far = cross();
  EXPECT_TRUE(far.prints("none of the name `veh-2`", kFleetPatience)) << far.output() << far.errors();
  far.signal(SIGTERM);
  EXPECT_TRUE(far.wait(kFleetPatience));
}

}  // namespace
}  // namespace mlab::testing
