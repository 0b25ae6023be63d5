#include "mlab/robot/remote/live_runner.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include <fmt/core.h>

#include "mlab/geom/vector.h"
#include "mlab/robot/wire/action_wire.h"
#include "mlab/robot/wire/percepts_wire.h"

namespace mlab::robot_remote {
namespace {

constexpr std::size_t kMostRequests = 256;  // of a robot that were not handed on
constexpr std::chrono::milliseconds kBeat(100);
constexpr std::uint64_t kLookingCycles = 10;  // for which somebody who looked is taken to look on

// The part of a cycle in which its own actions are waited for: what comes later counts in the next one.
constexpr double kSettling = 0.25;

// Of the cycles whose headings are known: more than go by while an action counts, however short they are.
constexpr std::size_t kKnownHeadings = 1024;

// What was decided in a frame of then, in that of now. [rad] counter-clockwise
percept::Action turned(percept::Action action, double by) {
  action.velocity = geom::rotated(action.velocity, by);
  action.pan += by;
  return action;
}

percept::Action without_requests(const percept::Action& action) {
  percept::Action out = action;
  out.request_count = 0;
  out.requests = {};
  out.alert = {};
  return out;
}

}  // namespace

// ----------------------------------------------------------------------------------------------------------
// beats

Beats::Beats(double period) : period_(period), thread_([this](const std::stop_token& stop) { beat(stop); }) {}

void Beats::beat(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    wire::LiveBeat beat;
    beat.set_rests(!has_cycles_ || Clock::now() - last_cycle_ > from_seconds(2.0 * period_));
    for (const auto& line : lines_) line->send(kBeatKey, beat.SerializeAsString());
    ended_.wait_for(lock, stop, kBeat, [] { return false; });
  }
}

void Beats::add(std::shared_ptr<LiveLine> line) {
  const std::scoped_lock lock(mutex_);
  lines_.push_back(std::move(line));
}

void Beats::remove(const std::shared_ptr<LiveLine>& line) {
  const std::scoped_lock lock(mutex_);
  std::erase(lines_, line);
}

void Beats::note_cycle() {
  const std::scoped_lock lock(mutex_);
  last_cycle_ = Clock::now();
  has_cycles_ = true;
}

void RoundTrip::note(double seconds, Clock::time_point now) {
  if (seconds < 0.0) return;
  if (now - began_ > kWindow) {
    before_ = now - began_ > 2 * kWindow ? 0.0 : current_;
    current_ = 0.0;
    began_ = now;
  }
  current_ = current_ > 0.0 ? std::min(current_, seconds) : seconds;
}

double RoundTrip::shortest() const {
  if (before_ > 0.0 && current_ > 0.0) return std::min(before_, current_);
  return std::max(before_, current_);
}

// ----------------------------------------------------------------------------------------------------------
// cycles

LiveRunner::LiveRunner(Recruit recruit, double period)
    : RemoteRunner(std::move(recruit)), period_(period), asked_(kKnownHeadings), beats_(period) {}

// Who looks again and again gets it with actions, and waits for nobody.
bool LiveRunner::is_known_well(const Robot& robot) const {
  return robot.known == cycle_ || (is_looked_at(robot) && robot.known != kLongAgo);
}

bool LiveRunner::is_looked_at(const Robot& robot) const {
  return robot.asked != kLongAgo && robot.asked + kLookingCycles >= cycle_;
}

void LiveRunner::open() {
  follow_lines();
  by_number_.clear();
  for (const Member member : joined_) {
    const Robot& robot = members_[member];
    if (live_.size() <= member) live_.resize(member + 1);
    if (!live_[member] || live_[member]->number != robot.number) {
      live_[member] = std::make_unique<Live>();
      live_[member]->number = robot.number;
      live_[member]->came = live_[member]->answers =
          Clock::now();  // as if it had been heard when it was started
      live_[member]->headings.resize(kKnownHeadings);
    }
    by_number_[robot.number] = member;
  }
}

// Agents that came or went.
void LiveRunner::follow_lines() {
  for (Carrier& carrier : carriers_) {
    const std::shared_ptr<LiveLine>& line = carrier.agent->live();
    if (!line) continue;
    const auto at = std::ranges::find(lines_, line);
    const bool stands = carrier.agent->failure().empty();
    if (stands && at == lines_.end()) {
      lines_.push_back(line);
      beats_.add(line);
    } else if (!stands && at != lines_.end()) {
      beats_.remove(line);
      trips_.erase(line.get());
      lines_.erase(at);
    }
  }
}

void LiveRunner::act(std::span<const Turn> turns) {
  for (const Turn& turn : turns) {
    Robot& robot = members_[turn.member];
    robot.turn = turn;
    turn.fault->clear();
    turn.failure->clear();
    live_[turn.member]->headings[(cycle_ + 1) % kKnownHeadings] = turn.percepts->pose.heading;
    robot_wire::encode(*turn.percepts, *live_[turn.member]->percepts.mutable_percepts());
  }
}

void LiveRunner::ask() {
  is_in_cycle_ = true;
  note_asked(Clock::now());
  beats_.note_cycle();
  for (const Member member : joined_) {
    const Robot& robot = members_[member];
    Live& live = *live_[member];
    const std::shared_ptr<LiveLine>& line = robot.carrier->agent->live();
    if (!line) continue;
    live.percepts.set_cycle(cycle_ + 1);
    live.percepts.set_sent(nanoseconds_of(Clock::now()));
    live.percepts.set_transit(trips_[line.get()].shortest() / 2.0);
    live.percepts.set_taken(live.taken);
    live.percepts.set_wants_state(is_looked_at(robot));
    bytes_.clear();
    live.percepts.AppendToString(&bytes_);
    line->send(std::to_string(robot.number), bytes_);
  }
}

// Where nobody was asked for a while, because the run stood, nobody was silent either.
void LiveRunner::note_asked(Clock::time_point now) {
  if (now - asked_at_ > from_seconds(std::max(2.0 * period_, kActionPatience))) resumed_ = now;
  asked_at_ = now;
  asked_[(cycle_ + 1) % kKnownHeadings] = now;
}

void LiveRunner::wait(const robot::Meanwhile& /*meanwhile*/) {
  ++cycle_;
  const Clock::time_point last = asked_at_ + from_seconds(kSettling * period_);
  for (Carrier& carrier : carriers_) {
    while (carrier.agent->failure().empty() && carrier.agent->live() && !gather(carrier, last)) {
    }
  }
  const Clock::time_point now = Clock::now();
  for (const Member member : joined_) {
    const Robot& robot = members_[member];
    const std::string failure = robot.carrier->agent->failure();
    if (!failure.empty()) {
      *robot.turn.action = {};
      *robot.turn.failure = fmt::format("can't be reached: {}", failure);
      continue;
    }
    finish(robot, *live_[member], now);
  }
  joined_.clear();
  is_in_cycle_ = false;
}

// Takes what has come. True: all of its robots have answered this cycle, or their time is over.
bool LiveRunner::gather(Carrier& carrier, Clock::time_point last) {
  const auto is_awaited = [&](Member member) {
    const Live& live = *live_[member];
    return members_[member].carrier == &carrier && live.answered < cycle_ && !live.has_ended;
  };
  const bool waits = std::ranges::any_of(joined_, is_awaited);
  const Clock::time_point deadline = waits ? last : Clock::now();
  const std::vector<LiveLine::Message> messages = carrier.agent->live()->receive(deadline);
  for (const LiveLine::Message& message : messages) take(message, carrier);
  return !waits || Clock::now() >= last || std::ranges::none_of(joined_, is_awaited);
}

void LiveRunner::take(const LiveLine::Message& message, Carrier& carrier) {
  std::uint32_t number = 0;
  const char* const end = message.key.data() + message.key.size();
  const auto [rest, error] = std::from_chars(message.key.data(), end, number);
  const auto at = error != std::errc{} || rest != end ? by_number_.end() : by_number_.find(number);
  if (at == by_number_.end() || !message_.ParseFromString(message.body)) return;
  Robot& robot = members_[at->second];
  Live& live = *live_[at->second];
  if (robot.carrier != &carrier || message_.number() <= live.taken) return;
  if (message_.cycle() > cycle_ || cycle_ - message_.cycle() >= kKnownHeadings) return;
  const double there_and_back =
      in_seconds(message.arrived.time_since_epoch()) - 1e-9 * static_cast<double>(message_.sent()) -
      1e-9 * (static_cast<double>(message_.replied()) - static_cast<double>(message_.received()));
  trips_[carrier.agent->live().get()].note(there_and_back, message.arrived);
  if (const auto problem = take(message_, robot, live))
    carrier.agent->fail(
        fmt::format("answers nonsense for robot {}: {}", robot.values.robot().value, *problem));
}

std::optional<std::string> LiveRunner::take(const wire::LiveAction& message, Robot& robot, Live& live) {
  percept::Action asked;
  const auto keep = [&](const percept::Action& from) {
    for (std::uint8_t i = 0; i < from.request_count; ++i) {
      if (live.requests.size() < kMostRequests) live.requests.push_back(from.requests[i]);
    }
    if (from.alert.front() != 0) live.action.alert = from.alert;
  };
  const std::array alert = live.action.alert;
  for (const wire::EarlierRequests& earlier : message.earlier()) {
    if (earlier.number() <= live.taken || earlier.number() >= message.number()) continue;
    if (auto problem = robot_wire::decode(earlier.action(), asked)) return problem;
    keep(asked);
  }
  if (auto problem = take_action(message.action(), robot)) return problem;
  live.taken = message.number();
  live.answered = message.cycle();
  live.came = Clock::now();
  live.answers = asked_[message.cycle() % kKnownHeadings];
  punctuality_.worst_age = std::max(punctuality_.worst_age, message.age());
  live.has_ended = !robot.turn.failure->empty() || !robot.turn.fault->empty();
  if (live.has_ended) return std::nullopt;
  const std::array said = live.action.alert;
  live.action = without_requests(*robot.turn.action);
  live.action.alert = said.front() != 0 ? said : alert;
  keep(*robot.turn.action);
  return std::nullopt;
}

double LiveRunner::silence(Member member) const {
  const Live* const live = find(member);
  if (live == nullptr) return 0.0;
  const Clock::duration age = Clock::now() - std::max(live->came, resumed_);
  return age > from_seconds(kActionPatience) ? in_seconds(age) : 0.0;
}

double LiveRunner::percept_age(Member member) const {
  const Live* const live = find(member);
  if (live == nullptr || live->answered >= cycle_) return 0.0;
  return std::max(0.0, in_seconds(asked_at_ - std::max(live->answers, resumed_)));
}

// What the robot does in this cycle.
void LiveRunner::finish(const Robot& robot, Live& live, Clock::time_point now) {
  if (live.has_ended) {
    live.has_ended = false;  // a new start
    return;
  }
  ++punctuality_.asked;
  if (live.answered < cycle_) ++punctuality_.late;
  percept::Action& action = *robot.turn.action;
  if (live.taken == 0 || now - live.came > from_seconds(kActionPatience)) {
    if (live.answered < cycle_) ++punctuality_.stood;
    const percept::OrderStatus status = live.action.status;
    action = {};
    action.status = status;
    return;
  }
  const double turn = live.headings[live.answered % kKnownHeadings] - live.headings[cycle_ % kKnownHeadings];
  action = turned(live.action, turn);
  live.action.alert = {};
  while (!live.requests.empty() && action.ask(live.requests.front())) live.requests.pop_front();
}

}  // namespace mlab::robot_remote
