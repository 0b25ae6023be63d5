#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "mlab/base/random.h"
#include "mlab/console.pb.h"
#include "mlab/overlay/measure_kinds.h"

namespace mlab::console::testing {

inline double random_coordinate(base::Random& random) {
  return std::round(random.uniform(-100.0, 1000.0) * 1000.0) / 1000.0;
}

inline void add_point(google::protobuf::RepeatedPtrField<Point>& to, base::Random& random) {
  Point& p = *to.Add();
  p.set_x(random_coordinate(random));
  p.set_y(random_coordinate(random));
}

inline const overlay::MeasureInfo& info_of(const Measure& measure) {
  return overlay::info(static_cast<overlay::MeasureKind>(measure.kind()));
}

/// A measure of any kind that an overlay can hold.
inline Measure random_measure(base::Random& random) {
  Measure out;
  out.set_kind(static_cast<Measure::Kind>(random.below(overlay::kMeasures.size())));
  out.set_name((random.below(2) == 0 ? "N" : "odd name ") + std::to_string(random.below(1000)));
  out.set_shows_label(random.below(3) > 0);
  const overlay::MeasureInfo& info = info_of(out);
  const std::uint64_t count = std::min(info.max_points, info.min_points + random.below(4));
  for (std::uint64_t i = 0; i < count; ++i) add_point(*out.mutable_points(), random);
  if (out.kind() == Measure::HALLWAY) {
    add_point(*out.mutable_centerline(), random);
    add_point(*out.mutable_centerline(), random);
  }
  out.set_size(random.uniform(0.5, 90.0));
  return out;
}

/// Moves, reshapes or renames it, or makes another out of it.
inline Measure changed(const Measure& measure, base::Random& random) {
  Measure out = measure;
  const auto count = static_cast<std::size_t>(out.points_size());
  switch (random.below(7)) {
    case 0:
      out.set_name("N" + std::to_string(random.below(1000)));
      break;
    case 1:
      out.set_shows_label(!out.shows_label());
      break;
    case 2:
      out.set_size(random.uniform(0.5, 90.0));
      break;
    case 3:
      if (count < info_of(out).max_points) {
        add_point(*out.mutable_points(), random);
        out.mutable_points()->SwapElements(
            static_cast<int>(random.below(static_cast<std::uint64_t>(out.points_size()))),
            out.points_size() - 1);
      }
      break;
    case 4:
      if (count > info_of(out).min_points)
        out.mutable_points()->DeleteSubrange(
            static_cast<int>(random.below(static_cast<std::uint64_t>(out.points_size()))), 1);
      break;
    case 5:
      return random_measure(random);
    default:
      for (Point& p : *out.mutable_points()) p.set_x(p.x() + 12.34);
      for (Point& p : *out.mutable_centerline()) p.set_x(p.x() + 12.34);
  }
  return out;
}

inline Obstacle random_obstacle(base::Random& random) {
  Obstacle out;
  out.set_x(random_coordinate(random));
  out.set_y(random_coordinate(random));
  out.set_radius(random.uniform(0.1, 20.0));
  if (random.below(4) > 0) return out;
  for (int i = 0; i < 2; ++i) add_point(*out.mutable_route(), random);
  out.set_speed(random.uniform(0.1, 90.0));
  return out;
}

inline WorldObject random_object(base::Random& random) {
  WorldObject out;
  out.set_x(random_coordinate(random));
  out.set_y(random_coordinate(random));
  out.set_diameter(random.uniform(0.1, 2.0));
  out.set_style(static_cast<WorldObject::Style>(random.below(3)));
  out.set_color(random.below(2) == 0 ? "red" : "light blue");
  return out;
}

/// Any change of any thing of the scene, often one that can be made.
inline MapChange random_change(const Scene& scene, base::Random& random) {
  MapChange out;
  const auto any = [&](int count) {
    return count == 0 ? 0U : static_cast<std::uint32_t>(random.below(static_cast<std::uint64_t>(count)));
  };
  switch (random.below(10)) {
    case 0:
      *out.mutable_add_measure() = random_measure(random);
      break;
    case 1:
      *out.mutable_add_obstacle() = random_obstacle(random);
      break;
    case 2:
      *out.mutable_add_object() = random_object(random);
      break;
    case 3:
      out.set_remove_measure(any(scene.measures_size()));
      break;
    case 4:
      out.set_remove_obstacle(any(scene.obstacles_size()));
      break;
    case 5:
      out.set_remove_object(any(scene.objects_size()));
      break;
    case 6:
      out.mutable_replace_obstacle()->set_index(any(scene.obstacles_size()));
      *out.mutable_replace_obstacle()->mutable_obstacle() = random_obstacle(random);
      break;
    case 7:
      out.mutable_replace_object()->set_index(any(scene.objects_size()));
      *out.mutable_replace_object()->mutable_object() = random_object(random);
      break;
    case 8:
      out.mutable_set_area()->set_width(100.0 + static_cast<double>(random.below(900)));
      out.mutable_set_area()->set_height(100.0 + static_cast<double>(random.below(900)));
      break;
    default:
      out.mutable_replace_measure()->set_index(any(scene.measures_size()));
      *out.mutable_replace_measure()->mutable_measure() =
          scene.measures_size() == 0
              ? random_measure(random)
              : changed(scene.measures(static_cast<int>(out.replace_measure().index())), random);
  }
  return out;
}

/// Coordinates and lengths are written to a centimetre.
inline bool is_near(double a, double b) {
  return std::abs(a - b) <= 0.0051;
}
inline bool is_near(const Point& a, const Point& b) {
  return is_near(a.x(), b.x()) && is_near(a.y(), b.y());
}
inline bool is_near(const google::protobuf::RepeatedPtrField<Point>& a,
                    const google::protobuf::RepeatedPtrField<Point>& b) {
  if (a.size() != b.size()) return false;
  for (int i = 0; i < a.size(); ++i) {
    if (!is_near(a[i], b[i])) return false;
  }
  return true;
}
inline bool is_near(const Measure& a, const Measure& b) {
  const bool has_size = b.size() != 0.0;  // of a kind without one the reader makes 0
  return a.kind() == b.kind() && a.name() == b.name() && a.shows_label() == b.shows_label() &&
         is_near(a.points(), b.points()) &&
         (a.kind() != Measure::HALLWAY || is_near(a.centerline(), b.centerline())) &&
         (!has_size || is_near(a.size(), b.size()));
}
inline bool is_near(const Obstacle& a, const Obstacle& b) {
  return is_near(a.x(), b.x()) && is_near(a.y(), b.y()) && is_near(a.radius(), b.radius()) &&
         is_near(a.height(), b.height()) && is_near(a.route(), b.route()) &&
         (a.route().empty() || is_near(a.speed(), b.speed()));
}
inline bool is_near(const WorldObject& a, const WorldObject& b) {
  return is_near(a.x(), b.x()) && is_near(a.y(), b.y()) && is_near(a.diameter(), b.diameter()) &&
         a.style() == b.style() && a.color() == b.color();
}

/// What is expected and not there; in any order. Empty: all is.
template <class List>
std::string missing(const List& expected, const List& got) {
  if (expected.size() != got.size())
    return std::to_string(got.size()) + " things, expected " + std::to_string(expected.size());
  std::vector<bool> is_used(static_cast<std::size_t>(got.size()), false);
  for (const auto& wanted : expected) {
    int i = 0;
    while (i < got.size() && (is_used[static_cast<std::size_t>(i)] || !is_near(wanted, got[i]))) ++i;
    if (i == got.size()) return wanted.ShortDebugString() + " is missing";
    is_used[static_cast<std::size_t>(i)] = true;
  }
  return "";
}

/// How the scene after a change differs from what was asked for; empty: it doesn't.
inline std::string difference(Scene before, const MapChange& change, const Scene& after) {
  if (change.has_add_measure()) *before.add_measures() = change.add_measure();
  if (change.has_add_obstacle()) *before.add_obstacles() = change.add_obstacle();
  if (change.has_add_object()) *before.add_objects() = change.add_object();
  if (change.has_remove_measure())
    before.mutable_measures()->DeleteSubrange(static_cast<int>(change.remove_measure()), 1);
  if (change.has_remove_obstacle())
    before.mutable_obstacles()->DeleteSubrange(static_cast<int>(change.remove_obstacle()), 1);
  if (change.has_remove_object())
    before.mutable_objects()->DeleteSubrange(static_cast<int>(change.remove_object()), 1);
  if (change.has_replace_measure())
    *before.mutable_measures(static_cast<int>(change.replace_measure().index())) =
        change.replace_measure().measure();
  if (change.has_replace_obstacle()) {
    Obstacle& replaced = *before.mutable_obstacles(static_cast<int>(change.replace_obstacle().index()));
    const Obstacle was = replaced;
    replaced = change.replace_obstacle().obstacle();
    // It takes the route along that it has, whatever was asked for.
    *replaced.mutable_route() = was.route();
    replaced.set_speed(was.speed());
    for (Point& point : *replaced.mutable_route()) {
      point.set_x(point.x() + (replaced.x() - was.x()));
      point.set_y(point.y() + (replaced.y() - was.y()));
    }
  }
  if (change.has_replace_object())
    *before.mutable_objects(static_cast<int>(change.replace_object().index())) =
        change.replace_object().object();
  if (change.has_set_area()) {
    before.set_width(change.set_area().width());
    before.set_height(change.set_area().height());
  }
  if (!is_near(before.width(), after.width()) || !is_near(before.height(), after.height()))
    return "another area";
  std::string measures = missing(before.measures(), after.measures());
  if (!measures.empty()) return measures;
  std::string obstacles = missing(before.obstacles(), after.obstacles());
  return obstacles.empty() ? missing(before.objects(), after.objects()) : obstacles;
}

}  // namespace mlab::console::testing
