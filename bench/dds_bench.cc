// Two participants on the loopback, as a console and an agent: for each robot percepts of 500 bytes out on a
// topic of its own, and an action of 200 bytes back on one that all share. Prints round trips per second with
// all robots under way at once, as in lock-step, and how long one takes while nothing else is.
//
//     dds_bench [SECONDS] [LOST_OF_THOUSAND]

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>
#include <vector>

#include <fmt/core.h>

#include "mlab/dds/participant.h"

namespace mlab::dds {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr std::size_t kPerceptBytes = 500;
constexpr std::size_t kActionBytes = 200;

template <class Value>
Value need(std::expected<Value, std::string> value) {
  if (value) return std::move(*value);
  fmt::print(stderr, "dds_bench: {}\n", value.error());
  ::_exit(1);
}

std::string topic_of(std::size_t robot) {
  return fmt::format("veh-{}/percepts", robot);
}

bool send(Writer& writer, const std::string& key, const std::string& body) {
  Written how = Written::kFull;
  while (how == Written::kFull) how = writer.write(key, body);
  return how == Written::kDone;
}

/// The agent: answers whatever comes.
void answer(const Network& network, std::size_t robots, const std::atomic<bool>& is_over) {
  Participant agent = need(Participant::open(network));
  Waiter waiter = need(Waiter::make());
  Writer actions = need(agent.writer("actions", ChannelKind::kActions));
  std::vector<Reader> percepts;
  for (std::size_t i = 0; i < robots; ++i)
    percepts.push_back(need(agent.reader(topic_of(i), ChannelKind::kLockStepPercepts, waiter)));
  const std::string action(kActionBytes, 'a');
  while (!is_over) {
    waiter.wait(milliseconds(100));
    for (Reader& reader : percepts) {
      for (const Arrival& arrival : reader.take()) {
        if (arrival.kind == Arrival::Kind::kMessage) send(actions, arrival.key, action);
      }
    }
  }
}

/// The console.
class Console {
 public:
  Console(const Network& network, std::size_t robots)
      : participant_(need(Participant::open(network))),
        waiter_(need(Waiter::make())),
        actions_(need(participant_.reader("actions", ChannelKind::kActions, waiter_))) {
    for (std::size_t i = 0; i < robots; ++i)
      percepts_.push_back(need(participant_.writer(topic_of(i), ChannelKind::kLockStepPercepts, &waiter_)));
  }

  void wait_for_all() {
    const auto is_there = [&] {
      return std::ranges::none_of(percepts_, [](const Writer& one) { return one.readers().empty(); }) &&
             !actions_.senders().empty();
    };
    while (!is_there()) waiter_.wait(milliseconds(10));
    // The other side may know of this one some milliseconds later.
    std::this_thread::sleep_for(milliseconds(300));
  }

  /// Percepts of all robots out, and all their actions back.
  void cycle() {
    for (std::size_t i = 0; i < percepts_.size(); ++i) send(percepts_[i], topic_of(i), body_);
    for (std::size_t got = 0; got < percepts_.size();) {
      waiter_.wait(milliseconds(1000));
      for (const Arrival& arrival : actions_.take()) got += arrival.kind == Arrival::Kind::kMessage ? 1U : 0U;
    }
  }

 private:
  Participant participant_;
  Waiter waiter_;
  Reader actions_;
  std::vector<Writer> percepts_;
  std::string body_ = std::string(kPerceptBytes, 'p');
};

void measure(std::size_t robots, double seconds, int lost) {
  const Network network{.fleet = fmt::format("bench-{}", ::getpid()),
                        .interface_name = {},
                        .peers = {},
                        .lost_of_thousand = lost};
  std::atomic<bool> is_over = false;
  std::jthread agent([&] { answer(network, robots, is_over); });
  Console console(network, robots);
  console.wait_for_all();
  std::vector<double> each;  // [us]
  const auto began = Clock::now();
  const auto until = began + std::chrono::duration<double>(seconds);
  while (Clock::now() < until) {
    const auto from = Clock::now();
    console.cycle();
    each.push_back(std::chrono::duration<double, std::micro>(Clock::now() - from).count());
  }
  const double took = std::chrono::duration<double>(Clock::now() - began).count();
  is_over = true;
  std::ranges::sort(each);
  const auto part = [&](double share) {
    return each[std::min(each.size() - 1,
                         static_cast<std::size_t>(share * static_cast<double>(each.size())))];
  };
  fmt::print(
      "{:>3} topics {:>8.0f} robot-cycles/s   a cycle of all: p50 {:.0f} us, p99 {:.0f} us, worst {:.0f} "
      "us\n",
      robots, static_cast<double>(each.size() * robots) / took, part(0.5), part(0.99), each.back());
}

}  // namespace
}  // namespace mlab::dds

int main(int count, char** words) {
  const double seconds = count > 1 ? std::atof(words[1]) : 5.0;
  const int lost = count > 2 ? std::atoi(words[2]) : 0;
  for (const std::size_t robots : {1U, 50U}) mlab::dds::measure(robots, seconds, lost);
}
