#pragma once

#include <algorithm>

#include "mlab/percept/percepts.h"
#include "mlab/schema/objects.h"

namespace mlab::schema {

/// The robot that holds the claim to an object; 0: nobody does.
inline base::RobotId claimant(const percept::Percepts& percepts, base::ObjectId object) {
  const auto at = std::ranges::lower_bound(percepts.claims, object, {}, &percept::Claim::object);
  return at != percepts.claims.end() && at->object == object ? at->robot : base::RobotId{};
}

/// What another robot told last of things of these classes, at most `max_age` ago [s]; of several told in the
/// same cycle that of the robot with the lowest id. Null where nobody told anything.
inline const percept::SharedPlace* newest_place(const percept::Percepts& percepts,
                                                flow::ObjectClasses classes, double max_age) {
  const percept::SharedPlace* newest = nullptr;
  for (const percept::SharedPlace& shared : percepts.shared_places) {
    if (shared.from == percepts.id || !contains(classes, shared.object_class)) continue;
    if (percepts.time - shared.time > max_age) continue;
    if (newest == nullptr || shared.time > newest->time) newest = &shared;
  }
  return newest;
}

}  // namespace mlab::schema
