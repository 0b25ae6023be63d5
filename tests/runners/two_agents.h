#pragma once

#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "direct_link.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/robot/remote/remote_runner.h"

namespace mlab::testing {

inline constexpr const char* kAgentVersion = "test";

/// Robots at two agents, which are threads of this process.
/// @param links  those of the agents are added; null: nobody wants them
inline std::unique_ptr<robot::ProgramRunner> two_agents(std::uint64_t seed,
                                                        std::vector<DirectLink*>* links = nullptr) {
  auto agents = std::make_shared<std::vector<std::unique_ptr<robot_remote::Agent>>>();
  for (const char* name : {"alder", "birch"}) {
    auto link = std::make_unique<DirectLink>(
        robot::ProgramSources{.permission = cell::testing::code_permitted(), .version = kAgentVersion});
    if (links != nullptr) links->push_back(link.get());
    agents->push_back(std::make_unique<robot_remote::Agent>(name, std::move(link)));
    EXPECT_EQ(agents->back()->open(seed, kAgentVersion), std::nullopt);
  }
  return std::make_unique<robot_remote::RemoteRunner>(
      [agents](const robot::RobotProgram& /*program*/,
               const std::vector<std::string>& /*lost*/) -> robot_remote::RemoteRunner::Newcomers {
        return {std::exchange(*agents, {}), "nobody of that name is there"};
      });
}

}  // namespace mlab::testing
