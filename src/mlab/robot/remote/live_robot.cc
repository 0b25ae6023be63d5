#include "mlab/robot/remote/live_robot.h"

#include <algorithm>
#include <cmath>

namespace mlab::robot_remote {
namespace {

constexpr std::size_t kMostKept = 32;     // actions whose requests the run has not taken
constexpr double kLongestTransit = 60.0;  // [s]; what is said beyond is nonsense

}  // namespace

bool LiveRobot::hear(const wire::LivePercepts& message, Clock::time_point arrived) {
  if (message.cycle() <= cycle_) return false;
  if (!(message.transit() >= 0.0) || message.transit() > kLongestTransit) return false;
  if (percepts_.decode(message.percepts())) {
    // What stood there is overwritten: it has none until the next ones come.
    cycle_ = acted_on_ = 0;
    return false;
  }
  cycle_ = message.cycle();
  sent_ = message.sent();
  transit_ = message.transit();
  wants_state_ = message.wants_state();
  arrived_ = arrived;
  while (!earlier_.empty() && earlier_.front().number() <= message.taken()) earlier_.pop_front();
  return true;
}

percept::Percepts LiveRobot::percepts(Clock::time_point now) const {
  percept::Percepts out = percepts_.percepts();
  if (!is_fresh()) out.time += in_seconds(now - arrived_);
  return out;
}

void LiveRobot::answer(Clock::time_point now, wire::LiveAction& out) {
  acted_on_ = cycle_;
  acted_at_ = now;
  out.set_number(++number_);
  out.set_cycle(cycle_);
  out.set_sent(sent_);
  out.set_received(nanoseconds_of(arrived_));
  out.set_age(age(now));
  for (const wire::EarlierRequests& one : earlier_) *out.add_earlier() = one;
}

void LiveRobot::keep_requests(const wire::LiveAction& done) {
  const wire::Action& action = done.action().action();
  wire::EarlierRequests kept;
  kept.set_number(done.number());
  kept.mutable_action()->set_alert(action.alert());
  for (const wire::Request& request : action.requests()) {
    // A claim counts in its own cycle only.
    if (request.kind() != wire::Request::CLAIM) *kept.mutable_action()->add_requests() = request;
  }
  if (kept.action().requests().empty() && action.alert().empty()) return;
  if (earlier_.size() >= kMostKept) earlier_.pop_front();
  earlier_.push_back(std::move(kept));
}

}  // namespace mlab::robot_remote
