#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <expected>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "mlab/agents/agent_log.h"
#include "mlab/agents/echo.h"
#include "mlab/agents/ending_watchdog.h"
#include "mlab/agents/roster.h"
#include "mlab/agents/stop_switch.h"
#include "mlab/cli/clock.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/fleet_network.h"
#include "mlab/cli/fleet_stop.h"
#include "mlab/cli/fleet_unheard.h"
#include "mlab/cli/fleet_words.h"
#include "mlab/cli/interrupt.h"
#include "mlab/cli/output.h"
#include "mlab/cli/terminal.h"
#include "mlab/keys/identity.h"
#include "mlab/text/age.h"

namespace mlab::cli {
namespace {

using agents::Clock;
using agents::Member;

constexpr std::chrono::milliseconds kFirstLook(4000);  // in which somebody is found if somebody is there
constexpr std::chrono::milliseconds kOthers(1000);
constexpr std::chrono::milliseconds kBetweenLooks(1000);
constexpr int kFirstEchoes = 5;  // measurements of links before the first look

double seconds_since(Clock::time_point then) {
  return std::chrono::duration<double>(Clock::now() - then).count();
}

std::string state_of(const Member& member) {
  switch (member.state) {
    case Member::State::kThere:
      if (!member.said.not_kept().empty()) return "STOPPED, not kept";
      return member.said.stop().is_engaged() ? "STOPPED" : "there";
    case Member::State::kSilent:
      return "silent for " + text::age(seconds_since(member.heard));
    case Member::State::kGone:
      return "gone for " + text::age(seconds_since(member.since));
  }
  return "";
}

Color color_of(const Member& member) {
  const Member::State state = member.state;
  if (member.said.stop().is_engaged()) return Color::kBad;
  return state == Member::State::kThere    ? Color::kGood
         : state == Member::State::kSilent ? Color::kWarning
                                           : Color::kBad;
}

// `1.2 ms`, and what is lost of it.
std::string link_of(const std::optional<agents::LinkQuality>& link) {
  if (!link) return "-";
  return fmt::format("{:.1f} ms{}", link->round_trip * 1000.0,
                     link->lost > 0.0 ? fmt::format(", {:.0f} % lost", link->lost * 100.0) : "");
}

// How far an agent's clock is ahead, where that is more than the measurement can be wrong by.
std::string clock_of(const std::optional<agents::LinkQuality>& link) {
  if (!link) return "-";
  const double offset = link->clock_offset;
  if (!agents::is_clock_known(*link)) return "the same";
  if (std::abs(offset) < 1.0) return fmt::format("{:+.1f} ms", offset * 1000.0);
  return fmt::format("{}{}", offset < 0.0 ? "-" : "+", text::age(std::abs(offset)));
}

// Of whom nothing is heard, though somebody knows of him.
std::string table_of(const std::vector<UnheardAgent>& unheard) {
  std::string out;
  for (const std::string& words : about_unheard(unheard)) out += "warning: " + words + "\n";
  return out;
}

std::string table_of(const std::string& fleet, const std::vector<Member>& members,
                     const agents::EchoProbe& links, const NetworkOptions& network) {
  if (members.empty()) return nobody_is_there(fleet, network) + "\n";
  std::string out = fmt::format("{:<16} {:<16} {:<18} {:<18} {:<10} {:>6} {:>5} {:>10} {:>12} {:>8}  {}\n",
                                "AGENT", "MACHINE", "STATE", "ROUND TRIP", "CLOCK", "ROBOTS", "RUNS", "LOAD",
                                "FREE MEMORY", "UP", "VERSION");
  for (const Member& one : members) {
    const std::string state = fmt::format("{:<18}", state_of(one));
    const auto link = one.state == Member::State::kThere ? links.quality(one.said.name()) : std::nullopt;
    out += fmt::format("{:<16} {:<16} {} {:<18} {:<10} {:>6} {:>5} {:>10} {:>12} {:>8}  {}\n",
                       one.said.name(), one.said.host(), colored(state, color_of(one)), link_of(link),
                       clock_of(link), one.said.robots(), one.said.runs(),
                       fmt::format("{:.1f} of {}", one.said.load(), one.said.processors()),
                       fmt::format("{} MB", one.said.free_memory() >> 20), text::age(one.said.uptime()),
                       one.said.version() +
                           (one.said.has_offered()   ? fmt::format(", `{}` only", one.said.offered().name())
                            : one.said.has_vehicle() ? fmt::format(", vehicle: {}", one.said.vehicle().kind())
                                                     : ""));
  }
  if (const std::string words = about_doubles(members); !words.empty()) out += "warning: " + words + "\n";
  if (const std::string words = about_versions(members); !words.empty()) out += "warning: " + words + "\n";
  return out;
}

nlohmann::json json_of(const std::optional<agents::LinkQuality>& link) {
  if (!link) return nullptr;
  return {
      {"round_trip_s", link->round_trip}, {"clock_offset_s", link->clock_offset}, {"lost_share", link->lost}};
}

nlohmann::json json_of(const std::vector<UnheardAgent>& unheard) {
  nlohmann::json out = nlohmann::json::array();
  for (const UnheardAgent& one : unheard)
    out.push_back({{"name", one.name},
                   {"machine", one.machine},
                   {"heard_s_ago", one.silent},
                   {"known_by", one.by.empty() ? nlohmann::json() : nlohmann::json(one.by)},
                   {"process", one.process > 0 ? nlohmann::json(one.process) : nlohmann::json()}});
  return out;
}

std::string json_of(const std::string& fleet, const std::vector<Member>& members,
                    const agents::EchoProbe& links, const std::vector<UnheardAgent>& unheard) {
  nlohmann::json agents = nlohmann::json::array();
  for (const Member& one : members) {
    constexpr const char* kStates[] = {"there", "silent", "gone"};
    agents.push_back(
        {{"name", one.said.name()},
         {"machine", one.said.host()},
         {"state", kStates[static_cast<std::size_t>(one.state)]},
         {"is_stopped", one.said.stop().is_engaged()},
         {"is_stop_kept", one.said.not_kept().empty()},
         {"heard_s_ago", seconds_since(one.heard)},
         {"same_name_on", rival_of(one) ? nlohmann::json(rival_of(one)->host) : nullptr},
         {"link", json_of(links.quality(one.said.name()))},
         {"robots", one.said.robots()},
         {"runs", one.said.runs()},
         {"load", one.said.load()},
         {"processors", one.said.processors()},
         {"free_memory_bytes", one.said.free_memory()},
         {"uptime_s", one.said.uptime()},
         {"version", one.said.version()},
         {"executable", one.said.has_offered() ? nlohmann::json(one.said.offered().name()) : nullptr},
         {"vehicle", one.said.has_vehicle() ? nlohmann::json(one.said.vehicle().kind()) : nullptr}});
  }
  return nlohmann::json{{"fleet", fleet}, {"agents", agents}, {"unheard", json_of(unheard)}}.dump(2) + "\n";
}

constexpr std::chrono::seconds kStopPatience(6);  // for agents to say that they have stopped
constexpr std::chrono::seconds kAllFound(
    2);  // in which those are found who are there, though packets are lost

void wait_for_agents(const agents::Roster& roster) {
  const auto is_there = [](const std::vector<Member>& members) {
    return was_interrupted() || !members.empty();
  };
  roster.wait(is_there, Clock::now() + kFirstLook);
}

std::string listed(const std::vector<agents::StopSwitch::Unreached>& agents) {
  std::string out;
  for (const agents::StopSwitch::Unreached& one : agents)
    out += fmt::format("{}`{}`{}", out.empty() ? "" : ", ", one.name, about_unreached(one.by, one.silent));
  return out;
}

// Those of this machine that hang, and whom nobody on the network knows.
void add_hanging(std::vector<agents::StopSwitch::Unreached>& out, UnheardAgents& unheard) {
  for (UnheardAgent& one : unheard.look()) {
    if (one.process > 0 && std::ranges::count(out, one.name, &agents::StopSwitch::Unreached::name) == 0)
      out.push_back({std::move(one.name), one.silent, "", std::move(one.machine)});
  }
}

// Says it until all have heard. Who has not been found when this begins hears it as soon as he is.
int switch_stop(const FleetOptions& options, const agents::Roster& roster, agents::StopSwitch& stop,
                UnheardAgents& unheard) {
  if (options.stop) stop.engage(stopping_person());
  wait_for_agents(roster);
  const Clock::time_point first = Clock::now() + kAllFound;
  const Clock::time_point last = Clock::now() + kStopPatience;
  bool is_said = options.stop;
  while (!was_interrupted() && Clock::now() < last) {
    // What is to be released is known from those who hold it.
    if (!is_said && stop.state().is_engaged()) {
      stop.release(stopping_person());
      is_said = true;
    }
    if (Clock::now() >= first && (!is_said || stop.unreached().empty())) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const std::string& fleet = roster.fleet();
  auto unreached = stop.unreached();
  std::size_t count = std::max(stop.agent_count(), unreached.size());  // which others may add to
  const std::size_t reachable = unreached.size();
  add_hanging(unreached, unheard);
  count += unreached.size() - reachable;
  if (count == 0) {
    fmt::print(stderr, "mlab fleet: nobody is there in the fleet `{}`{}\n", fleet,
               who_is_not_seen(options.network));
    return kFailed;
  }
  if (!is_said) {
    fmt::print("the fleet `{}` is not stopped\n", fleet);
    return kDone;
  }
  if (const agents::StopState holds = stop.state(); !options.stop && holds.is_engaged()) {
    fmt::print(
        stderr,
        "mlab fleet: the fleet `{}` still stands: another emergency stop, by {}, was not known of when "
        "the one before was released; --release again releases both\n",
        fleet, holds.by());
    return kFailed;
  }
  fmt::print("{}: {} of {} agents of the fleet `{}` have confirmed\n",
             options.stop ? "EMERGENCY STOP" : "the emergency stop is released", count - unreached.size(),
             count, fleet);
  if (const std::string words = about_forgetful(stop.forgetful()); !words.empty())
    fmt::print(stderr, "mlab fleet: warning: {}\n", words);
  // Whether he stands nobody knows here.
  if (const std::string words = about_doubles(roster.members()); !words.empty()) {
    fmt::print(stderr, "mlab fleet: {}\n", words);
    return kFailed;
  }
  if (unreached.empty()) return kDone;
  fmt::print(stderr, "mlab fleet: not confirmed by {}; each hears of it from the others when it is back\n",
             listed(unreached));
  return kFailed;
}

int show_log(const std::shared_ptr<agents::Roster>& roster, const std::string& agent) {
  const auto is_there = [&](const std::vector<Member>& members) {
    return was_interrupted() ||
           std::ranges::any_of(members, [&](const Member& one) { return one.said.name() == agent; });
  };
  roster->wait(is_there, Clock::now() + kFirstLook);
  const auto lines = agents::read_log(roster, agent);
  if (!lines) {
    fmt::print(stderr, "mlab fleet: {}\n", lines.error());
    return kFailed;
  }
  const MissionClock now = wall_clock();
  std::string out;
  for (const robot::LogLine& line : *lines) {
    MissionClock then = now;
    then.epoch_seconds -= line.age;
    out += fmt::format("{}  {}\n", print(then), line.text);
  }
  write_output_now(out);
  return kDone;
}

/// The fleet as seen from here.
struct View {
  std::shared_ptr<agents::Roster> roster;
  std::unique_ptr<agents::EchoProbe> links;
  std::unique_ptr<UnheardAgents> unheard;
};

std::expected<std::shared_ptr<agents::Roster>, std::string> join(const FleetOptions& options) {
  const auto network = network_of(options.network);
  if (!network) return std::unexpected(network.error());
  return agents::Roster::join(*network);
}

// With those who are there, and the links to them.
std::expected<View, std::string> look(const FleetOptions& options) {
  const auto network = network_of(options.network);
  if (!network) return std::unexpected(network.error());
  auto roster = agents::Roster::join(*network);
  if (!roster) return std::unexpected(roster.error());
  auto links = agents::EchoProbe::open(*roster);
  if (!links) return std::unexpected(links.error());
  auto unheard = UnheardAgents::open(*roster, *network);
  if (!unheard) return std::unexpected(unheard.error());
  wait_for_agents(**roster);
  // Who has been found first is hardly alone.
  for (int i = 0; i < kFirstEchoes && !was_interrupted(); ++i) (*links)->measure(kOthers / kFirstEchoes);
  return View{std::move(*roster), std::move(*links), std::move(*unheard)};
}

int tell_problem(const std::string& problem) {
  fmt::print(stderr, "mlab fleet: {}\n", problem);
  return kBadInput;
}

int switch_stop(const FleetOptions& options, const std::shared_ptr<agents::Roster>& roster) {
  const auto network = network_of(options.network);
  if (!network) return tell_problem(network.error());
  const auto stop = agents::StopSwitch::open(roster);
  if (!stop) return tell_problem(stop.error());
  const auto unheard = UnheardAgents::open(roster, *network);
  if (!unheard) return tell_problem(unheard.error());
  return switch_stop(options, *roster, **stop, **unheard);
}

}  // namespace

int show_fleet(const FleetOptions& options) {
  note_interrupts();
  const bool is_about_stop = options.stop || options.release;
  agents::EndingWatchdog watchdog("mlab fleet", [&]() -> std::optional<int> {
    return was_interrupted() ? std::optional(is_about_stop ? kFailed : kDone) : std::nullopt;
  });
  if (is_about_stop) {
    const auto roster = join(options);
    if (!roster) return tell_problem(roster.error());
    return watchdog.expect_end(switch_stop(options, *roster));
  }
  if (!options.log.empty()) {
    const auto roster = join(options);
    return watchdog.expect_end(roster ? show_log(*roster, options.log) : tell_problem(roster.error()));
  }
  keys::WithdrawalWatch withdrawals(identity_folder(options.network));
  auto view = look(options);
  const bool is_live = ::isatty(STDOUT_FILENO) == 1 && !options.once && !options.json;
  for (;;) {
    if (!view) return tell_problem(view.error());
    const std::vector<Member> members = view->roster->members();
    const std::string& fleet = view->roster->fleet();
    const std::vector<UnheardAgent> unheard = view->unheard->look();
    const std::string text =
        options.json ? json_of(fleet, members, *view->links, unheard)
                     : table_of(fleet, members, *view->links, options.network) + table_of(unheard);
    const bool is_read = write_output_now(is_live ? "\x1b[H\x1b[2J" + text : text);
    if (!is_live || !is_read || was_interrupted()) return watchdog.expect_end(kDone);
    view->links->measure(kBetweenLooks);
    if (!withdrawals.has_changed() && !view->roster->participant().has_run_out()) continue;
    view = View{};  // who was withdrawn hears nothing from here on, and who has run out is refused
    view = look(options);
  }
}

}  // namespace mlab::cli
