#pragma once

#include <array>
#include <cstdint>

#include "mlab/base/id.h"
#include "mlab/geom/vector.h"

namespace mlab::percept {

/// Something that a behavior asks of the world or of others; resolved after the cycle in the order of robot
/// ids, then of requests, and seen in the next cycle.
struct Request {
  enum class Kind : std::uint8_t { kPickUp, kDrop, kDropInBasket, kNotify, kProceed };
  Kind kind = Kind::kPickUp;
  base::ObjectId object;           ///< what is picked up, or the basket
  double reach = 0.0;              ///< farthest edge distance at which it may be taken [m]
  std::uint64_t notification = 0;  ///< base::hash_text of the name that others wait for
  bool to_self = false;            ///< a notification for this robot alone, not for all
};

/// How far a robot is with its order.
struct OrderStatus {
  std::uint32_t sequence = 0;  ///< of the order that this speaks of; 0: the program tells nothing
  bool done = false;
  double remaining = 0.0;  ///< what is still to be done, falling to 0 [m]; only its falling counts
};

/// What a robot does in one cycle. Plain data; the binding carries it out.
struct Action {
  static constexpr int kMaxRequests = 4;

  geom::Vector velocity;  ///< wanted [m/s, robot frame]
  double spin = 0.0;      ///< wanted turning in place, counter-clockwise [rad/s]
  bool drives = false;    ///< some actuator spoke; else the robot stands
  bool spins = false;     ///< `spin` counts; else the robot turns to where it drives, as its kinematics allow
  OrderStatus status;
  std::array<Request, kMaxRequests> requests{};
  std::uint8_t request_count = 0;

  /// Adds a request. @return false where the cycle already has kMaxRequests; the request is dropped then
  constexpr bool ask(Request request) {
    if (request_count >= kMaxRequests) return false;
    requests[request_count++] = request;
    return true;
  }
};

}  // namespace mlab::percept
