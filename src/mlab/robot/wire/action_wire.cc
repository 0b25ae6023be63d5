#include "mlab/robot/wire/action_wire.h"

#include <cstring>

namespace mlab::robot_wire {
namespace {

constexpr auto kLastKind = percept::kLastRequest;
constexpr auto kLastAudience = percept::Audience::kSelf;

}  // namespace

// As in percepts_wire.cc, structs are taken apart so that a field that is added later does not compile.

void encode(const percept::Action& action, wire::Action& out) {
  const auto& [velocity, spin, drives, spins, pan, looks, status, requests, request_count, alert] = action;
  out.Clear();
  out.set_velocity_x(velocity.x);
  out.set_velocity_y(velocity.y);
  out.set_velocity_z(velocity.z);
  out.set_spin(spin);
  out.set_drives(drives);
  out.set_spins(spins);
  out.set_pan(pan);
  out.set_looks(looks);
  if (alert.front() != 0) out.set_alert(alert.data(), ::strnlen(alert.data(), alert.size() - 1));
  const auto& [sequence, done, remaining] = status;
  out.mutable_status()->set_sequence(sequence);
  out.mutable_status()->set_done(done);
  out.mutable_status()->set_remaining(remaining);
  for (std::uint8_t i = 0; i < request_count; ++i) {
    const auto& [kind, audience, object_class, object, reach, cost, notification, place, heading, wait,
                 patience] = requests[i];
    wire::Request& request = *out.add_requests();
    request.set_kind(static_cast<wire::Request::Kind>(kind));
    request.set_object(object.value);
    request.set_reach(reach);
    request.set_notification(notification);
    request.set_audience(static_cast<wire::Request::Audience>(audience));
    request.set_object_class(static_cast<wire::ObjectClass>(object_class));
    request.set_cost(cost);
    request.set_x(place.x);
    request.set_y(place.y);
    request.set_heading(heading);
    request.set_wait(wait);
    request.set_patience(patience);
  }
}

std::optional<std::string> decode(const wire::Action& message, percept::Action& out) {
  if (message.requests_size() > percept::Action::kMaxRequests) return "an action makes too many requests";
  if (message.alert().size() >= percept::Action::kMaxAlert) return "an alert is too long";
  percept::Action action;
  // The text ends at a 0, as in an Action: what stands behind one is no part of it.
  message.alert().copy(action.alert.data(), ::strnlen(message.alert().data(), message.alert().size()));
  for (const wire::Request& request : message.requests()) {
    if (request.kind() < 0 || request.kind() > static_cast<int>(kLastKind))
      return "an action makes a request that there is not";
    if (request.audience() < 0 || request.audience() > static_cast<int>(kLastAudience))
      return "a request is for an audience that there is not";
    if (request.object_class() < 0 || request.object_class() > static_cast<int>(percept::kLastObjectClass))
      return "a request is about a class that there is not";
    action.ask({static_cast<percept::Request::Kind>(request.kind()),
                static_cast<percept::Audience>(request.audience()),
                static_cast<percept::ObjectClass>(request.object_class()),
                {request.object()},
                request.reach(),
                request.cost(),
                request.notification(),
                {request.x(), request.y()},
                request.heading(),
                request.wait(),
                request.patience()});
  }
  action.velocity = {message.velocity_x(), message.velocity_y(), message.velocity_z()};
  action.spin = message.spin();
  action.drives = message.drives();
  action.spins = message.spins();
  action.pan = message.pan();
  action.looks = message.looks();
  action.status = {message.status().sequence(), message.status().done(), message.status().remaining()};
  out = action;
  return std::nullopt;
}

}  // namespace mlab::robot_wire
