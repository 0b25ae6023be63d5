#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "mlab/agents/roster.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/fleet_network.h"
#include "mlab/cli/interrupt.h"
#include "mlab/cli/output.h"
#include "mlab/cli/terminal.h"

namespace mlab::cli {
namespace {

using agents::Clock;
using agents::Member;

constexpr std::chrono::milliseconds kFirstLook(4000);  // in which somebody is found if somebody is there
constexpr std::chrono::milliseconds kOthers(1000);
constexpr std::chrono::milliseconds kBetweenLooks(1000);

double seconds_since(Clock::time_point then) {
  return std::chrono::duration<double>(Clock::now() - then).count();
}

std::string age(double seconds) {
  if (seconds < 120.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.0f} h", seconds / 3600.0);
}

std::string state_of(const Member& member) {
  switch (member.state) {
    case Member::State::kThere:
      return "there";
    case Member::State::kSilent:
      return "silent for " + age(seconds_since(member.heard));
    case Member::State::kGone:
      return "gone for " + age(seconds_since(member.since));
  }
  return "";
}

Color color_of(Member::State state) {
  return state == Member::State::kThere    ? Color::kGood
         : state == Member::State::kSilent ? Color::kWarning
                                           : Color::kBad;
}

std::string table_of(const std::string& fleet, const std::vector<Member>& members) {
  if (members.empty())
    return fmt::format("fleet `{0}`: nobody is there; `mlab agent --fleet {0}` starts an agent\n", fleet);
  std::string out = fmt::format("{:<16} {:<16} {:<18} {:>6} {:>5} {:>10} {:>12} {:>8}  {}\n", "AGENT",
                                "MACHINE", "STATE", "ROBOTS", "RUNS", "LOAD", "FREE MEMORY", "UP", "VERSION");
  for (const Member& one : members) {
    const std::string state = fmt::format("{:<18}", state_of(one));
    out += fmt::format("{:<16} {:<16} {} {:>6} {:>5} {:>10} {:>12} {:>8}  {}\n", one.said.name(),
                       one.said.host(), colored(state, color_of(one.state)), one.said.robots(),
                       one.said.runs(), fmt::format("{:.1f} of {}", one.said.load(), one.said.processors()),
                       fmt::format("{} MB", one.said.free_memory() >> 20), age(one.said.uptime()),
                       one.said.version());
  }
  return out;
}

std::string json_of(const std::string& fleet, const std::vector<Member>& members) {
  nlohmann::json agents = nlohmann::json::array();
  for (const Member& one : members) {
    constexpr const char* kStates[] = {"there", "silent", "gone"};
    agents.push_back({{"name", one.said.name()},
                      {"machine", one.said.host()},
                      {"state", kStates[static_cast<std::size_t>(one.state)]},
                      {"heard_s_ago", seconds_since(one.heard)},
                      {"robots", one.said.robots()},
                      {"runs", one.said.runs()},
                      {"load", one.said.load()},
                      {"processors", one.said.processors()},
                      {"free_memory_bytes", one.said.free_memory()},
                      {"uptime_s", one.said.uptime()},
                      {"version", one.said.version()}});
  }
  return nlohmann::json{{"fleet", fleet}, {"agents", agents}}.dump(2) + "\n";
}

void pass(std::chrono::milliseconds time) {
  const Clock::time_point end = Clock::now() + time;
  while (!was_interrupted() && Clock::now() < end) std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

}  // namespace

int show_fleet(const FleetOptions& options) {
  const dds::Network network = network_of(options.network);
  const auto roster = agents::Roster::join(network);
  if (!roster) {
    fmt::print(stderr, "mlab fleet: {}\n", roster.error());
    return kBadInput;
  }
  note_interrupts();
  const bool is_live = ::isatty(STDOUT_FILENO) == 1 && !options.once && !options.json;
  const auto is_there = [](const std::vector<Member>& members) {
    return was_interrupted() || !members.empty();
  };
  (*roster)->wait(is_there, Clock::now() + kFirstLook);
  pass(kOthers);  // who has been found first is hardly alone
  for (;;) {
    const std::vector<Member> members = (*roster)->members();
    const std::string& fleet = network.fleet;
    const std::string text = options.json ? json_of(fleet, members) : table_of(fleet, members);
    const bool is_read = write_output_now(is_live ? "\x1b[H\x1b[2J" + text : text);
    if (!is_live || !is_read || was_interrupted()) return kDone;
    pass(kBetweenLooks);
  }
}

}  // namespace mlab::cli
