#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mlab/percept/percepts.h"
#include "mlab/percept/sensors.h"
#include "mlab/sim/bodies.h"
#include "mlab/sim/clear_place.h"
#include "mlab/sim/objects.h"
#include "mlab/sim/range_ring.h"
#include "mlab/sim/sensing.h"
#include "mlab/sim/statics.h"

namespace mlab::sim {

/// What bodies of one spec have in common, prepared.
struct Kind {
  BodySpec spec;
  RingBeams beams;
};

/// What one body perceives of the others and of the world. Refers to what is sensed; holds nothing itself.
class Sensors {
 public:
  struct Scene {
    const Bodies& bodies;
    const PointGrid& grid;  ///< of the bodies, where they stand now
    const Statics& statics;
    const Objects& objects;
    const std::vector<Kind>& kinds;
    std::uint64_t seed;
    std::uint64_t cycle;
    std::span<const MovingDisc> roamers;
    std::span<const Outline> silences;
    std::span<ClearPlace> clear;  ///< by body, for whoever senses for it
    std::span<Apart> apart;       ///< likewise
  };
  Sensors(const Scene& scene, std::uint32_t body, SenseBuffer& buffer);

  /// Empties all that only sensors tell.
  static void forget(percept::Percepts& out);
  /// @param reach  [m]; means nothing where the sensor has its own
  void sense(percept::Sensor sensor, double reach, percept::Percepts& out);

 private:
  void sense_obstacles(double range, percept::Percepts& out);
  void sense_robots(double range, percept::Percepts& out);
  void sense_objects(double range, percept::Percepts& out);
  void sense_ranges(percept::Percepts& out);
  void sense_radio(percept::Percepts& out);
  geom::Vector to_robot(geom::Point point) const;
  geom::Vector velocity_at(const geom::Vector& hit) const;
  void see_standing(double range);
  void see_by_ring(double range, percept::Percepts& out);
  void see_roamers(double range);
  void tell_velocities();
  void collect_walls(double reach);
  void collect_robots(double range);
  void see(double distance, std::uint32_t id, geom::Point center, double radius);
  void sort_seen();
  void sort_all_seen();

  const Scene& scene_;
  std::uint32_t body_;
  geom::Point here_;
  geom::Offset ahead_;
  SenseBuffer& buffer_;
};

}  // namespace mlab::sim
