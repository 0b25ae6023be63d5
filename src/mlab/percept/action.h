#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "mlab/base/id.h"
#include "mlab/geom/pose.h"
#include "mlab/geom/vector.h"
#include "mlab/percept/percepts.h"

namespace mlab::percept {

/// Whom a notification reaches. A team is the outermost unit of the mission that the robot belongs to.
enum class Audience : std::uint8_t { kAll, kTeam, kSelf };

/// Something that a behavior asks of the world or of others; resolved after the cycle in the order of robot
/// ids, then of requests, and seen in the next cycle. Fields that a kind does not name are ignored.
struct Request {
  enum class Kind : std::uint8_t {
    kPickUp,            ///< object, reach
    kDrop,              ///< what is carried
    kDropInBasket,      ///< object, reach
    kNotify,            ///< notification, audience
    kProceed,           ///< asks the operator
    kTakeNotification,  ///< notification: it has been heard, and is not to be heard again
    kSharePlace,        ///< object, object_class, place: told to all others, in place of what was told before
    kClaim,             ///< object, cost: for the next cycle, and against this robot's team only
    kMarkObject,        ///< object, reach, object_class: what it is to be taken for from now on
    kMarkDoor,          ///< object: number of the door from 1, reach
    kUnmarkDoor,        ///< the same
    kShowAs,            ///< object_class: what this robot is to be taken for
    kLocalize,          ///< place, heading: where this robot says that it is
    kHalt,              ///< ends this robot's program
    kEndMission,        ///< ends the mission for all
    kAnnounceTask,      ///< notification, object, place, wait, patience: offers a task to this robot's team
    kBid,               ///< notification, object, cost: for a task on offer, in this cycle
    kKeepTasks,         ///< this robot still works on what it was awarded
    kStartTask,         ///< notification, object: this robot begins with what it was awarded
    kFinishTask,        ///< the same: it is done
    kRenegeTask,        ///< the same: it gives it back
    kAskPassage,        ///< place, cost: told to all others, in place of what this robot asked for before
  };
  Kind kind = Kind::kPickUp;
  Audience audience = Audience::kAll;
  ObjectClass object_class = ObjectClass::kUnknown;
  base::ObjectId object;           ///< what is picked up or claimed, the basket, what stands at `place`; of a
                                   ///< task: what it is about, or its number
  double reach = 0.0;              ///< farthest edge distance at which it may be taken [m]
  double cost = 0.0;               ///< of several that want the same, the one with the least gets it
  std::uint64_t notification = 0;  ///< base::hash_text of the name that others wait for, or of a task's name
  geom::Point place{};             ///< [m, world]
  double heading = 0.0;            ///< [rad, world]
  double wait = 0.0;               ///< how long bids are waited for, before the task is awarded [s]
  double patience = 0.0;  ///< after such a silence of who was awarded it the task is on offer again [s]
};

/// The last one, for who checks numbers from outside.
inline constexpr Request::Kind kLastRequest = Request::Kind::kAskPassage;

/// How far a robot is with its order.
struct OrderStatus {
  std::uint32_t sequence = 0;  ///< of the order that this speaks of; 0: the program tells nothing
  bool done = false;
  double remaining = 0.0;  ///< what is still to be done [m]; its falling counts (where a unit shares it: its
                           ///< changing); < 0: no length; infinite: it can do no more
};

/// What a robot does in one cycle. Plain data; the binding carries it out.
struct Action {
  static constexpr int kMaxRequests = 4;
  static constexpr std::size_t kMaxAlert = 128;  ///< bytes, with the 0 behind the text

  geom::Vector velocity;  ///< wanted [m/s, robot frame]
  double spin = 0.0;      ///< wanted turning in place, counter-clockwise [rad/s]
  bool drives = false;    ///< some actuator spoke; else the robot stands
  bool spins = false;     ///< `spin` counts; else the robot turns to where it drives, as its kinematics allow
  double pan = 0.0;       ///< wanted direction of the camera, counter-clockwise from ahead [rad]
  bool looks = false;     ///< `pan` counts; else the camera stays as it is
  OrderStatus status;
  std::array<Request, kMaxRequests> requests{};
  std::uint8_t request_count = 0;
  std::array<char, kMaxAlert> alert{};  ///< what the operator is to read; empty: nothing

  /// Becomes an action that does nothing. Requests that do not count any more stay in their places, so that
  /// they are not written.
  constexpr void clear() {
    velocity = {};
    spin = pan = 0.0;
    drives = spins = looks = false;
    status = {};
    request_count = 0;
    if (alert.front() != 0) alert = {};
  }
  /// Becomes another one, by what counts of it.
  constexpr void become(const Action& other) {
    velocity = other.velocity;
    spin = other.spin;
    drives = other.drives;
    spins = other.spins;
    pan = other.pan;
    looks = other.looks;
    status = other.status;
    request_count = other.request_count;
    for (std::size_t i = 0; i < request_count && i < requests.size(); ++i) requests[i] = other.requests[i];
    if (alert.front() != 0 || other.alert.front() != 0) alert = other.alert;
  }

  /// Adds a request. @return false where the cycle already has kMaxRequests; the request is dropped then
  constexpr bool ask(Request request) {
    if (request_count >= kMaxRequests) return false;
    requests[request_count++] = request;
    return true;
  }
};

}  // namespace mlab::percept
