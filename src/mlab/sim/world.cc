#include "mlab/sim/world.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <tuple>

#include "mlab/overlay/barriers.h"
#include "mlab/percept/object_colors.h"

namespace mlab::sim {
namespace {

using percept::ObjectStyle;

bool is_usable(geom::Point p) {
  return std::abs(p.x) <= World::kFarthest && std::abs(p.y) <= World::kFarthest;  // false for NaN
}
bool is_usable(double radius) {
  return radius >= 0.0 && radius <= World::kFarthest;
}
bool is_usable(const overlay::Course& course) {
  const std::vector<geom::Point>& points = course.points();
  return std::ranges::all_of(points, [](geom::Point p) { return is_usable(p); }) &&
         overlay::length_of(points) >= overlay::Course::kShortest &&  // false for NaN
         course.speed() > 0.0 && course.speed() <= World::kFarthest;
}

ObjectStyle style_of(overlay::ObjectStyle style) {
  switch (style) {
    case overlay::ObjectStyle::kMovable:
      return ObjectStyle::kMovable;
    case overlay::ObjectStyle::kContainer:
      return ObjectStyle::kContainer;
    case overlay::ObjectStyle::kFixed:
      break;
  }
  return ObjectStyle::kFixed;
}

void add_to_building(Building& building, const overlay::ControlMeasure& measure) {
  const std::vector<geom::Point>& points = measure.points;
  const bool is_sane = std::ranges::all_of(points, [](geom::Point p) { return is_usable(p); });
  const bool has_axis = measure.centerline.size() > 1 && is_usable(measure.centerline[0]) &&
                        is_usable(measure.centerline[1]) && is_usable(measure.size);
  if (measure.kind == overlay::MeasureKind::kDoor && is_sane && points.size() > 1)
    building.doors.push_back({points[0], points[1]});
  if (measure.kind == overlay::MeasureKind::kRoom && is_sane && points.size() > 2)
    building.rooms.push_back(points);
  if (measure.kind == overlay::MeasureKind::kHallway && has_axis)
    building.hallways.push_back({measure.centerline[0], measure.centerline[1], measure.size});
}

}  // namespace

MovingDisc Roamer::at(double time) const {
  const auto [place, velocity] = course.at(time);
  return {place, radius, velocity};
}

World world_of(const overlay::Overlay& overlay) {
  World world;
  const overlay::Area area = overlay.mission_area();
  world.area_low = {0.0, 0.0};
  world.area_high = {area.width, area.height};
  for (const overlay::ObstacleDisc& disc : overlay.obstacles) {
    if (disc.is_moving())
      world.roamers.push_back({overlay::course_of(disc), disc.radius});
    else
      world.discs.push_back({disc.center, disc.radius});
  }
  for (const overlay::Barrier& one : overlay::barriers(overlay))
    world.walls.push_back({one.segment, one.group, one.is_solid});
  for (const overlay::ControlMeasure& measure : overlay.measures) {
    add_to_building(world.building, measure);
    if (overlay::zone_kind(measure) == overlay::ZoneKind::kNoCommunication)
      world.silences.push_back(measure.points);
  }
  std::uint32_t id = 0;
  for (const overlay::WorldObject& object : overlay.objects) {
    Object& added = world.objects.emplace_back();
    added.id = {++id};
    added.object_class =
        percept::object_class_of_color(object.color).value_or(percept::ObjectClass::kUnknown);
    added.style = style_of(object.style);
    added.center = object.center;
    added.radius = object.diameter / 2;
    if (object.is_moving())
      world.travels.push_back({added.id, std::make_shared<const overlay::Course>(course_of(object))});
  }
  keep_usable(world);
  return world;
}

std::vector<base::ObjectId> same_objects(std::span<const Object> before, std::span<const Object> after) {
  const auto key = [](const Object& o) {
    return std::tuple(o.object_class, o.style, o.center.x, o.center.y, o.radius);
  };
  std::map<decltype(key(Object{})), std::deque<base::ObjectId>> waiting;
  for (const Object& object : before) waiting[key(object)].push_back(object.id);
  std::vector<base::ObjectId> out;
  for (const Object& object : after) {
    std::deque<base::ObjectId>& equal = waiting[key(object)];
    out.push_back(equal.empty() ? base::ObjectId{} : equal.front());
    if (!equal.empty()) equal.pop_front();
  }
  return out;
}

void keep_usable(World& world) {
  std::erase_if(world.discs, [](const Disc& d) { return !is_usable(d.center) || !is_usable(d.radius); });
  std::erase_if(world.roamers,
                [](const Roamer& roamer) { return !is_usable(roamer.course) || !is_usable(roamer.radius); });
  std::erase_if(world.walls,
                [](const Wall& w) { return !is_usable(w.segment.a) || !is_usable(w.segment.b); });
  std::erase_if(world.objects, [](const Object& o) { return !is_usable(o.center) || !is_usable(o.radius); });
  std::vector<base::ObjectId> ids;
  for (const Object& object : world.objects) ids.push_back(object.id);
  std::ranges::sort(ids);
  std::erase_if(world.travels, [&](const Travel& travel) {
    return !std::ranges::binary_search(ids, travel.object) || !is_usable(*travel.course);
  });
  const auto limited = [](geom::Point& p, double otherwise) {
    p.x = std::isnan(p.x) ? otherwise : std::clamp(p.x, -World::kFarthest, World::kFarthest);
    p.y = std::isnan(p.y) ? otherwise : std::clamp(p.y, -World::kFarthest, World::kFarthest);
  };
  limited(world.area_low, -World::kFarthest);
  limited(world.area_high, World::kFarthest);
}

}  // namespace mlab::sim
