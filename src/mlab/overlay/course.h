#pragma once

#include <span>
#include <vector>

#include "mlab/geom/pose.h"
#include "mlab/overlay/overlay.h"

namespace mlab::overlay {

/// The way of something that moves along a polyline at an even speed, for ever: round and round where the
/// polyline ends where it begins, else there and back. Where it is depends on the time alone.
class Course {
 public:
  static constexpr double kShortest = 0.01;  ///< [m]

  struct Moment {
    geom::Point place;
    geom::Offset velocity;  ///< [m/s]
  };

  /// @param points  a polyline at least kShortest long [m]
  /// @param speed   [m/s], > 0
  Course(std::vector<geom::Point> points, double speed);

  /// @param time  since the start of the run [s]; before it, it is at the beginning
  Moment at(double time) const;
  const std::vector<geom::Point>& points() const { return points_; }
  double speed() const { return speed_; }
  friend bool operator==(const Course&, const Course&) = default;

 private:
  std::vector<geom::Point> points_;
  std::vector<double> ends_;  // by leg: from the beginning to its end, along the polyline [m]
  double speed_;
};

/// The course of what moves on the map, from its centre on.
Course course_of(const ObstacleDisc& obstacle);
Course course_of(const WorldObject& object);

/// Of a polyline [m].
double length_of(std::span<const geom::Point> points);

}  // namespace mlab::overlay
