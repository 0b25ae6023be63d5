#include "mlab/robot_wire/action_wire.h"

namespace mlab::robot_wire {
namespace {

constexpr auto kLastKind = percept::Request::Kind::kProceed;

}  // namespace

// As in percepts_wire.cc, structs are taken apart so that a field that is added later does not compile.

void encode(const percept::Action& action, wire::Action& out) {
  const auto& [velocity, spin, drives, spins, status, requests, request_count] = action;
  out.Clear();
  out.set_velocity_x(velocity.x);
  out.set_velocity_y(velocity.y);
  out.set_velocity_z(velocity.z);
  out.set_spin(spin);
  out.set_drives(drives);
  out.set_spins(spins);
  const auto& [sequence, done, remaining] = status;
  out.mutable_status()->set_sequence(sequence);
  out.mutable_status()->set_done(done);
  out.mutable_status()->set_remaining(remaining);
  for (std::uint8_t i = 0; i < request_count; ++i) {
    const auto& [kind, object, reach, notification, to_self] = requests[i];
    wire::Request& request = *out.add_requests();
    request.set_kind(static_cast<wire::Request::Kind>(kind));
    request.set_object(object.value);
    request.set_reach(reach);
    request.set_notification(notification);
    request.set_to_self(to_self);
  }
}

std::optional<std::string> decode(const wire::Action& message, percept::Action& out) {
  if (message.requests_size() > percept::Action::kMaxRequests) return "an action makes too many requests";
  percept::Action action;
  for (const wire::Request& request : message.requests()) {
    if (request.kind() < 0 || request.kind() > static_cast<int>(kLastKind))
      return "an action makes a request that there is not";
    action.ask({static_cast<percept::Request::Kind>(request.kind()),
                {request.object()},
                request.reach(),
                request.notification(),
                request.to_self()});
  }
  action.velocity = {message.velocity_x(), message.velocity_y(), message.velocity_z()};
  action.spin = message.spin();
  action.drives = message.drives();
  action.spins = message.spins();
  action.status = {message.status().sequence(), message.status().done(), message.status().remaining()};
  out = action;
  return std::nullopt;
}

}  // namespace mlab::robot_wire
