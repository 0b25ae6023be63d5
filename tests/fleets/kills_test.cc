// Whoever is killed or stopped, at whatever moment: the mission ends as it should or says why not, nothing
// hangs, and nothing is left. MLAB_KILLS says how often; the suite tries a few.

#include <csignal>
#include <cstdlib>
#include <map>
#include <optional>
#include <random>

#include <fmt/ranges.h>

#include "fleets.h"
#include "network/victim.h"

namespace mlab::testing {
namespace {

using network::Process;
using network::Victim;

struct Strike {
  enum class Whom { kRobot, kAgent, kRun };
  Whom whom = Whom::kRobot;
  bool is_stop = false;  // and goes on after a while
  std::chrono::milliseconds at{0};
  std::chrono::milliseconds stopped_for{0};
  bool is_in_real_time = false;
};

std::string words(const Strike& strike) {
  constexpr const char* kNames[] = {"robot", "agent", "run"};
  return fmt::format("{} {} after {} ms{}{}", kNames[static_cast<std::size_t>(strike.whom)],
                     strike.is_stop ? "stopped" : "killed", strike.at.count(),
                     strike.is_stop ? fmt::format(", for {} ms", strike.stopped_for.count()) : "",
                     strike.is_in_real_time ? ", in real time" : "");
}

Strike any_strike(std::mt19937& random, bool may_be_in_real_time) {
  const auto below = [&](std::uint32_t count) { return static_cast<std::uint32_t>(random() % count); };
  Strike out;
  out.whom = static_cast<Strike::Whom>(below(3));
  out.is_stop = below(3) == 0;
  out.is_in_real_time = may_be_in_real_time && below(5) == 0;
  out.at = std::chrono::milliseconds(below(out.is_in_real_time ? 12'000 : 1'500));
  out.stopped_for = std::chrono::milliseconds(100 + below(8'000));
  return out;
}

class Kills : public Fleets {
 protected:
  // Those that were struck are started again.
  void start_agents() {
    for (const char* const name : {"north", "south"}) {
      std::optional<Process>& one = agents_[name];
      if (one && one->wait(0s)) one.reset();
      if (!one) one.emplace(agent(name));
    }
  }

  std::vector<Victim> victims(const Strike& strike, const Process& far) {
    std::vector<Victim> out;
    switch (strike.whom) {
      case Strike::Whom::kRun:
        for (const network::Seen& one : base().processes()) {
          if (one.id == far.id()) out.emplace_back(one);
        }
        break;
      case Strike::Whom::kAgent:
        for (const auto& [name, one] : agents_) {
          for (const network::Seen& seen : net().host(name).processes()) {
            if (one && seen.id == one->id()) out.emplace_back(seen);
          }
        }
        break;
      case Strike::Whom::kRobot:
        for (const auto& host : net().hosts()) {
          for (const network::Seen& one : host->processes()) {
            if (one.name == "mlab-robots") out.emplace_back(one);
          }
        }
        break;
    }
    return out;
  }

  void try_out(const Strike& strike, std::mt19937& random) {
    start_agents();
    std::vector<std::string> more = {"--patience", "40"};
    if (strike.is_in_real_time)
      more.emplace_back("--real-time");
    else
      more.insert(more.end(), {"--speed", "10"});
    Process far = run(base::source_folder() + "/tests/fleets/errand/errand.mdl", more);
    ASSERT_TRUE(come_to_be(2)) << far.output() << far.errors();
    std::this_thread::sleep_for(strike.at);
    const std::vector<Victim> all = victims(strike, far);
    const bool is_struck =
        !all.empty() && all[random() % all.size()].signal(strike.is_stop ? SIGSTOP : SIGKILL);
    if (strike.is_stop) {
      std::this_thread::sleep_for(strike.stopped_for);
      for (const Victim& one : all) one.signal(SIGCONT);
    }
    const auto ending = far.wait(3 * kFleetPatience);
    ASSERT_TRUE(ending) << "it hangs: " << far.output() << far.errors();
    const std::string told = far.output() + far.errors();
    if (is_struck && strike.whom == Strike::Whom::kRun && !strike.is_stop) {
      EXPECT_TRUE(ending->words() == "killed by SIGKILL" || ending->words() == "exit status 0") << told;
    } else if (ending->words() == "exit status 0") {
      EXPECT_EQ(report()["outcome"], "done");
    } else {
      EXPECT_EQ(ending->words(), "exit status 1") << told;
      // A robot whose process is killed once is replaced.
      EXPECT_TRUE(strike.whom != Strike::Whom::kRobot || strike.is_stop) << told;
      EXPECT_NE(report()["outcome"], "done");
      bool has_reason = false;
      for (const char* const reason :
           {"can't be reached: the agent on", "took longer than", "ended with signal"})
        has_reason |= told.find(reason) != std::string::npos;
      EXPECT_TRUE(has_reason) << "nobody learns why: " << told;
    }
    EXPECT_TRUE(come_to_be(0)) << "robots outlive their run";
  }

 private:
  std::map<std::string, std::optional<Process>> agents_;
};

TEST_F(Kills, AtAnyMomentAreBorneOrReported) {
  const char* const wanted =
      std::getenv("MLAB_KILLS");  // NOLINT(concurrency-mt-unsafe): nothing sets variables
  const int count = wanted != nullptr ? std::atoi(wanted) : 4;
  const char* const chosen = std::getenv("MLAB_KILLS_SEED");  // NOLINT(concurrency-mt-unsafe): as above
  const std::uint32_t seed = chosen != nullptr ? static_cast<std::uint32_t>(std::atoi(chosen)) : 41;
  fmt::print("{} strikes, seed {}\n", count, seed);
  std::mt19937 random(seed);
  make_network(seed);
  for (int i = 0; i < count && !HasFailure(); ++i) {
    const Strike strike = any_strike(random, wanted != nullptr);
    fmt::print("{}: {}\n", i, words(strike));
    std::fflush(stdout);
    SCOPED_TRACE(words(strike));
    try_out(strike, random);
  }
  std::filesystem::remove(base().path("/tmp/report.json"));
  EXPECT_EQ(leftovers(), "") << "of what was struck";
}

}  // namespace
}  // namespace mlab::testing
