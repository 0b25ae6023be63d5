#include "mlab/cli/fleet_machines.h"

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "mlab/agents/echo.h"
#include "mlab/cli/fleet_words.h"

namespace mlab::cli {
namespace {

using agents::Clock;
using agents::Member;

using Links = std::map<std::string, agents::LinkQuality>;

/// Measures the links to all agents once a second, on a thread of its own, as long as somebody asks.
class LinkMeter {
 public:
  explicit LinkMeter(std::shared_ptr<agents::Roster> roster)
      : roster_(std::move(roster)), thread_([this](const std::stop_token& over) { measure(over); }) {}

  Links links() {
    const std::scoped_lock lock(mutex_);
    asked_ = Clock::now();
    wanted_.notify_all();
    return links_;
  }

 private:
  static constexpr std::chrono::seconds kInterest{5};         // in what was asked for last
  static constexpr std::chrono::milliseconds kBetween{950};   // two measurements
  static constexpr std::chrono::milliseconds kListening{50};  // what comes later counts at the next one

  // The network can't be used: nothing is known of links then, and all else is shown.
  void measure(const std::stop_token& over) {
    std::unique_ptr<agents::EchoProbe> probe;
    std::unique_lock lock(mutex_);
    while (!over.stop_requested()) {
      wanted_.wait(lock, over, [&] { return Clock::now() < asked_ + kInterest; });
      if (over.stop_requested()) return;
      lock.unlock();
      if (!probe) {
        auto opened = agents::EchoProbe::open(roster_);
        if (!opened) return;
        probe = std::move(*opened);
      }
      probe->measure(kListening);
      Links measured;
      for (const Member& one : roster_->members()) {
        if (const auto link = probe->quality(one.said.name())) measured.emplace(one.said.name(), *link);
      }
      lock.lock();
      links_ = std::move(measured);
      wanted_.wait_for(lock, over, kBetween, [] { return false; });
    }
  }

  std::shared_ptr<agents::Roster> roster_;
  std::mutex mutex_;
  std::condition_variable_any wanted_;
  Clock::time_point asked_ = Clock::now();
  Links links_;
  std::jthread thread_;
};

console::WatchedMachine machine_of(const Member& member) {
  console::WatchedMachine out;
  const wire::AgentPresence& said = member.said;
  out.name = said.name();
  out.host = said.host();
  static_assert(static_cast<int>(Member::State::kGone) ==
                static_cast<int>(console::WatchedMachine::State::kGone));
  out.state = static_cast<console::WatchedMachine::State>(member.state);
  out.heard = std::chrono::duration<double>(Clock::now() - member.heard).count();
  out.robots = said.robots();
  out.runs = said.runs();
  out.load = said.load();
  out.processors = said.processors();
  out.free_memory = said.free_memory();
  out.uptime = said.uptime();
  out.version = said.version();
  out.is_stopped = said.stop().is_engaged();
  out.not_kept = said.not_kept();
  if (const auto rival = agents::rival_of(member)) out.rival_host = rival->host;
  if (said.has_offered()) out.offers = said.offered().name();
  if (said.has_vehicle()) out.vehicle = said.vehicle().kind();
  return out;
}

class FleetMachines final : public console::MachineWatch {
 public:
  FleetMachines(std::shared_ptr<agents::Roster> roster, std::string hint)
      : roster_(std::move(roster)), hint_(std::move(hint)) {}
  std::string fleet() const override { return roster_->fleet(); }
  std::string hint() const override { return hint_; }
  std::vector<console::WatchedMachine> look() override {
    const Links links = links_of_those_there();
    std::vector<console::WatchedMachine> out;
    for (const Member& one : roster_->members()) {
      console::WatchedMachine& machine = out.emplace_back(machine_of(one));
      const auto at = links.find(machine.name);
      if (at == links.end() || one.state != Member::State::kThere) continue;
      const agents::LinkQuality& link = at->second;
      machine.link = {link.round_trip, link.clock_offset, link.lost, agents::is_clock_known(link)};
    }
    return out;
  }

 private:
  // A run without people has no use for that, and begins no thread.
  Links links_of_those_there() {
    const std::scoped_lock lock(mutex_);
    if (!meter_) meter_.emplace(roster_);
    return meter_->links();
  }

  std::shared_ptr<agents::Roster> roster_;
  std::string hint_;
  std::mutex mutex_;
  std::optional<LinkMeter> meter_;
};

}  // namespace

std::shared_ptr<console::MachineWatch> watch_machines(std::shared_ptr<agents::Roster> roster,
                                                      const NetworkOptions& network) {
  std::string hint = nobody_is_there(roster->fleet(), network);
  return std::make_shared<FleetMachines>(std::move(roster), std::move(hint));
}

}  // namespace mlab::cli
