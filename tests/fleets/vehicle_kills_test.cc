// A vehicle never moves without a live command: the run, `mlab robot` or the link between them is killed,
// stopped or cut at random moments, and vehicles that other people's implementations play stand within their
// stated time. MLAB_KILLS says how often; the suite tries a few.

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <optional>
#include <random>

#include "mlab/vehicle/server.h"
#include "vehicle_peers.h"

namespace mlab::testing {
namespace {

using network::Process;

/// What is told in one piece comes in the next one: a moment of the log, and of whoever reads it [s].
constexpr double kLate = 0.3;
/// Where it may take longer until a vehicle has to stand, one that stands is watched for so long [s].
constexpr double kWatched = 1.5;
constexpr double kWatchedAtLeast = 2.2;  // since it was struck [s]

struct Blow {
  enum class What { kRunKilled, kRobotKilled, kLinkCut, kRobotStopped, kRunStopped };
  What what = What::kRunKilled;
  std::size_t whom = 0;  // of the vehicles; of no meaning where the run is struck
  bool waits = true;     // until all move
  bool by_nav2 = false;  // the first vehicle is driven by its navigator
  std::chrono::milliseconds at{0};
};

constexpr std::array kWhat = {"the run is killed", "mlab robot is killed", "the link is cut",
                              "mlab robot is stopped", "the run is stopped"};

bool is_of_the_run(Blow::What what) {
  return what == Blow::What::kRunKilled || what == Blow::What::kRunStopped;
}

/// Each kind and each vehicle comes in turn; the moment is random.
Blow any_blow(int number, std::mt19937& random) {
  const auto below = [&](std::uint32_t count) { return static_cast<std::uint32_t>(random() % count); };
  Blow out;
  out.what = static_cast<Blow::What>(static_cast<std::size_t>(number) % kWhat.size());
  out.whom = static_cast<std::size_t>(number + 1) % 2;
  out.by_nav2 = number % 4 == 1;
  out.waits = below(5) != 0;
  out.at = std::chrono::milliseconds(below(out.waits ? 2'000 : 5'000));
  return out;
}

/// A vehicle, the `mlab robot` that is connected to it, and where both are.
struct Vehicle {
  const char* name;  // in the fleet
  const char* host;
  std::unique_ptr<VehiclePeer> peer = nullptr;
  std::optional<Process> robot = std::nullopt;
};

class VehicleKills : public Fleets {
 protected:
  void SetUp() override {
    Fleets::SetUp();
    MLAB_NEEDS_PEERS();
  }

  void begin(std::uint32_t seed) {
    make_network(seed);
    vehicles_[0].peer = start_ros2_robot(net().host("north"), "", "0,0,0");
    vehicles_[1].peer = start_mavlink_rover(net().host("south"));
  }
  void start_robots(bool by_nav2) {
    Vehicle& first = vehicles_[0];
    if (by_nav2_ != by_nav2 && first.robot && first.robot->is_running()) {
      first.robot->signal(SIGTERM);
      EXPECT_TRUE(first.robot->wait(kFleetPatience));
    }
    by_nav2_ = by_nav2;
    first.peer->drive_by_nav2(by_nav2);
    for (Vehicle& one : vehicles_) {
      if (one.robot && one.robot->is_running()) continue;
      one.robot.reset();
      one.robot.emplace(start_robot(net().host(one.host), one.name, *one.peer));
    }
    for (Vehicle& one : vehicles_) {
      ASSERT_TRUE(one.peer->is_known_to(*one.robot)) << one.robot->output() << one.robot->errors();
    }
  }
  bool all_move(Process& far) {
    for (const auto end = network::Clock::now() + kFleetPatience; network::Clock::now() < end;) {
      if (std::ranges::all_of(vehicles_, [](Vehicle& one) { return one.peer->now().speed > 0.2; }))
        return true;
      if (!far.is_running()) return false;
      std::this_thread::sleep_for(20ms);
    }
    return false;
  }
  void strike(const Blow& strike, Process& far) {
    Vehicle& whom = vehicles_.at(strike.whom);
    switch (strike.what) {
      case Blow::What::kRunKilled:
        far.signal(SIGKILL);
        break;
      case Blow::What::kRunStopped:
        far.signal(SIGSTOP);
        break;
      case Blow::What::kRobotKilled:
        whom.robot->signal(SIGKILL);
        break;
      case Blow::What::kRobotStopped:
        whom.robot->signal(SIGSTOP);
        break;
      case Blow::What::kLinkCut:
        net().isolate(net().host(whom.host));
        break;
    }
  }
  /// All is as before, and nobody drives.
  void make_good(const Blow& strike, Process& far) {
    Vehicle& whom = vehicles_.at(strike.whom);
    if (strike.what == Blow::What::kRobotStopped) whom.robot->signal(SIGCONT);
    if (strike.what == Blow::What::kRunStopped) far.signal(SIGCONT);
    if (strike.what == Blow::What::kLinkCut) net().join(net().host(whom.host));
    far.signal(SIGTERM);
    EXPECT_TRUE(far.wait(kFleetPatience));
    for (Vehicle& one : vehicles_) EXPECT_TRUE(comes_to_be_driven(one, false)) << one.robot->output();
  }
  /// Whether a run drives it, by what its `mlab robot` said last of that; one that was killed drives nothing.
  static bool comes_to_be_driven(Vehicle& vehicle, bool is_driven) {
    for (const auto end = network::Clock::now() + kFleetPatience; network::Clock::now() < end;) {
      if (!vehicle.robot->is_running()) return !is_driven;
      const std::string said = vehicle.robot->output();
      const auto on = said.rfind("a run drives it");
      const auto off = said.rfind("no run drives it any more");
      const bool now = on != std::string::npos && (off == std::string::npos || off < on);
      if (now == is_driven) return true;
      std::this_thread::sleep_for(20ms);
    }
    return false;
  }

  /// It stands within its time and goes on to stand, and its position says so, too.
  void stands(const Blow& strike, Vehicle& vehicle, const VehiclePeer::Moment& struck) {
    // Where its `mlab robot` lives, that has it stop; else its own watchdog does.
    const bool is_told = strike.what != Blow::What::kRobotKilled && strike.what != Blow::What::kRobotStopped;
    const double stated = is_told ? vehicle.peer->standstill_when_told() + vehicle::kCommandPatience
                                  : vehicle.peer->standstill();
    VehiclePeer::Moment now = vehicle.peer->now();
    std::optional<VehiclePeer::Moment> stood;
    const auto has_stood_long = [&] {
      return stood && now.time > stood->time + kWatched && now.time > struck.time + kWatchedAtLeast;
    };
    while (now.time < struck.time + stated + kLate && !has_stood_long()) {
      std::this_thread::sleep_for(20ms);
      now = vehicle.peer->now();
      if (now.stands && !stood) stood = now;
      if (!now.stands) stood.reset();
    }
    ASSERT_TRUE(now.stands) << "it moves " << now.time - struck.time
                            << " s later: " << vehicle.robot->output() << vehicle.robot->errors();
    EXPECT_EQ(now.speed, 0.0);
    const double took = std::max(now.stood_at - struck.time, 0.0);
    EXPECT_LE(took, stated + kLate);
    const double crept = stood ? std::hypot(now.x - stood->x, now.y - stood->y) : 0.0;
    EXPECT_LE(crept, 0.05) << "it stood already";
    if (!struck.stands) fmt::print("   {} stood after {:.2f} s of {:.2f} s\n", vehicle.name, took, stated);
  }

  void try_out(const Blow& strike) {
    start_robots(strike.by_nav2);
    if (HasFatalFailure()) return;
    Process far = run(base::source_folder() + "/tests/fleets/vehicles/away.mdl", kMovingVehicles);
    for (Vehicle& one : vehicles_)
      ASSERT_TRUE(comes_to_be_driven(one, true)) << far.output() << far.errors() << one.robot->output();
    if (strike.waits) {
      ASSERT_TRUE(all_move(far)) << far.output() << far.errors() << vehicles_[0].robot->output()
                                 << vehicles_[1].robot->output();
    }
    std::this_thread::sleep_for(strike.at);
    std::array struck = {vehicles_[0].peer->now(), vehicles_[1].peer->now()};
    this->strike(strike, far);
    for (std::size_t i = 0; i < vehicles_.size(); ++i) {
      if (is_of_the_run(strike.what) || i == strike.whom) stands(strike, vehicles_.at(i), struck.at(i));
    }
    make_good(strike, far);
  }

 private:
  std::array<Vehicle, 2> vehicles_ = {Vehicle{"veh-1", "north"}, Vehicle{"veh-2", "south"}};
  bool by_nav2_ = false;
};

int number_of(const char* variable, int otherwise) {
  const char* const text = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): nothing sets variables
  return text != nullptr ? std::atoi(text) : otherwise;
}

TEST_F(VehicleKills, AtAnyMomentHaveVehiclesStandWithinTheirStatedTime) {
  const int count = number_of("MLAB_KILLS", 3);
  const auto seed = static_cast<std::uint32_t>(number_of("MLAB_KILLS_SEED", 42));
  fmt::print("{} strikes, seed {}\n", count, seed);
  std::mt19937 random(seed);
  begin(seed);
  for (int i = 0; i < count && !HasFailure(); ++i) {
    const Blow strike = any_blow(i, random);
    const std::string words = fmt::format("{}: {}, {} ms after {}, vehicle {}{}", i,
                                          kWhat.at(static_cast<std::size_t>(strike.what)), strike.at.count(),
                                          strike.waits ? "all move" : "it is driven", strike.whom,
                                          strike.by_nav2 ? ", by Nav2" : "");
    fmt::print("{}\n", words);
    std::fflush(stdout);
    SCOPED_TRACE(words);
    try_out(strike);
  }
}

}  // namespace
}  // namespace mlab::testing
