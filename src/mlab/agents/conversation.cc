#include "mlab/agents/conversation.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace mlab::agents {
namespace {

constexpr std::size_t kMostWaiting = 4;               // messages
constexpr std::chrono::seconds kOpeningPatience(10);  // for a run to say who it is

}  // namespace

Conversation::Conversation(robot_remote::AgentTerms terms, dds::Waiter waiter, dds::Reader::Branch requests,
                           Answer answer, GoLive go_live)
    : waiter_(std::move(waiter)),
      requests_(std::move(requests)),
      answer_(std::move(answer)),
      go_live_(std::move(go_live)),
      is_stopped_(terms.is_stopped) {
  terms.sources.ends = stop_.get_token();
  thread_ = std::thread([this, terms = std::move(terms)] { serve(terms); });
}

Conversation::~Conversation() {
  end();
  thread_.join();
}

bool Conversation::add(std::string_view part) {
  const std::scoped_lock lock(mutex_);
  if (!take_part(part)) return false;
  waiter_.wake();
  if (live_) live_->wake();
  return true;
}

bool Conversation::take_part(std::string_view part) {
  const Assembly::Outcome outcome = assembly_.add(part);
  if (outcome == Assembly::Outcome::kNonsense) return false;
  if (outcome == Assembly::Outcome::kMoreFollows) return true;
  if (waiting_.size() >= kMostWaiting) return false;
  waiting_.push_back(assembly_.message());
  return true;
}

void Conversation::end() {
  const std::scoped_lock lock(mutex_);
  is_to_end_ = true;
  stop_.request_stop();
  waiter_.wake();
  if (live_) live_->wake();
}

void Conversation::look_at_stop() {
  const std::scoped_lock lock(mutex_);
  if (live_) live_->wake();
}

// False: what has arrived is nonsense, or not all of it.
bool Conversation::hear_requests() {
  const auto arrivals = requests_ ? requests_->take() : std::vector<dds::Arrival>();
  const std::scoped_lock lock(mutex_);
  return std::ranges::all_of(arrivals, [this](const dds::Arrival& arrival) {
    return arrival.kind == dds::Arrival::Kind::kMessage && take_part(arrival.body);
  });
}

// Waits for what the run asks. Nothing: it is to end.
std::optional<std::string> Conversation::next_request(robot_remote::RunnerServer& server) {
  const auto last = robot_remote::Clock::now() + kOpeningPatience;
  for (;;) {
    if (!hear_requests()) return std::nullopt;
    {
      const std::scoped_lock lock(mutex_);
      if (is_to_end_) return std::nullopt;
      if (!waiting_.empty()) {
        std::string out = std::move(waiting_.front());
        waiting_.pop_front();
        return out;
      }
    }
    if (server.is_open()) {
      waiter_.wait(std::chrono::milliseconds(-1));
      continue;
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(last - robot_remote::Clock::now());
    if (left.count() <= 0) return std::nullopt;
    waiter_.wait(left);
  }
}

// The same in real time: robots act meanwhile.
std::optional<std::string> Conversation::next_live(robot_remote::RunnerServer& server) {
  const auto nobody_waits = [this] { return is_to_end_.load(); };
  const auto publish = [this](std::string_view key, std::string_view body) { live_->send(key, body); };
  for (;;) {
    if (const bool is_stopped = is_stopped_(); is_stopped != stands_) {
      stands_ = is_stopped;
      if (is_stopped) server.stand(robot_remote::Clock::now(), publish);
    }
    {
      const std::scoped_lock lock(mutex_);
      if (is_to_end_) return std::nullopt;
      if (!waiting_.empty()) {
        std::string out = std::move(waiting_.front());
        waiting_.pop_front();
        return out;
      }
    }
    for (const robot_remote::LiveLine::Message& message : live_->receive(server.due())) {
      heard_ = message.arrived;
      server.hear(message);
    }
    if (const auto now = robot_remote::Clock::now(); now >= server.due())
      server.act_live(now, publish, nobody_waits);
  }
}

void Conversation::serve(const robot_remote::AgentTerms& terms) {
  robot_remote::RunnerServer server(terms);
  const auto nobody_waits = [this] { return is_to_end_.load(); };
  while (const auto message = is_live_ ? next_live(server) : next_request(server)) {
    const std::string_view answer = server.answer(*message, nobody_waits);
    robots_ = server.robot_count();
    has_opened_ = server.is_open();
    has_left_ = server.has_left();
    heard_ = robot_remote::Clock::now();
    if (server.period() > 0.0 && !is_live_) {
      auto live = go_live_();
      if (!live) break;
      // It waits with the line from now on, and is woken by who hears all.
      requests_.reset();
      const std::scoped_lock lock(mutex_);
      live_ = std::move(live);
      is_live_ = true;
    }
    if (!answer_(answer, [this] { return !is_to_end_.load(); }) || server.has_left()) break;
  }
  has_ended_ = true;
}

}  // namespace mlab::agents
