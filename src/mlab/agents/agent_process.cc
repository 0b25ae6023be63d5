#include "mlab/agents/agent_process.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/agents/conversation.h"
#include "mlab/agents/dds_live_line.h"
#include "mlab/agents/echo.h"
#include "mlab/agents/missed.h"
#include "mlab/agents/name_claim.h"
#include "mlab/agents/roster.h"
#include "mlab/agents/seniority.h"
#include "mlab/agents/siblings.h"
#include "mlab/agents/signs_of_life.h"
#include "mlab/agents/stop_state.h"
#include "mlab/agents/topics.h"
#include "mlab/robot/remote/agent.h"
#include "mlab/robot/wire/arithmetic.h"
#include "mlab/robot/wire/shared_cycle.h"
#include "mlab/text/member_name.h"
#include "mlab/text/shown.h"

namespace mlab::agents {
namespace {

constexpr std::chrono::milliseconds kBeat(500);         // between two looks at the others
constexpr std::chrono::milliseconds kPresence(2000);    // between two words that it is there
constexpr std::chrono::milliseconds kNameGlance(1500);  // in which somebody of the same name is found
constexpr std::size_t kMostConversations = 64;

// What programs could have without anything being swapped out [bytes]; 0: nobody says.
std::uint64_t available_memory() {
  std::ifstream about("/proc/meminfo");
  std::uint64_t kilobytes = 0;
  for (std::string word; about >> word;) {
    if (word == "MemAvailable:" && about >> kilobytes) return kilobytes << 10;
  }
  return 0;
}

std::string counted_robots(std::size_t count) {
  return fmt::format("{} robot{}", count, count == 1 ? "" : "s");
}

std::string name_is_taken(const AgentSettings& settings, const std::string& host) {
  return fmt::format("the fleet `{}` has an agent `{}` already, on `{}`: --name says another name",
                     settings.network.fleet, settings.name, host);
}

class AgentProcess {
 public:
  AgentProcess(const AgentSettings& settings, std::optional<robot::ExecutableOrigin> executable,
               std::shared_ptr<Roster> roster, dds::Waiter waiter, dds::Reader requests, dds::Reader stops,
               EchoAnswerer echoes, dds::Writer presence, std::unique_ptr<SignsOfLife> life)
      : settings_(settings),
        executable_(std::move(executable)),
        roster_(std::move(roster)),
        waiter_(std::move(waiter)),
        requests_(std::move(requests)),
        stops_(std::move(stops)),
        echoes_(std::move(echoes)),
        presence_(std::move(presence)),
        life_(std::move(life)),
        missed_(roster_->participant(), "agent " + settings.name) {}

  /// @errors  a sentence: the vehicle can't be offered
  std::optional<std::string> board() {
    if (!settings_.vehicle) return std::nullopt;
    auto begun = settings_.vehicle->begin(roster_->participant(), [this] { return has_to_stand(); });
    if (!begun) return begun.error();
    vehicle_ = std::move(*begun);
    return std::nullopt;
  }

  /// @errors  a sentence: it can't stay
  std::optional<std::string> serve(const std::stop_token& stop) {
    // By the thread that wants the end: this one may be held up in the network's library.
    const std::stop_callback ends(stop, [this] {
      end_robots();
      waiter_.wake();
    });
    life_->begin();
    Clock::time_point next_beat = Clock::now();
    if (const auto why = stop_file_.why_not_kept())
      settings_.log->add(fmt::format("warning: an emergency stop will not outlive this agent: {}", *why));
    if (stop_.is_engaged()) {
      settings_.log->add(
          fmt::format("EMERGENCY STOP by {}: it still holds, all robots here stand", stop_.by()));
      // One that could not be read is to have the same identity for all, also for the siblings.
      keep();
    }
    std::optional<std::string> problem;
    while (!stop.stop_requested() && !problem) {
      if (Clock::now() >= next_beat) {
        if (Clock::now() >= next_presence_ || has_other_robots()) say_presence();
        problem = give_way();
        hear_of_stop_from_others();
        tell_whom_it_misses();
        forget_what_all_have_released();
        if (!not_kept_.empty()) keep_again();
        next_beat = Clock::now() + kBeat;
      }
      waiter_.wait(std::chrono::ceil<std::chrono::milliseconds>(
          std::max<Clock::duration>(next_beat - Clock::now(), std::chrono::milliseconds(1))));
      listen_for_stop();
      echoes_.answer();
      for (const dds::Arrival& arrival : requests_.take()) take(arrival);
      greet_the_new();
      give_up_the_lost();
      forget_the_ended();
    }
    end_robots();
    vehicle_.reset();
    life_.reset();
    static_cast<void>(presence_.end(settings_.name));
    conversations_.clear();
    return problem;
  }

 private:
  // By any thread.
  void end_robots() {
    const std::scoped_lock lock(conversations_mutex_);
    for (auto& [key, conversation] : conversations_) conversation->end();
  }

  // Asked by any thread.
  bool has_to_stand() const { return is_stopped_ || (settings_.must_stand && settings_.must_stand()); }

  /// A run may begin many conversations, and another one the same.
  using Key = std::pair<dds::Guid, std::string>;

  void take(const dds::Arrival& arrival) {
    using Kind = dds::Arrival::Kind;
    if (arrival.kind == Kind::kUnmatched) {
      end_all_of(arrival.sender);
    } else if (arrival.kind == Kind::kMessage) {
      const Key key{arrival.sender, arrival.key};
      auto at = conversations_.find(key);
      if (at == conversations_.end()) {
        if (!is_conversation(arrival.key) || conversations_.size() >= kMostConversations) return;
        auto begun = begin(key);
        if (!begun) return;
        const std::scoped_lock lock(conversations_mutex_);
        at = conversations_.emplace(key, std::move(begun)).first;
      }
      if (!at->second->add(arrival.body)) at->second->end();
    } else if (arrival.kind == Kind::kLost) {
      // Nobody can say what is missing in which of them.
      settings_.log->add("more has arrived than could be kept: all runs have lost their robots here");
      for (auto& [key, conversation] : conversations_) conversation->end();
    }
  }

  std::unique_ptr<Conversation> begin(const Key& key) {
    auto answers = roster_->participant().writer(answers_topic(settings_.name, key.second),
                                                 dds::ChannelKind::kLockStepPercepts);
    if (!answers) return nullptr;
    auto waiter = dds::Waiter::make();
    if (!waiter) return nullptr;
    dds::Reader::Branch branch = requests_.branch(key.first, key.second, *waiter);
    const auto writer = std::make_shared<dds::Writer>(std::move(*answers));
    return std::make_unique<Conversation>(
        robot_remote::AgentTerms{settings_.sources, settings_.offered, settings_.vehicle.has_value(),
                                 [this] { return has_to_stand(); },
                                 [this] { return settings_.log->lines(); }},
        std::move(*waiter), std::move(branch),
        [writer, key, is_met = false](std::string_view message,
                                      const std::function<bool()>& is_awaited) mutable {
          if (!is_met) is_met = meet(*writer, key.first, is_awaited);
          const Clock::time_point last = Clock::now() + 2 * kMeetingPatience;
          return is_met && write_in_parts(*writer, key.second, message,
                                          [&] { return is_awaited() && Clock::now() < last; });
        },
        [this, key]() -> std::shared_ptr<robot_remote::LiveLine> {
          auto live = open_live_line_of_agent(roster_->participant(), settings_.name, key.second, key.first);
          return live && (*live)->meet(Clock::now() + kMeetingPatience) ? *live : nullptr;
        });
  }

  // What is written before the run hears it would be lost.
  static bool meet(const dds::Writer& answers, const dds::Guid& run,
                   const std::function<bool()>& is_awaited) {
    const Clock::time_point last = Clock::now() + kMeetingPatience;
    while (is_awaited() && Clock::now() < last) {
      const std::vector<dds::Guid> readers = answers.readers();
      if (std::ranges::find(readers, run) != readers.end()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return false;
  }

  void end_all_of(const dds::Guid& run) {
    std::size_t robots = 0;
    std::size_t count = 0;
    greet_the_new();
    for (auto& [key, conversation] : conversations_) {
      // In real time a run says that it leaves; one that can't be heard may come back.
      if (key.first != run || conversation->is_live()) continue;
      robots += conversation->robot_count();
      if (parts_from(key)) ++count;
      conversation->end();
    }
    if (count > 0) settings_.log->add(fmt::format("a run has gone, and {} with it", counted_robots(robots)));
  }

  // Not who only asks something.
  void greet_the_new() {
    for (auto& [key, conversation] : conversations_) {
      if (conversation->has_opened() && greeted_.insert(key).second)
        settings_.log->add("a run has begun to talk to this agent");
    }
  }

  // True: that it has gone is to be told.
  bool parts_from(const Key& key) { return greeted_.contains(key) && parted_.insert(key).second; }

  void forget_the_ended() {
    for (const auto& [key, one] : conversations_) {
      if (one->has_ended() && parts_from(key))
        settings_.log->add(fmt::format("a run has gone, and {} with it", counted_robots(one->robot_count())));
    }
    std::vector<std::unique_ptr<Conversation>> ended;  // which may take a while
    {
      const std::scoped_lock lock(conversations_mutex_);
      for (auto& [key, one] : conversations_) {
        if (one->has_ended()) ended.push_back(std::move(one));
      }
      std::erase_if(conversations_, [](const auto& one) { return one.second == nullptr; });
    }
    const auto is_over = [this](const Key& key) { return !conversations_.contains(key); };
    std::erase_if(greeted_, is_over);
    std::erase_if(parted_, is_over);
  }

  void listen_for_stop() {
    for (const dds::Arrival& arrival : stops_.take()) {
      if (arrival.kind == dds::Arrival::Kind::kMessage) heed(decode(arrival.body));
    }
  }

  // Who was cut off when it was pulled hears of it here.
  void hear_of_stop_from_others() {
    for (const Member& one : roster_->members()) {
      if (one.state != Member::State::kGone) heed(decode(one.said.stop()));
    }
    for (const Sibling& one : siblings_.look()) {
      if (one.is_there && one.stop.number > 0) heed(one.stop);
    }
  }

  // One of this machine that is there can be reached by whoever pulls the stop, and confirms it.
  void tell_whom_it_misses() {
    std::vector<Member> others = roster_->members();
    std::erase_if(others, [&](const Member& one) { return one.said.name() == settings_.name; });
    for (const Sibling& one : siblings_.all()) {
      if (one.is_there) continue;
      Member& member = others.emplace_back();
      member.said.set_name(one.name);
      member.said.set_host(machine_name());
      member.state = Member::State::kSilent;
      member.heard = one.heard;
    }
    missed_.say(missed_among(std::move(others), stop_, Clock::now()));
  }

  void heed(const std::optional<StopState>& state) {
    if (!state) return;
    const bool was_stopped = stop_.is_engaged();
    const Learnt learnt = stop_.learn(*state);
    if (learnt == Learnt::kNothing) return;
    is_stopped_ = stop_.is_engaged();
    for (auto& [key, conversation] : conversations_) conversation->look_at_stop();
    keep();
    say_presence();
    tell_whom_it_misses();
    if (settings_.tell_stop) settings_.tell_stop();
    if (learnt == Learnt::kStop)
      settings_.log->add(fmt::format("EMERGENCY STOP by {}: all robots here stand", stop_.by()));
    else if (was_stopped && !stop_.is_engaged())
      settings_.log->add(fmt::format("the emergency stop was released by {}", stop_.by()));
  }

  void keep() {
    const bool was_kept = not_kept_.empty();
    const auto problem = stop_file_.write(stop_);
    not_kept_ = problem && stop_.is_engaged() ? *problem : "";
    if (!not_kept_.empty())
      settings_.log->add(fmt::format("the emergency stop will not outlive this agent: {}", not_kept_));
    else if (problem && was_kept && stop_file_.read().is_engaged())
      settings_.log->add(fmt::format(
          "the release of the emergency stop can't be kept: {}; it holds again when this agent is started "
          "again",
          *problem));
  }

  // There may be room by now.
  void keep_again() {
    if (stop_file_.write(stop_)) return;
    not_kept_.clear();
    settings_.log->add("the emergency stop is kept from now on: it outlives this agent");
    say_presence();
  }

  // Who has not heard of the release holds the stop still; it is kept as long as there may be somebody.
  void forget_what_all_have_released() {
    if (stop_.is_engaged()) return;
    const Clock::time_point now = Clock::now();
    const auto may_hold_it = [&](const Member& one) {
      const bool is_forgotten = one.state == Member::State::kGone && now - one.heard >= kMissedFor;
      return !one.has_left && !is_forgotten && !has_confirmed(one.said.stop(), stop_);
    };
    const auto holds_it = [&](const Sibling& one) {
      return one.stop.is_engaged() && (one.is_there || now - one.heard < kMissedFor);
    };
    if (std::ranges::any_of(roster_->members(), may_hold_it) ||
        std::ranges::any_of(siblings_.all(), holds_it)) {
      // A sibling learns of the release from the file, also one that has heard of an old stop just now.
      if (!stop_file_.is_there()) static_cast<void>(stop_file_.write(stop_));
    } else {
      stop_file_.remove();
    }
  }

  // Two that began at the same moment, or on networks that are one now, have not heard each other before: one
  // of a name is left, and both know which one.
  std::optional<std::string> give_way() {
    const auto rival = roster_->rival_of_mine(settings_.name);
    if (!rival) return std::nullopt;
    const Clock::time_point now = Clock::now();
    const Claimant own{roster_->participant().guid(), robot_remote::in_seconds(now - began_)};
    if (!keeps_name(own, {rival->guid, rival->uptime + robot_remote::in_seconds(now - rival->heard)}))
      return name_is_taken(settings_, rival->host);
    if (std::exchange(told_rival_, rival->guid) != rival->guid)
      settings_.log->add(fmt::format(
          "another agent that is called `{}`, too, is there, on `{}`: this one keeps the name, and "
          "that one has to end",
          settings_.name, rival->host));
    return std::nullopt;
  }

  void give_up_the_lost() {
    for (auto& [key, conversation] : conversations_) {
      if (!conversation->is_live() || conversation->has_ended()) continue;
      if (Clock::now() - conversation->heard() < robot_remote::from_seconds(robot_remote::kLivePatience))
        continue;
      settings_.log->add(fmt::format("nothing was heard of a run for {:.0f} s, and {} end with it",
                                     robot_remote::kLivePatience,
                                     counted_robots(conversation->robot_count())));
      parted_.insert(key);
      conversation->end();
    }
  }

  struct Load {
    std::uint32_t robots = 0;
    std::uint32_t runs = 0;
    friend bool operator==(const Load&, const Load&) = default;
  };
  Load load() const {
    Load out;
    for (const auto& [key, conversation] : conversations_) {
      out.robots += static_cast<std::uint32_t>(conversation->robot_count());
      if (conversation->has_opened()) ++out.runs;
    }
    if (vehicle_) out.robots = out.runs = static_cast<std::uint32_t>(vehicle_->robot_count());
    return out;
  }
  bool has_other_robots() const { return load() != said_load_; }

  void say_presence() {
    wire::AgentPresence said;
    encode(stop_, *said.mutable_stop());
    said.set_not_kept(not_kept_);
    said.set_protocol(robot_remote::kAgentProtocol);
    said.set_version(settings_.sources.version);
    said.set_layout(robot_wire::shared_layout());
    said.set_arithmetic(robot_wire::arithmetic());
    said.set_name(settings_.name);
    said.set_host(machine_name());
    said.set_process(static_cast<std::uint32_t>(::getpid()));
    said.set_processors(std::max(1U, std::thread::hardware_concurrency()));
    double average = 0.0;
    if (::getloadavg(&average, 1) == 1) said.set_load(average);
    said.set_free_memory(available_memory());
    said.set_uptime(std::chrono::duration<double>(Clock::now() - began_).count());
    said_load_ = load();
    said.set_robots(said_load_.robots);
    said.set_runs(said_load_.runs);
    next_presence_ = Clock::now() + kPresence;
    if (settings_.vehicle) *said.mutable_vehicle() = settings_.vehicle->said;
    if (executable_) {
      said.mutable_offered()->set_name(executable_->name);
      said.mutable_offered()->set_source(executable_->source);
    }
    // One that nobody takes is followed by the next.
    static_cast<void>(presence_.write(settings_.name, said.SerializeAsString()));
  }

  const AgentSettings& settings_;
  std::optional<robot::ExecutableOrigin> executable_;
  std::shared_ptr<Roster> roster_;  // keeps the participant
  dds::Waiter waiter_;
  dds::Reader requests_;
  dds::Reader stops_;
  EchoAnswerer echoes_;
  dds::Writer presence_;
  std::unique_ptr<SignsOfLife> life_;
  MissedTeller missed_;
  StopFile stop_file_{settings_.stop_file};
  Siblings siblings_{settings_.stop_file, company_of(settings_.network)};
  StopState stop_ = stop_file_.read();
  std::atomic<bool> is_stopped_ = stop_.is_engaged();
  std::string not_kept_;  // why the stop that holds would be forgotten in a restart; empty: it would not be
  Clock::time_point began_ = Clock::now();
  Clock::time_point next_presence_;
  Load said_load_;
  std::mutex conversations_mutex_;  // for who changes which there are, and for others than the agent's thread
  std::map<Key, std::unique_ptr<Conversation>> conversations_;
  std::optional<dds::Guid> told_rival_;  // somebody of the same name who has been told of
  std::set<Key> greeted_;                // whose beginning was told
  std::set<Key> parted_;                 // and whose end
  std::unique_ptr<Companion> vehicle_;   // null: it is no vehicle's
};

}  // namespace

std::string machine_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? std::string(name.data()) : std::string();
}

std::optional<std::string> serve_as_agent(const AgentSettings& settings, const std::stop_token& stop) {
  if (!is_agent_name(settings.name))
    return fmt::format("`{}` can't be the name of an agent: {}", text::shown(settings.name),
                       text::kMemberNameRule);
  std::optional<robot::ExecutableOrigin> executable;
  if (!settings.offered.empty()) {
    auto program = robot::load_offered(settings.offered, settings.sources);
    if (!program) return fmt::format("`{}` {}", text::shown(settings.offered), program.error());
    executable = std::move(program->executable);
  }
  // Those of this machine are siblings.h's.
  dds::Network network = settings.network;
  network.avoids_neighbours = true;
  const NameClaim name(settings.network.fleet, settings.name);
  if (name.is_taken()) return name_is_taken(settings, machine_name());
  auto roster = Roster::join(network, Watch::kLoosely);
  if (!roster) return roster.error();
  // All before others have found this one: they learn of it at once, and in one go.
  auto waiter = dds::Waiter::make();
  if (!waiter) return waiter.error();
  dds::Participant& participant = (*roster)->participant();
  auto requests = participant.reader(requests_topic(settings.name, participant.guid()),
                                     dds::ChannelKind::kLockStepPercepts, *waiter);
  if (!requests) return requests.error();
  auto stops = participant.reader(kStopTopic, dds::ChannelKind::kEmergencyStop, *waiter);
  if (!stops) return stops.error();
  auto echoes = EchoAnswerer::open(participant, *waiter, settings.name);
  if (!echoes) return echoes.error();
  auto presence = participant.writer(kPresenceTopic, dds::ChannelKind::kPresence);
  if (!presence) return presence.error();
  auto life = SignsOfLife::open(participant, network, settings.name);
  if (!life) return life.error();
  const auto is_taken = [&](const std::vector<Member>& members) {
    return std::ranges::any_of(members, [&](const Member& one) {
      return one.said.name() == settings.name && one.state != Member::State::kGone;
    });
  };
  if ((*roster)->wait(is_taken, Clock::now() + kNameGlance))
    return name_is_taken(settings, (*roster)->find(settings.name)->said.host());
  AgentProcess process(settings, std::move(executable), std::move(*roster), std::move(*waiter),
                       std::move(*requests), std::move(*stops), std::move(*echoes), std::move(*presence),
                       std::move(*life));
  if (auto problem = process.board()) return problem;
  if (settings.tell_ready) settings.tell_ready();
  return process.serve(stop);
}

}  // namespace mlab::agents
