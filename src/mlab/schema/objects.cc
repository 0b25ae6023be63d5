#include "mlab/schema/objects.h"

#include <algorithm>

namespace mlab::schema {

bool sees(const percept::Percepts& percepts, flow::ObjectClasses classes, double range) {
  return std::ranges::any_of(percepts.objects, [&](const percept::ObjectReading& object) {
    return contains(classes, object.object_class) && edge_distance(object) <= range;
  });
}

}  // namespace mlab::schema
