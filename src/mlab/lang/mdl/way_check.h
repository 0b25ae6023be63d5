#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mlab/mission/mission.h"
#include "mlab/text/diagnostic.h"
#include "mlab/ways/planner.h"

namespace mlab::mdl {

/// Warns of goals that no way leads to from where a unit is: through no gap, however its robots steer.
/// Only obstacles and walls of the overlay count, and minefields for who keeps out of them. The work is
/// bounded.
class WayCheck {
 public:
  /// Both outlive this.
  WayCheck(const mission::Mission& mission, text::Diagnostics& diagnostics);

  /// What a body takes up to either side of its way [m].
  struct Room {
    double radius = 0.0;
    double margin = 0.0;     ///< that it keeps from what stands there where there is least room
    bool keeps_out = false;  ///< of minefields
    double half() const { return radius + margin; }
  };
  /// Who is where.
  struct From {
    std::string who;         ///< as it is told
    geom::Point place;       ///< [m, world]
    bool to_corner = false;  ///< the goal is a corner of the line that the command names
  };
  /// @param success  who is so near to the goal is there [m]
  /// @return  false: no way leads there
  bool check(const mission::UnitCommand& command, const From& from, Room room, double success);

 private:
  bool is_too_much() const;
  ways::Planner& planner(double clearance, bool keeps_out);
  bool has_effort_left() const;
  std::optional<ways::Planner::NoWay> no_way(ways::Planner& planner, geom::Point from, geom::Point goal,
                                             double success);
  void warn(const mission::UnitCommand& command, const From& from, Room room, double success,
            geom::Point nearest);
  void note_thing(std::uint32_t thing, text::Diagnostic& warning) const;

  const mission::Mission& mission_;
  text::Diagnostics& diagnostics_;
  ways::Ground open_;                                     // without minefields
  ways::Ground ground_;                                   // with them, behind all other walls
  std::vector<const overlay::ObstacleDisc*> obstacles_;   // by disc of the ground; they stand
  std::vector<const overlay::ControlMeasure*> measures_;  // by wall of the ground: of what it is a piece
  std::map<std::pair<bool, double>, std::unique_ptr<ways::Planner>> planners_;  // by who keeps out, clearance
  std::uint64_t effort_ = 0;                                                    // so far, as Planner::effort
};

}  // namespace mlab::mdl
