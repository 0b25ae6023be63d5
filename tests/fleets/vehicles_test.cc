// Robots whose bodies are vehicles of a fleet: processes of their own, on other machines, in real time.

#include <chrono>
#include <csignal>
#include <cstdio>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>

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

/// With a vehicle that is not simulated, as far as anybody can tell: a model behind a serial line.
class CheckedVehicles : public Vehicles {
 protected:
  Process model(const std::string& host) {
    Process out = net().host(host).start({MLAB_TEXT_ROVER_MODEL, "--link", "/tmp/rover"});
    EXPECT_TRUE(out.prints("line:", kFleetPatience)) << out.errors();
    return out;
  }
  Process rover(const std::string& host, const std::string& name) {
    Process out = net().host(host).start(
        {MLAB_COMMAND, "robot", "--binding", "text-rover", "--fleet", "alpha", "--name", name, "--device",
         "serial:/tmp/rover:57600", "--network", net().host(host).address()},
        {.environment = {{"XDG_STATE_HOME", kAgentState}}});
    EXPECT_TRUE(out.prints("the vehicle is ready", kFleetPatience)) << out.output() << out.errors();
    return out;
  }
  Process operate(std::vector<std::string> words) {
    words.insert(words.begin(), MLAB_COMMAND);
    words.insert(words.end(), {"--fleet", "alpha", "--network", base().address()});
    return base().start(words, {.environment = {{"XDG_STATE_HOME", kAgentState}}});
  }
  Process preflight(std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"preflight", yard() + "rover.mdl"});
    return operate(std::move(more));
  }
  Process start(std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"run", yard() + "rover.mdl", "--headless", "--proceed", "--robots", "fleet",
                               "--real-time", "--threads", "1"});
    return operate(std::move(more));
  }
  void ends_with(Process far, const std::string& status, const std::string& errors) {
    const auto ending = far.wait(kFleetPatience);
    EXPECT_EQ(ending ? ending->words() : "", status) << far.output() << far.errors();
    EXPECT_NE(far.errors().find(errors), std::string::npos) << far.output() << far.errors();
  }
};

TEST_F(CheckedVehicles, DriveOnlyWithAChecklistThatSomebodySigned) {
  make_network(76);
  const Process line = model("north");
  {
    const Process first = rover("north", "veh-1");
    ends_with(
        start(), "exit status 1",
        "the mission moves the vehicle `veh-1`, and there is no signed pre-flight checklist that holds: "
        "nobody has signed one for this mission yet");
    ends_with(preflight({"--sign", "Ada"}), "exit status 2", "--sign asks a person at a terminal");
    EXPECT_EQ(first.output().find("a run drives it"), std::string::npos) << first.output();
    ends_with(preflight({"--sign", "Ada", "--yes"}), "exit status 0", "");
    Process far = start({"--record", "/tmp/checked.mcap"});
    EXPECT_TRUE(first.prints("a run drives it", kFleetPatience)) << far.output() << far.errors();
    EXPECT_TRUE(far.prints("the pre-flight checklist was signed by Ada", kFleetPatience)) << far.output();
    far.signal(SIGTERM);
    EXPECT_TRUE(far.wait(kFleetPatience));
    std::ifstream file(base().path("/tmp/checked.mcap"), std::ios::binary);
    const std::string recorded{std::istreambuf_iterator<char>(file), {}};
    EXPECT_NE(recorded.find("the pre-flight checklist was signed by Ada"), std::string::npos);
  }
  const Process first = rover("north", "veh-1");
  ends_with(start(), "exit status 1", "the process of the vehicle `veh-1` was started anew since");
  Process unchecked = start({"--unchecked", "its wheels are off the ground"});
  EXPECT_TRUE(first.prints("a run drives it", kFleetPatience)) << unchecked.errors();
  EXPECT_TRUE(
      unchecked.prints("were not checked before the mission: its wheels are off the ground", kFleetPatience))
      << unchecked.output();
  unchecked.signal(SIGTERM);
  EXPECT_TRUE(unchecked.wait(kFleetPatience));
}

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

// In a line `[    12.3 s] what`; infinite: there is none.
double time_of(const std::string& output, std::string_view what) {
  const std::size_t line = output.rfind('[', output.find(what));
  double out = std::numeric_limits<double>::infinity();
  if (output.contains(what) && line != std::string::npos) std::sscanf(output.c_str() + line, "[%lf s]", &out);
  return out;
}

TEST_F(Vehicles, ObeyTheEmergencyStop) {
  make_network(74);
  const Process first = vehicle("north", "veh-1", "8,12,0");
  const Process second = vehicle("south", "veh-2", "8,18,0");
  const Process agent = this->agent("north");
  const auto began = std::chrono::steady_clock::now();
  Process far = cross();
  ASSERT_TRUE(first.prints("a run drives it", kFleetPatience)) << far.output();
  ASSERT_FALSE(far.wait(1s)) << "all move: " << far.output();
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
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - began;
  EXPECT_LE(time_of(far.output(), "the emergency stop was released"), passed.count())
      << "while bodies brake its clock goes no faster than ours: " << far.output();
  far.signal(SIGTERM);
  EXPECT_TRUE(far.wait(kFleetPatience));
}

TEST_F(Vehicles, OfTwoOfOneNameThatHaveNotFoundEachOtherOneIsDriven) {
  make_network(77);
  net().cut(net().host("north"), net().host("south"));
  const Process first = vehicle("north", "veh-1", "8,12,0");
  const Process other = vehicle("south", "veh-1", "8,12,0");
  const Process second = vehicle("south", "veh-2", "8,18,0");
  const Process agent = this->agent("south");
  Process far = cross();
  EXPECT_TRUE(far.prints("two agents call themselves `veh-1`", kFleetPatience)) << far.output();
  EXPECT_TRUE(second.prints("a run drives it", kFleetPatience)) << far.output();
  ASSERT_FALSE(far.wait(2s)) << far.output();
  const auto is_driven = [](const Process& one) { return one.output().contains("a run drives it"); };
  EXPECT_NE(is_driven(first), is_driven(other)) << first.output() << other.output();
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
