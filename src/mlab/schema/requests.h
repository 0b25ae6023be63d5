#pragma once

#include <cstdint>
#include <string_view>

#include "mlab/base/hash.h"
#include "mlab/base/id.h"
#include "mlab/geom/pose.h"
#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"

namespace mlab::schema {

/// A request that concerns an object, or none; `reach` is the farthest edge distance at which it may be taken
/// [m].
constexpr percept::Request request(percept::Request::Kind kind, base::ObjectId object, double reach) {
  percept::Request out;
  out.kind = kind;
  out.object = object;
  out.reach = reach;
  return out;
}

/// The request to tell robots that `name` is the case.
constexpr percept::Request notification(std::string_view name, percept::Audience audience) {
  percept::Request out;
  out.kind = percept::Request::Kind::kNotify;
  out.audience = audience;
  out.notification = base::hash_text(name);
  return out;
}

/// The request not to hear of `name` again until somebody tells it anew.
constexpr percept::Request take_notification(std::string_view name) {
  percept::Request out;
  out.kind = percept::Request::Kind::kTakeNotification;
  out.notification = base::hash_text(name);
  return out;
}

/// The request to tell the other robots where an object is.
inline percept::Request share_place(const percept::ObjectReading& object, const geom::Pose& pose) {
  percept::Request out;
  out.kind = percept::Request::Kind::kSharePlace;
  out.object = object.id;
  out.object_class = object.object_class;
  out.place = pose.point_at(object.center);
  return out;
}

/// The request to tell the other robots a place [m, world].
constexpr percept::Request share_place(geom::Point place) {
  percept::Request out;
  out.kind = percept::Request::Kind::kSharePlace;
  out.place = place;
  return out;
}

/// The request to those in the way to a place [m, world] to let this robot through.
/// @param cost  of those who meet, the one with the least goes first
constexpr percept::Request ask_passage(geom::Point place, double cost) {
  percept::Request out;
  out.kind = percept::Request::Kind::kAskPassage;
  out.place = place;
  out.cost = cost;
  return out;
}

/// The request to have an object for oneself in the next cycle.
/// @param cost  of several robots that claim it anew, the one with the least gets it
constexpr percept::Request claim(base::ObjectId object, double cost) {
  percept::Request out;
  out.kind = percept::Request::Kind::kClaim;
  out.object = object;
  out.cost = cost;
  return out;
}

/// The request to offer a task at a place [m, world] to this robot's team.
/// @param object  what it is about, or its number
constexpr percept::Request announcement(std::uint64_t task, base::ObjectId object, geom::Point place) {
  percept::Request out;
  out.kind = percept::Request::Kind::kAnnounceTask;
  out.notification = task;
  out.object = object;
  out.place = place;
  return out;
}

/// The request to take an object for one of another class from now on.
constexpr percept::Request mark_object(base::ObjectId object, percept::ObjectClass as, double reach) {
  percept::Request out = request(percept::Request::Kind::kMarkObject, object, reach);
  out.object_class = as;
  return out;
}

/// Puts a text for the operator into an action: `subject: message`, cut to what fits. One for each cycle: a
/// later one takes the place of an earlier.
void alert(percept::Action& action, std::string_view subject, std::string_view message);

/// The name of the notification that says that a key was pressed, or that a test came out so: `KEY d`.
std::uint64_t key_notification(char key);

}  // namespace mlab::schema
