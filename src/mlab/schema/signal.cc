#include "mlab/schema/signal.h"

#include <algorithm>

namespace mlab::schema {
namespace {

using geom::Point;
using geom::Pose;
using geom::Vector;
using percept::RadioContact;

constexpr double kStep = 2.0;        // between two places of a short way back [m]
constexpr double kAt = 1.0;          // from here on a place is reached [m]
constexpr double kSure = 25.0;       // from this strength on it is well known where somebody is [%]
constexpr double kWayBack = 0.75;    // confidence: the signal was strong there
constexpr double kLastHeard = 0.5;   // confidence: somebody was there once
constexpr double kOfThePlan = 0.25;  // confidence: it was made without having measured anything

const RadioContact* strongest(const percept::Percepts& percepts, Heard heard) {
  const auto at = std::ranges::find_if(percepts.radio, [&](const RadioContact& contact) {
    return heard == Heard::kAnybody || contact.is_unit_mate == (heard == Heard::kMates);
  });
  return at == percepts.radio.end() ? nullptr : &*at;
}

Vector to_place(const Pose& here, Point place) {
  const Vector there = here.to_robot(place);
  return length(there) < kAt ? Vector{} : unit(there);
}

}  // namespace

double signal_strength(const percept::Percepts& percepts, Heard heard) {
  const RadioContact* const contact = strongest(percepts, heard);
  return contact == nullptr ? 0.0 : contact->strength;
}

void SignalMemory::note(const percept::Percepts& percepts, double wanted, Heard heard) {
  const Point here = percepts.pose.position;
  const RadioContact* const contact = strongest(percepts, heard);
  strength_ = contact == nullptr ? 0.0 : contact->strength;
  toward_ = contact == nullptr ? Vector{} : unit(contact->center);
  if (contact != nullptr) {
    heard_at_ = percepts.pose.point_at(contact->center);
    has_heard_ = true;
  }
  if (!has_begun_) meeting_ = here;
  has_begun_ = true;
  if (strength_ >= wanted || strength_ > at_its_begin_) {
    crumbs_[0] = here;
    count_ = 1;
    at_its_begin_ = strength_;
    step_ = kStep;
    nearest_ = 0.0;
    was_left_ = false;
  } else if (count_ > 0) {
    follow(here);
  }
}

// Whoever comes nearer to the last place is on his way back, and leaves none.
void SignalMemory::follow(Point here) {
  const double away = geom::distance(here, crumbs_[count_ - 1]);
  nearest_ = std::min(nearest_, away);
  if (away < kAt && was_left_) {
    --count_;
    if (count_ == 0)
      at_its_begin_ = 0.0;  // it is not any more what it was there
    else
      nearest_ = geom::distance(here, crumbs_[count_ - 1]);
    return;
  }
  was_left_ = was_left_ || away >= kAt;
  if (away < nearest_ + step_) return;
  if (count_ == kMostCrumbs) {  // places twice as far apart from now on
    for (std::size_t i = 1; 2 * i < kMostCrumbs; ++i) crumbs_[i] = crumbs_[2 * i];
    count_ = kMostCrumbs / 2;
    step_ *= 2.0;
  }
  crumbs_[count_++] = here;
  nearest_ = 0.0;
  was_left_ = false;
}

SignalMemory::Advice SignalMemory::advice(const Pose& here, SignalMethod method, double wanted) const {
  if (strength_ >= wanted) return {{}, 1.0};
  const std::array all = {recovery(here), preservation(wanted), plan(here)};
  switch (method) {
    case SignalMethod::kRecovery:
    case SignalMethod::kPreservation:
    case SignalMethod::kPlan:
      return all[static_cast<std::size_t>(method)];
    case SignalMethod::kGreedy:
      return *std::ranges::max_element(all, {}, &Advice::confidence);
    case SignalMethod::kAverage:
      break;
  }
  Vector sum{};
  double weights = 0.0;
  for (const auto& [direction, confidence] : all) {
    sum = sum + direction * confidence;
    weights += confidence;
  }
  return {sum * (1.0 / weights), weights / static_cast<double>(all.size())};  // that of the plan is never 0
}

SignalMemory::Advice SignalMemory::recovery(const Pose& here) const {
  const bool is_at_last = count_ > 0 && geom::distance(here.position, crumbs_[count_ - 1]) < kAt;
  const std::size_t next = is_at_last ? count_ - 1 : count_;
  if (next > 0) return {to_place(here, crumbs_[next - 1]), kWayBack};
  if (has_heard_ && geom::distance(here.position, heard_at_) >= kAt)
    return {to_place(here, heard_at_), kLastHeard};
  return {};
}

// The weaker it is, the more.
SignalMemory::Advice SignalMemory::preservation(double wanted) const {
  return {toward_ * (1.0 - strength_ / wanted), std::min(strength_ / kSure, 1.0)};
}

SignalMemory::Advice SignalMemory::plan(const Pose& here) const {
  return {to_place(here, meeting_), kOfThePlan};
}

}  // namespace mlab::schema
