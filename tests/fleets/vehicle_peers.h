#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fleets.h"

namespace mlab::testing {

/// A vehicle that is played by somebody else's implementation of its protocol, on a host of the network, and
/// tells what it really does, by its own time: which waits where the machine gives it none.
class VehiclePeer {
 public:
  struct Moment {
    double time = 0.0;      ///< since it was switched on [s]
    double x = 0.0;         ///< [m, in a frame of its own]
    double y = 0.0;         ///< [m]
    double speed = 0.0;     ///< [m/s]
    bool stands = true;     ///< nor does it turn
    double stood_at = 0.0;  ///< when it came to stand last [s]
  };

  VehiclePeer() = default;
  VehiclePeer(const VehiclePeer&) = delete;
  VehiclePeer& operator=(const VehiclePeer&) = delete;
  virtual ~VehiclePeer() = default;

  virtual Moment now() = 0;
  /// How `mlab robot` reaches it from the same host.
  virtual std::vector<std::string> options() const = 0;
  /// From the next `mlab robot` on it is driven by its navigator, or not any more. Has no effect where it has
  /// none.
  virtual void drive_by_nav2(bool /*is_so*/) {}
  /// Waits until that says where it is, and would drive it.
  virtual bool is_known_to(const network::Process& robot) const = 0;
  /// So long after its last command it stands, as its binding states [s].
  virtual double standstill() const = 0;
  /// The same where it can be told to stop [s].
  virtual double standstill_when_told() const { return standstill(); }
  /// All that it said.
  virtual std::string said() const = 0;
};

/// tests/vehicles/ros2_robot, on Fast DDS, as /veh in domain 7.
/// @param world  overlay of what stands around it; empty: nothing does
/// @param at     X,Y,DEGREES
std::unique_ptr<VehiclePeer> start_ros2_robot(network::Host& host, const std::string& world,
                                              const std::string& at);
/// tests/vehicles/rover.mjs, on node-mavlink, in a world without obstacles.
std::unique_ptr<VehiclePeer> start_mavlink_rover(network::Host& host);

/// `mlab robot` beside it, as a member of the fleet `alpha`.
network::Process start_robot(network::Host& host, const std::string& name, const VehiclePeer& peer);

/// What a run that moves them is told.
inline const std::vector<std::string> kMovingVehicles = {"--real-time", "--unchecked", "they are played"};

/// Why the two can't be started on this machine; empty: they can.
std::string why_no_peers();

/// At the beginning of each test that needs both: skips it, and says why.
#define MLAB_NEEDS_PEERS() \
  if (const std::string reason = ::mlab::testing::why_no_peers(); !reason.empty()) GTEST_SKIP() << reason

}  // namespace mlab::testing
