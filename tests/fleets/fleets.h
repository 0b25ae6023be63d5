#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mlab/base/testing/source_folder.h"
#include "network/test_network.h"

namespace mlab::testing {

using namespace std::chrono_literals;
using Json = nlohmann::json;

inline constexpr auto kFleetPatience =
    60s;  // for what takes a second on a machine that has nothing else to do

/// Where agents keep what outlives them: a folder of each host of its own.
inline constexpr const char* kAgentState = "/tmp/state";

inline std::string mission(const std::string& name) {
  return base::source_folder() + "/missions/" + name + "/" + name + ".mdl";
}

inline Json report_in(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return Json::parse(stream, nullptr, false);
}

/// A base, where runs are, and two machines that carry robots.
class Fleets : public ::testing::Test {
 protected:
  void SetUp() override { MLAB_NEEDS_HOSTS(); }

  network::TestNetwork& net() { return *net_; }
  network::Host& base() { return net().host("base"); }

  void make_network(std::uint64_t seed) {
    net_ = std::make_unique<network::TestNetwork>(
        network::NetworkSetup{.seed = seed, .hosts = {{"base"}, {"north"}, {"south"}}});
  }
  /// What it keeps is on its host: another test's agents have the same names.
  network::Process called(const std::string& name, const std::string& host,
                          const std::string& fleet = "alpha") {
    return net().host(host).start(
        {MLAB_COMMAND, "agent", "--fleet", fleet, "--name", name, "--network", net().host(host).address()},
        {.environment = {{"XDG_STATE_HOME", kAgentState}}});
  }
  network::Process agent(const std::string& host, const std::string& fleet = "alpha") {
    network::Process out = called(host, host, fleet);
    EXPECT_TRUE(out.prints("waits for runs", kFleetPatience)) << out.output() << out.errors();
    return out;
  }
  /// @param file  of a mission
  network::Process run(const std::string& file, const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {
        MLAB_COMMAND,     "run",       file,      "--headless", "--proceed",
        "--robots",       "fleet",     "--fleet", "alpha",      "--network",
        base().address(), "--threads", "1",       "--report",   "/tmp/report.json"};
    words.insert(words.end(), more.begin(), more.end());
    return base().start(words);
  }
  Json report() { return report_in(base().path("/tmp/report.json")); }
  /// Programs of robots that run somewhere.
  std::size_t robot_processes() {
    std::size_t out = 0;
    for (const auto& host : net().hosts()) {
      for (const network::Seen& one : host->processes()) out += one.name == "mlab-robots" ? 1 : 0;
    }
    return out;
  }
  /// What was left behind anywhere, in words; what agents keep is meant to stay.
  std::string leftovers() {
    for (const auto& host : net().hosts()) std::filesystem::remove_all(host->path(kAgentState));
    return fmt::format("{}", fmt::join(net().leftovers(), "\n"));
  }
  bool come_to_be(std::size_t count) {
    for (const auto end = network::Clock::now() + kFleetPatience; network::Clock::now() < end;) {
      if (robot_processes() == count) return true;
      std::this_thread::sleep_for(20ms);
    }
    return false;
  }

 private:
  std::unique_ptr<network::TestNetwork> net_;
};

}  // namespace mlab::testing
