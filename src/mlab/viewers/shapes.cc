#include "mlab/viewers/shapes.h"

#include <cmath>

#include "mlab/text/shown.h"

namespace mlab::viewers {
namespace {

constexpr double kThinnest = 2.0;  // pixels
constexpr std::size_t kMostOfText = 400;

}  // namespace

foxglove::Pose pose_of(geom::Point at, double heading, double height) {
  foxglove::Pose out;
  out.mutable_position()->set_x(at.x);
  out.mutable_position()->set_y(at.y);
  out.mutable_position()->set_z(height);
  out.mutable_orientation()->set_z(std::sin(0.5 * heading));
  out.mutable_orientation()->set_w(std::cos(0.5 * heading));
  return out;
}

void add_cylinder(foxglove::SceneEntity& entity, geom::Point at, double radius, double height,
                  const foxglove::Color& color) {
  foxglove::CylinderPrimitive& out = *entity.add_cylinders();
  *out.mutable_pose() = pose_of(at, 0.0, 0.5 * height);
  out.mutable_size()->set_x(2.0 * radius);
  out.mutable_size()->set_y(2.0 * radius);
  out.mutable_size()->set_z(height);
  out.set_bottom_scale(1.0);
  out.set_top_scale(1.0);
  *out.mutable_color() = color;
}

void add_line(foxglove::SceneEntity& entity, const std::vector<geom::Point>& points, bool is_closed,
              double thickness, const foxglove::Color& color) {
  foxglove::LinePrimitive& out = *entity.add_lines();
  out.set_type(is_closed ? foxglove::LinePrimitive::LINE_LOOP : foxglove::LinePrimitive::LINE_STRIP);
  *out.mutable_pose() = pose_of({});
  out.set_thickness(thickness > 0.0 ? thickness : kThinnest);
  out.set_scale_invariant(thickness <= 0.0);
  for (const geom::Point& point : points) {
    foxglove::Point3& added = *out.add_points();
    added.set_x(point.x);
    added.set_y(point.y);
  }
  *out.mutable_color() = color;
}

void add_text(foxglove::SceneEntity& entity, geom::Point at, double height, double size,
              const std::string& text, const foxglove::Color& color) {
  foxglove::TextPrimitive& out = *entity.add_texts();
  *out.mutable_pose() = pose_of(at, 0.0, height);
  out.set_billboard(true);
  out.set_font_size(size);
  out.set_scale_invariant(true);
  *out.mutable_color() = color;
  out.set_text(utf8_of(text));
}

std::string utf8_of(const std::string& bytes) {
  return text::shown(bytes, kMostOfText);
}

}  // namespace mlab::viewers
