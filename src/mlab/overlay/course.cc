#include "mlab/overlay/course.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace mlab::overlay {
namespace {

template <class Thing>
Course course_from(const Thing& thing) {
  std::vector<geom::Point> points{thing.center};
  points.insert(points.end(), thing.route.begin(), thing.route.end());
  return {std::move(points), thing.speed};
}

}  // namespace

Course::Course(std::vector<geom::Point> points, double speed) : points_(std::move(points)), speed_(speed) {
  double along = 0.0;
  for (std::size_t i = 1; i < points_.size(); ++i) {
    along += distance(points_[i - 1], points_[i]);
    ends_.push_back(along);
  }
}

Course::Moment Course::at(double time) const {
  const double whole = ends_.back();
  const bool is_closed = points_.front() == points_.back();
  double along = std::fmod(speed_ * std::max(time, 0.0), is_closed ? whole : 2.0 * whole);
  const bool is_on_way_back = along >= whole && !is_closed;
  if (is_on_way_back) along = 2.0 * whole - along;
  // The leg that it goes on along, never one without length.
  const auto found =
      is_on_way_back ? std::ranges::lower_bound(ends_, along) : std::ranges::upper_bound(ends_, along);
  const auto leg = static_cast<std::size_t>(std::min(found, ends_.end() - 1) - ends_.begin());
  const geom::Offset ahead = unit(points_[leg + 1] - points_[leg]);
  const double before = leg == 0 ? 0.0 : ends_[leg - 1];
  const double rest = std::clamp(along - before, 0.0, distance(points_[leg], points_[leg + 1]));
  return {points_[leg] + ahead * rest, ahead * (is_on_way_back ? -speed_ : speed_)};
}

Course course_of(const ObstacleDisc& obstacle) {
  return course_from(obstacle);
}
Course course_of(const WorldObject& object) {
  return course_from(object);
}

double length_of(std::span<const geom::Point> points) {
  double out = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) out += distance(points[i - 1], points[i]);
  return out;
}

}  // namespace mlab::overlay
