// Robots in processes of their own behind agents of a fleet, over DDS on the loopback: agents are processes
// of their own, too, and serve as `mlab agent` does.
//
//     fleet_bench lock-step [ROBOTS] [AGENTS] [SECONDS]       robot-cycles per second, as a run has them
//     fleet_bench real-time [ROBOTS] [AGENTS] [SECONDS] [HZ]  from percepts to the action that answers them
//     fleet_bench stop [ROBOTS] [AGENTS] [PULLS] [LOST_OF_THOUSAND]  from the emergency stop to `stand`
//     fleet_bench join [AGENTS]                               until who begins with them has found all
//     fleet_bench rest [AGENTS] [SECONDS]                     what a fleet takes that does nothing
//
// With --secure as the last word the fleet is a secured one, and all agents have the same identity.

#include <fcntl.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <fmt/core.h>

#include "mlab/agents/agent_process.h"
#include "mlab/agents/dds_link.h"
#include "mlab/agents/fleet_runner.h"
#include "mlab/agents/stop_switch.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/keys/fleet_keys.h"
#include "mlab/keys/identity.h"
#include "mlab/robot/program/robot_values.h"
#include "mlab/robot/remote/agent.h"
#include "mlab/robot/remote/states.h"
#include "mlab/robot/wire/percepts_wire.h"

namespace mlab {
namespace {

using robot_remote::Clock;

constexpr const char* kVersion = "bench";
constexpr std::uint64_t kSeed = 1;

[[noreturn]] void give_up(const std::string& why) {
  fmt::print(stderr, "fleet_bench: {}\n", why);
  std::exit(1);
}

double seconds(Clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

std::string fleet_name() {
  return "bench-" + std::to_string(::getpid());
}

/// The keys of a secured fleet, in a folder that goes with this.
class Keys {
 public:
  Keys() {
    auto all = keys::FleetKeys::open(folder_, fleet_name());
    if (!all) give_up(all.error());
    if (const auto own = all->add(keys::kOwnIdentity); !own) give_up(own.error());
  }
  Keys(const Keys&) = delete;
  Keys& operator=(const Keys&) = delete;
  ~Keys() {
    std::error_code failure;
    std::filesystem::remove_all(folder_, failure);
  }
  std::string identity() const { return folder_ / keys::kOwnIdentity; }

 private:
  std::filesystem::path folder_ = std::filesystem::temp_directory_path() / ("mlab-" + fleet_name());
};

/// Those that main has made; null: the fleet is not secured.
const Keys* keys_in_use = nullptr;

robot::ProgramSources sources() {
  robot::ProgramSources out;
  out.permission = cell::testing::code_permitted();
  out.version = kVersion;
  return out;
}

robot::RobotProgram standard_robot() {
  text::Diagnostics sink;
  auto out = robot::load_program("robot", {}, {}, sources(), {}, sink);
  if (!out) give_up(text::render(sink));
  return std::move(*out);
}

percept::Percepts on_its_way(double time) {
  percept::Percepts out;
  out.time = time;
  out.cycle_duration = 0.1;
  out.order.sequence = 1;
  out.order.task = percept::Task::kMoveTo;
  out.order.goal = {4000.0, 3000.0};
  return out;
}

dds::Network network_of(const std::string& fleet, int lost_of_thousand, const std::string& identity) {
  dds::Network out{.fleet = fleet, .interface_name = {}, .peers = {}, .lost_of_thousand = lost_of_thousand};
  if (!identity.empty()) out.security = keys::security_in(identity);
  return out;
}

double processor_time_of(pid_t process) {
  std::ifstream about(fmt::format("/proc/{}/stat", process));
  std::string word;
  for (int i = 0; i < 13; ++i) about >> word;
  double user = 0;
  double system = 0;
  about >> user >> system;
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

/// What a process does that a fleet has started: an agent until nobody holds the other end of its input.
/// @param words  agent NAME FLEET LOST_OF_THOUSAND [IDENTITY]
int be_agent(const std::vector<std::string>& words) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  agents::AgentSettings settings;
  settings.name = words.at(1);
  settings.network =
      network_of(words.at(2), std::atoi(words.at(3).c_str()), words.size() > 4 ? words[4] : "");
  settings.sources = sources();
  settings.log = std::make_shared<agents::AgentLog>(nullptr);
  std::stop_source stop;
  std::jthread ends([&] {
    char nothing = 0;
    while (::read(STDIN_FILENO, &nothing, 1) > 0) {
    }
    stop.request_stop();
  });
  const auto problem = agents::serve_as_agent(settings, stop.get_token());
  if (problem) give_up(*problem);
  return 0;
}

/// Agents in processes of their own, and who talks to them.
class Fleet {
 public:
  Fleet(std::size_t agents, int lost_of_thousand) {
    const std::string identity = keys_in_use != nullptr ? keys_in_use->identity() : "";
    const dds::Network network = network_of(fleet_name(), lost_of_thousand, identity);
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0) give_up("no pipe");
    for (std::size_t i = 0; i < agents; ++i)
      start({"fleet_bench", "agent", fmt::format("a{}", i), network.fleet, std::to_string(lost_of_thousand),
             identity});
    auto roster = agents::Roster::join(network);
    if (!roster) give_up(roster.error());
    roster_ = std::move(*roster);
    const auto are_there = [&](const std::vector<agents::Member>& members) {
      return members.size() == agents;
    };
    if (!roster_->wait(are_there, Clock::now() + std::chrono::seconds(60)))
      give_up("not all agents were found");
  }
  Fleet(const Fleet&) = delete;
  Fleet& operator=(const Fleet&) = delete;
  ~Fleet() {
    for (const int end : ends_) ::close(end);
    for (const pid_t agent : agents_) ::waitpid(agent, nullptr, 0);
  }
  const std::shared_ptr<agents::Roster>& roster() const { return roster_; }
  /// Waits until agents and this process have told each other all that there is to tell once somebody is
  /// found: as long as they are busy with it.
  void settle() const {
    constexpr auto kGlance = std::chrono::milliseconds(250);
    constexpr double kMost = 0.4;  // of one processor; fifty that rest take half of that
    double before = processor_time();
    for (int quiet = 0; quiet < 2;) {
      std::this_thread::sleep_for(kGlance);
      const double now = processor_time();
      quiet = now - before < kMost * seconds(kGlance) ? quiet + 1 : 0;
      before = now;
    }
  }
  /// Of all agents and of this process, as far as it has been counted [s].
  double processor_time() const {
    double out = processor_time_of(::getpid());
    for (const pid_t agent : agents_) out += processor_time_of(agent);
    return out;
  }

 private:
  void start(std::vector<std::string> words) {
    if (words.back().empty()) words.pop_back();
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions{};
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, ends_[0], STDIN_FILENO);
    pid_t agent = 0;
    if (::posix_spawn(&agent, "/proc/self/exe", &actions, nullptr, arguments.data(), environ) != 0)
      give_up("an agent can't be started");
    ::posix_spawn_file_actions_destroy(&actions);
    agents_.push_back(agent);
  }

  std::array<int, 2> ends_{};  // the agents' input, and its other end
  std::shared_ptr<agents::Roster> roster_;
  std::vector<pid_t> agents_;
};

void print_times(const char* what, std::vector<double>& times) {
  if (times.empty()) give_up("nothing was measured");
  std::ranges::sort(times);
  const auto at = [&](double share) {
    return 1e3 * times[std::min(times.size() - 1,
                                static_cast<std::size_t>(share * static_cast<double>(times.size())))];
  };
  fmt::print("{}: {} times, median {:.2f} ms, 99 % {:.2f} ms, 99.99 % {:.2f} ms, worst {:.2f} ms\n", what,
             times.size(), at(0.5), at(0.99), at(0.9999), 1e3 * times.back());
}

void lock_step(std::size_t robots, std::size_t agents, double duration) {
  const Fleet fleet(agents, 0);
  fleet.settle();
  const auto runner = agents::make_fleet_runner(fleet.roster(), kSeed, kVersion, 0.0);
  const robot::RobotProgram program = standard_robot();
  struct Robot {
    robot::ProgramRunner::Member member = 0;
    percept::Percepts percepts;
    percept::Action action;
    std::string fault;
    std::string failure;
  };
  std::vector<Robot> all(robots);
  for (std::size_t i = 0; i < robots; ++i) {
    all[i].member = runner->add({static_cast<std::uint32_t>(i + 1)}, program);
    if (const auto problem = runner->start(all[i].member)) give_up(*problem);
  }
  std::uint64_t cycles = 0;
  auto began = Clock::now();
  while (cycles == 0 || seconds(Clock::now() - began) < duration) {
    // Before the first one robots have no processes yet.
    if (cycles == 1) began = Clock::now();
    for (const Robot& one : all) runner->join(one.member);
    runner->open();
    percept::Needs needs;
    for (Robot& one : all) {
      runner->needs({&one.member, 1}, {&needs, 1});
      one.percepts = on_its_way(0.1 * static_cast<double>(cycles));
      const robot::ProgramRunner::Turn turn{one.member, &one.percepts, &one.action, &one.fault, &one.failure};
      runner->act({&turn, 1});
    }
    runner->ask();
    runner->wait({});
    ++cycles;
    for (const Robot& one : all) {
      if (!one.failure.empty() || !one.action.drives) give_up("a robot does not act: " + one.failure);
    }
  }
  const double took = seconds(Clock::now() - began);
  fmt::print("lock-step: {} robots behind {} agents: {:.0f} robot-cycles per second\n", robots, agents,
             static_cast<double>((cycles - 1) * robots) / took);
}

/// Robots of one agent in real time, by the messages that pass.
class LiveRobots {
 public:
  LiveRobots(const Fleet& fleet, std::size_t agent, std::size_t robots, const robot::RobotProgram& program,
             double period) {
    const auto member = fleet.roster()->find(fmt::format("a{}", agent));
    auto link = agents::DdsLink::open(fleet.roster(), *member, true);
    if (!link) give_up(link.error());
    agent_ = std::make_unique<robot_remote::Agent>(member->said.name(), std::move(*link));
    if (const auto problem = agent_->open(kSeed, kVersion, period)) give_up(*problem);
    const auto brought = agent_->bring(program);
    if (!brought) give_up(brought.error());
    for (std::uint32_t i = 1; i <= robots; ++i) {
      const base::RobotId id{static_cast<std::uint32_t>(agent * 1000 + i)};
      wire::ToAgent message;
      message.mutable_enlist()->set_member(i);
      message.mutable_enlist()->set_robot(id.value);
      message.mutable_enlist()->set_program(*brought);
      ask(message);
      robot::RobotValues values(id, program);
      values.start();
      wire::Put& put = *message.mutable_put();
      put.set_member(i);
      put.set_begins(true);
      robot_remote::encode(values.saved().data(), values.saved().size(), nullptr, *put.mutable_state());
      ask(message);
    }
    count_ = robots;
  }

  void sense(std::uint64_t cycle, double time) {
    for (std::uint32_t i = 1; i <= count_; ++i) {
      message_.Clear();
      message_.set_cycle(cycle);
      message_.set_sent(robot_remote::nanoseconds_of(Clock::now()));
      robot_wire::encode(on_its_way(time), *message_.mutable_percepts());
      agent_->live()->send(std::to_string(i), message_.SerializeAsString());
    }
  }
  struct Heard {
    std::string robot;
    bool drives = false;
    std::uint64_t cycle = 0;
    double taken = 0.0;  // since its percepts were sent [s]
    Clock::time_point arrived;
  };
  std::vector<Heard> hear(Clock::time_point deadline) {
    std::vector<Heard> out;
    for (const robot_remote::LiveLine::Message& message : agent_->live()->receive(deadline)) {
      wire::LiveAction action;
      if (!action.ParseFromString(message.body) || !action.action().failure().empty())
        give_up("a robot does not act: " + action.action().failure());
      const double taken =
          1e-9 * static_cast<double>(robot_remote::nanoseconds_of(message.arrived) - action.sent());
      out.push_back({message.key, action.action().action().drives(), action.cycle(), taken, message.arrived});
    }
    return out;
  }
  std::size_t count() const { return count_; }

 private:
  void ask(wire::ToAgent& message) {
    const auto answer = agent_->ask(message, wire::FromAgent::kDone);
    if (!answer) give_up(answer.error());
    if (!(*answer)->done().problem().empty()) give_up((*answer)->done().problem());
    message.Clear();
  }
  std::unique_ptr<robot_remote::Agent> agent_;
  std::size_t count_ = 0;
  wire::LivePercepts message_;
};

/// All of them, each agent's by a thread that hears what they do.
class LiveFleet {
 public:
  using Hear = std::function<void(std::size_t agent, const LiveRobots::Heard& heard)>;
  LiveFleet(const Fleet& fleet, std::size_t robots, std::size_t agents, double period, Hear hear)
      : period_(period) {
    const robot::RobotProgram program = standard_robot();
    for (std::size_t i = 0; i < agents; ++i) {
      const std::size_t count = robots / agents + (i < robots % agents ? 1 : 0);
      agents_.push_back(std::make_unique<LiveRobots>(fleet, i, count, program, period));
    }
    for (std::size_t i = 0; i < agents; ++i) {
      ears_.emplace_back([this, i, hear](const std::stop_token& stop) {
        while (!stop.stop_requested()) {
          for (const auto& heard : agents_[i]->hear(Clock::now() + std::chrono::milliseconds(50)))
            hear(i, heard);
        }
      });
    }
    world_ = std::jthread([this](const std::stop_token& stop) {
      auto next = Clock::now();
      while (!stop.stop_requested()) {
        ++cycle_;
        for (const auto& one : agents_) one->sense(cycle_, period_ * static_cast<double>(cycle_));
        next += robot_remote::from_seconds(period_);
        std::this_thread::sleep_until(next);
      }
    });
  }
  std::uint64_t cycle() const { return cycle_.load(); }

 private:
  double period_;
  std::atomic<std::uint64_t> cycle_ = 0;
  std::vector<std::unique_ptr<LiveRobots>> agents_;
  std::vector<std::jthread> ears_;
  std::jthread world_;
};

void real_time(std::size_t robots, std::size_t agents, double duration, double rate) {
  const Fleet fleet(agents, 0);
  std::mutex mutex;
  std::vector<double> times;
  std::uint64_t driving = 0;
  std::uint64_t cycles = 0;
  {
    const LiveFleet all(fleet, robots, agents, 1.0 / rate, [&](std::size_t /*agent*/, const auto& heard) {
      if (heard.cycle == 0) return;
      const std::scoped_lock lock(mutex);
      times.push_back(heard.taken);
      driving += heard.drives ? 1 : 0;
    });
    std::this_thread::sleep_for(std::chrono::seconds(2));
    std::uint64_t first = 0;
    {
      const std::scoped_lock lock(mutex);
      times.clear();
      driving = 0;
      first = all.cycle();
    }
    std::this_thread::sleep_for(std::chrono::duration<double>(duration));
    const std::scoped_lock lock(mutex);
    cycles = all.cycle() - first;
  }
  fmt::print(
      "real time: {} robots behind {} agents at {} Hz: {:.1f} % of {} robot-cycles answered, {:.1f} % "
      "drive\n",
      robots, agents, rate, 100.0 * static_cast<double>(times.size()) / static_cast<double>(cycles * robots),
      cycles * robots, 100.0 * static_cast<double>(driving) / static_cast<double>(times.size()));
  print_times("percepts to action", times);
}

void stop(std::size_t robots, std::size_t agents, int pulls, int lost_of_thousand) {
  const Fleet fleet(agents, lost_of_thousand);
  auto opened = agents::StopSwitch::open(fleet.roster());
  if (!opened) give_up(opened.error());
  agents::StopSwitch& all_stop = **opened;
  std::mutex mutex;
  std::vector<double> times;
  Clock::time_point pulled;
  bool is_pulled = false;
  std::map<std::pair<std::size_t, std::string>, bool> stands;
  const LiveFleet all(fleet, robots, agents, 0.1, [&](std::size_t agent, const auto& heard) {
    const std::scoped_lock lock(mutex);
    bool& stood = stands[{agent, heard.robot}];
    if (is_pulled && !heard.drives && !stood && heard.arrived >= pulled)
      times.push_back(seconds(heard.arrived - pulled));
    stood = !heard.drives;
  });
  const auto all_of = [&](bool standing) {
    const auto last = Clock::now() + std::chrono::seconds(20);
    for (;;) {
      {
        const std::scoped_lock lock(mutex);
        if (stands.size() == robots &&
            std::ranges::all_of(stands, [&](const auto& one) { return one.second == standing; }))
          return;
      }
      if (Clock::now() > last) give_up(standing ? "a robot does not stand" : "a robot does not drive");
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  };
  std::mt19937 random(kSeed);
  for (int i = 0; i < pulls; ++i) {
    all_of(false);
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 100'000));
    {
      const std::scoped_lock lock(mutex);
      pulled = Clock::now();
      is_pulled = true;
    }
    all_stop.engage("bench");
    all_of(true);
    {
      const std::scoped_lock lock(mutex);
      is_pulled = false;
    }
    all_stop.release("bench");
  }
  fmt::print("emergency stop: {} robots behind {} agents, {} of 1000 packets lost\n", robots, agents,
             lost_of_thousand);
  print_times("pull to stand, as heard", times);
}

void join(std::size_t agents) {
  const auto began = Clock::now();
  const Fleet fleet(agents, 0);
  fmt::print("join: {} agents found within {:.2f} s of their start, {:.2f} s of processor time\n", agents,
             seconds(Clock::now() - began), fleet.processor_time());
  fleet.settle();
  fmt::print("join: at rest after {:.2f} s, {:.2f} s of processor time\n", seconds(Clock::now() - began),
             fleet.processor_time());
}

void rest(std::size_t agents, double duration) {
  const Fleet fleet(agents, 0);
  std::this_thread::sleep_for(std::chrono::seconds(3));
  const double before = fleet.processor_time();
  std::this_thread::sleep_for(std::chrono::duration<double>(duration));
  fmt::print("rest: {} agents take {:.1f} % of a processor\n", agents,
             100.0 * (fleet.processor_time() - before) / duration);
}

}  // namespace
}  // namespace mlab

int main(int argc, char** argv) {
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() > 3 && words[0] == "agent") return mlab::be_agent(words);
  std::optional<mlab::Keys> keys;
  if (!words.empty() && words.back() == "--secure") {
    mlab::keys_in_use = &keys.emplace();
    words.pop_back();
  }
  const auto number = [&](std::size_t place, double otherwise) {
    return words.size() > place ? std::strtod(words[place].c_str(), nullptr) : otherwise;
  };
  const auto count = [&](std::size_t place, double otherwise) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(number(place, otherwise)));
  };
  const std::string what = words.empty() ? "" : words[0];
  if (what == "lock-step")
    mlab::lock_step(count(1, 50), count(2, 1), number(3, 10));
  else if (what == "real-time")
    mlab::real_time(count(1, 200), count(2, 4), number(3, 20), number(4, 10));
  else if (what == "stop")
    mlab::stop(count(1, 50), count(2, 5), static_cast<int>(count(3, 100)), static_cast<int>(number(4, 0)));
  else if (what == "join")
    mlab::join(count(1, 50));
  else if (what == "rest")
    mlab::rest(count(1, 50), number(2, 10));
  else {
    fmt::print(
        stderr,
        "fleet_bench lock-step|real-time|stop|join|rest [NUMBERS] [--secure]: see bench/fleet_bench.cc\n");
    return 2;
  }
  return 0;
}
