#pragma once

#include <unistd.h>

#include <atomic>
#include <future>
#include <map>
#include <memory>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/agents/agent_process.h"
#include "mlab/agents/fleet_runner.h"
#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"

namespace mlab::testing {

/// A fleet of two agents, over DDS, on threads of this process; other tests' fleets have other names.
class FleetOfThreads {
 public:
  static constexpr const char* kVersion = "test";

  /// @param lost_of_thousand  packets of each participant that don't arrive
  explicit FleetOfThreads(int lost_of_thousand = 0) {
    static std::atomic<int> fleets = 0;
    network_ = {.fleet = "runners-" + std::to_string(::getpid()) + "-" + std::to_string(++fleets),
                .interface_name = {},
                .peers = {},
                .lost_of_thousand = lost_of_thousand};
    std::vector<std::future<void>> ready;
    for (const char* name : {"alder", "birch"}) ready.push_back(begin(name));
    for (std::future<void>& one : ready) one.wait();
    auto roster = agents::Roster::join(network_);
    EXPECT_TRUE(roster) << roster.error();
    roster_ = std::move(*roster);
    const auto are_both_there = [](const std::vector<agents::Member>& members) {
      return members.size() == 2;
    };
    EXPECT_TRUE(roster_->wait(are_both_there, agents::Clock::now() + std::chrono::seconds(30)));
  }

  /// One for all tests of a program. Its threads end with the last test: what is static is destroyed after
  /// that.
  static FleetOfThreads& shared() { return kUntilTheLastTest->fleet(0); }
  /// The same, of whose packets every fifth does not arrive.
  static FleetOfThreads& shared_and_lossy() { return kUntilTheLastTest->fleet(200); }

  /// @param period  of a cycle in real time [s]; 0: in lock-step
  std::unique_ptr<robot::ProgramRunner> make_runner(std::uint64_t seed, double period = 0.0) const {
    return agents::make_fleet_runner(roster_, seed, kVersion, period);
  }
  agents::Roster& roster() { return *roster_; }

 private:
  class UntilTheLastTest : public ::testing::Environment {
   public:
    FleetOfThreads& fleet(int lost_of_thousand) {
      auto& one = fleets_[lost_of_thousand];
      if (!one) one = std::make_unique<FleetOfThreads>(lost_of_thousand);
      return *one;
    }
    void TearDown() override { fleets_.clear(); }

   private:
    std::map<int, std::unique_ptr<FleetOfThreads>> fleets_;
  };
  static UntilTheLastTest* const kUntilTheLastTest;

  std::future<void> begin(const std::string& name) {
    auto ready = std::make_shared<std::promise<void>>();
    std::future<void> out = ready->get_future();
    agents_.emplace_back([name, ready, network = network_](const std::stop_token& stop) {
      agents::AgentSettings settings;
      settings.network = network;
      settings.name = name;
      settings.sources = {.permission = cell::testing::code_permitted(),
                          .include_root = base::source_folder() + "/src",
                          .version = kVersion};
      settings.log = std::make_shared<agents::AgentLog>(nullptr);
      settings.tell_ready = [&] { ready->set_value(); };
      EXPECT_EQ(agents::serve_as_agent(settings, stop), std::nullopt);
    });
    return out;
  }

  dds::Network network_;
  std::shared_ptr<agents::Roster> roster_;
  std::vector<std::jthread> agents_;
};

inline FleetOfThreads::UntilTheLastTest* const FleetOfThreads::kUntilTheLastTest = [] {
  auto owned = std::make_unique<UntilTheLastTest>();
  UntilTheLastTest* const out = owned.get();
  ::testing::AddGlobalTestEnvironment(owned.release());
  return out;
}();

}  // namespace mlab::testing
