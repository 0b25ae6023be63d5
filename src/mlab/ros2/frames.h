#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "mlab/geom/pose.h"
#include "mlab/ros2/messages.h"
#include "mlab/vehicle/device.h"

namespace mlab::ros2 {

/// A place and an orientation in another frame.
struct Placement {
  Vector3 translation;  ///< [m]
  Quaternion rotation;  ///< of length 1
};

/// @return  nothing: some number of it is none, or it is no rotation
std::optional<Placement> placement_of(const Vector3& translation, const Quaternion& rotation);
/// What is placed so within what is placed so.
Placement operator*(const Placement& outer, const Placement& inner);
Placement inverse(const Placement& placement);
/// Seen from above.
/// @return  nothing: what it turns ahead goes up or down more than sideways
std::optional<geom::Pose> flat(const Placement& placement);
/// Whether its top is below, and how far it is tilted otherwise [rad].
bool is_upside_down(const Placement& placement);
double tilt_of(const Placement& placement);

/// The frames of a robot, as `/tf` and `/tf_static` tell of them. At most kMostFrames are known; what is
/// told of others is left out.
class Frames {
 public:
  static constexpr std::size_t kMostFrames = 1000;

  void take(const Transform& transform, vehicle::Clock::time_point now);
  void forget() { parents_.clear(); }

  /// Where `frame` is within `within`; nothing: it is not known.
  /// @param since  what moves, and was told last before then, is not known any more
  std::optional<Placement> find(std::string_view frame, std::string_view within,
                                vehicle::Clock::time_point since) const;

 private:
  struct Parent {
    std::string name;
    Placement placement;
    bool is_static;
    bool is_own;
    vehicle::Clock::time_point at;
  };
  /// What is above a frame, and where the frame is in that.
  struct Root {
    std::string_view name;
    Placement placement;
  };
  Root root_of(std::string_view frame, vehicle::Clock::time_point since) const;

  std::map<std::string, Parent, std::less<>> parents_;
};

/// As all agree on since tf2: without a `/` before it.
std::string_view plain_frame(std::string_view frame);

}  // namespace mlab::ros2
