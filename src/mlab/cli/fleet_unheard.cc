#include "mlab/cli/fleet_unheard.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <utility>

#include <fmt/core.h>

#include "mlab/agents/agent_process.h"
#include "mlab/cli/fleet_network.h"
#include "mlab/text/age.h"

namespace mlab::cli {
namespace {

/// In which whoever is there has been found.
constexpr std::chrono::seconds kFound(5);

/// Process that holds an agent's name on this machine; 0: none does.
pid_t holder_of(const std::string& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return 0;
  const bool is_held = ::flock(descriptor, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(descriptor);
  pid_t process = 0;
  if (is_held) std::ifstream(file) >> process;
  return std::max(process, 0);
}

/// Somebody has stopped it (SIGSTOP, Ctrl-Z), or a debugger has.
bool is_stopped(pid_t process) {
  std::ifstream about(fmt::format("/proc/{}/status", process));
  for (std::string line; std::getline(about, line);) {
    if (line.starts_with("State:")) return line.find_first_of("Tt", 6) == line.find_first_not_of(" \t", 6);
  }
  return false;
}

double seconds_between(agents::Clock::time_point earlier, agents::Clock::time_point later) {
  return std::max(0.0, std::chrono::duration<double>(later - earlier).count());
}

}  // namespace

std::expected<std::unique_ptr<UnheardAgents>, std::string> UnheardAgents::open(
    std::shared_ptr<agents::Roster> roster, const dds::Network& network) {
  auto waiter = dds::Waiter::make();
  if (!waiter) return std::unexpected(waiter.error());
  auto hearsay = agents::Hearsay::open(roster->participant(), *waiter);
  if (!hearsay) return std::unexpected(hearsay.error());
  return std::unique_ptr<UnheardAgents>(
      new UnheardAgents(std::move(roster), network, std::move(*waiter), std::move(*hearsay)));
}

UnheardAgents::UnheardAgents(std::shared_ptr<agents::Roster> roster, const dds::Network& network,
                             dds::Waiter waiter, std::unique_ptr<agents::Hearsay> hearsay)
    : roster_(std::move(roster)),
      waiter_(std::move(waiter)),
      hearsay_(std::move(hearsay)),
      siblings_(agents_folder(), network.fleet, agents::company_of(network)),
      fleet_(network.fleet) {}

std::vector<UnheardAgent> UnheardAgents::look() {
  std::vector<UnheardAgent> out;
  hearsay_->listen();
  for (agents::Hearsay::Entry& one : hearsay_->all(agents::Clock::now())) {
    if (roster_->sight(one.agent.name)) continue;  // what is known of it here is better
    out.push_back(
        {std::move(one.agent.name), std::move(one.agent.machine), one.agent.silent, std::move(one.by), 0});
  }
  add_siblings(out);
  std::ranges::sort(out, {}, &UnheardAgent::name);
  return out;
}

void UnheardAgents::add_siblings(std::vector<UnheardAgent>& out) {
  const agents::Clock::time_point now = agents::Clock::now();
  for (const agents::Sibling& one : siblings_.look()) {
    if (roster_->sight(one.name)) continue;
    const pid_t process = holder_of(kept_file(fleet_, one.name, "lock"));
    // Who notes that he is there is found in a moment.
    if (one.is_there && !is_stopped(process) && now - began_ < kFound) continue;
    if (process == 0 && now - one.heard >= agents::kMissedFor) continue;
    const auto at = std::ranges::find(out, one.name, &UnheardAgent::name);
    UnheardAgent& agent = at == out.end() ? out.emplace_back() : *at;
    agent = {one.name, agents::machine_name(), seconds_between(one.heard, now), "", process};
  }
}

std::vector<std::string> about_unheard(const std::vector<UnheardAgent>& agents) {
  std::vector<std::string> out;
  for (const UnheardAgent& one : agents) {
    const std::string since = text::age(one.silent);
    const std::string who = fmt::format("`{}`, on `{}`,", one.name, one.machine);
    if (one.process > 0)
      out.push_back(fmt::format(
          "{} is silent: its process {} is there, and {} (it noted that it was there {} ago)", who,
          one.process, is_stopped(one.process) ? "is stopped: `kill -CONT` lets it go on" : "hangs", since));
    else if (one.by.empty())
      out.push_back(
          fmt::format("{} is not there, and did not end in order: it was there {} ago", who, since));
    else
      out.push_back(fmt::format("{} is not heard: {} heard it {} ago", who, one.by, since));
  }
  return out;
}

}  // namespace mlab::cli
