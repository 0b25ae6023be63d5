#pragma once

#include <string>
#include <vector>

#include "mlab/geom/pose.h"
#include "mlab/viewers.pb.h"

// Pieces of a scene. World points lie on the ground; heights are only for the eye [m].
namespace mlab::viewers {

foxglove::Pose pose_of(geom::Point at, double heading = 0.0, double height = 0.0);
/// A disc that stands up.
void add_cylinder(foxglove::SceneEntity& entity, geom::Point at, double radius, double height,
                  const foxglove::Color& color);
/// @param thickness  [m]; 0: as thin as can be seen
void add_line(foxglove::SceneEntity& entity, const std::vector<geom::Point>& points, bool is_closed,
              double thickness, const foxglove::Color& color);
void add_text(foxglove::SceneEntity& entity, geom::Point at, double height, double size,
              const std::string& text, const foxglove::Color& color);
/// Bytes of whatever encoding as text that a message may hold.
std::string utf8_of(const std::string& bytes);

}  // namespace mlab::viewers
