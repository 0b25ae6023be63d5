#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "mlab/geom/pose.h"
#include "mlab/mission/mission.h"
#include "mlab/text/diagnostic.h"

namespace mlab::mdl {

/// What a formation takes up around its middle, all robots' bodies included [m].
struct Extent {
  double min_x = 0.0, max_x = 0.0;
  double min_y = 0.0, max_y = 0.0;
  double width() const { return max_x - min_x; }
  double height() const { return max_y - min_y; }
};

/// Says whether a unit in formation fits into the mission area and through the gaps on its way, and whether
/// its robots leave each other the room to stand in it.
class FormationCheck {
 public:
  FormationCheck(const mission::Mission& mission, text::Diagnostics& diagnostics);

  /// Warns where the unit of the command, on its way along `leg`, doesn't fit.
  void check_leg(const mission::UnitCommand& command, geom::Segment leg);
  /// Whether robots of a type find their way by themselves.
  bool plans_ways(const mission::RobotType& type) const;

 private:
  const std::vector<geom::Offset>& stations(percept::Formation formation, int count);
  double spacing_of(const std::vector<base::RobotId>& members);
  Extent extent(const mission::UnitCommand& command, double heading);
  void check_gap(const mission::UnitCommand& command, geom::Segment leg, double heading,
                 const overlay::ControlMeasure& gap);
  void check_room(const mission::UnitCommand& command);
  void check_meeting(const mission::UnitCommand& command);
  void check_crowd(const mission::UnitCommand& command, std::size_t robots, double radius);

  const mission::Mission& mission_;
  text::Diagnostics& diagnostics_;
  std::vector<const overlay::ControlMeasure*> gaps_;
  std::vector<double> spacing_of_type_;
  std::vector<double> radius_of_type_;
  std::map<std::uint32_t, std::uint32_t> type_of_robot_;
  std::set<std::uint32_t> crowded_units_;  ///< that were warned about
  std::uint64_t gap_visits_ = 0;
  std::map<std::pair<percept::Formation, int>, std::vector<geom::Offset>> stations_;  // at spacing 1
};

/// True where the way leads through the gap rather than past or across it.
bool leads_through(geom::Segment way, const overlay::ControlMeasure& gap);

}  // namespace mlab::mdl
