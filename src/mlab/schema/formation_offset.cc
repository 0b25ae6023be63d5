#include "mlab/schema/formation_offset.h"

namespace mlab::schema {
namespace {

using percept::FormationReference;

// Where the reference is, and the rank of the member that stands there; -1: the centre.
struct Reference {
  geom::Point position;
  int rank = -1;
};

Reference locate(const percept::UnitPercept& unit, FormationReference reference) {
  switch (reference) {
    case FormationReference::kLeader:
      return {unit.leader.position, 0};
    case FormationReference::kNeighbor:
      return {unit.neighbor.position, unit.rank - 1};
    case FormationReference::kUnitCenter:
      break;
  }
  return {unit.center + unit.center_step, -1};
}

}  // namespace

geom::Vector formation_offset(const percept::UnitPercept& unit, const geom::Pose& pose,
                              percept::Formation formation, percept::FormationReference reference,
                              double spacing, double heading) {
  if (formation == percept::Formation::kNone || unit.size <= 1) return {};
  if (reference != FormationReference::kUnitCenter && unit.rank == 0) return {};

  const Reference from = locate(unit, reference);
  geom::Vector place = percept::station(formation, unit.rank, unit.size, spacing);
  if (from.rank >= 0) place -= percept::station(formation, from.rank, unit.size, spacing);
  const geom::Vector offset = pose.to_robot(from.position) + geom::rotated(place, heading);
  if (formation != percept::Formation::kSweep) return offset;
  const geom::Vector ahead = geom::polar(1.0, heading);
  return ahead * geom::dot(offset, ahead);
}

}  // namespace mlab::schema
