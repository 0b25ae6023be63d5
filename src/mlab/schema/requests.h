#pragma once

#include <string_view>

#include "mlab/base/hash.h"
#include "mlab/base/id.h"
#include "mlab/percept/action.h"

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

/// The request to tell robots, or this robot alone, that `name` is the case.
constexpr percept::Request notification(std::string_view name, bool to_self) {
  percept::Request out;
  out.kind = percept::Request::Kind::kNotify;
  out.notification = base::hash_text(name);
  out.to_self = to_self;
  return out;
}

}  // namespace mlab::schema
