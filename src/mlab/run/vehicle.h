#pragma once

#include <map>
#include <string>
#include <vector>

#include "mlab/binding/body.h"
#include "mlab/mission/mission.h"
#include "mlab/text/diagnostic.h"

namespace mlab::run {

/// The body that a robot type has in simulation, from its NEW-ROBOT parameters:
///
/// - robot_type: HOLONOMIC (unless said otherwise), DIFFERENTIAL, SYNCHRO, CAR; historic: SIMULATION, MRV2,
/// DRV1, HSERVER
///   (holonomic), NO_HOLONOMIC (car)
/// - robot_radius: of the body, 0.2 [m]
/// - max_acceleration, max_turn_rate, max_turn_acceleration: 0, no limit [m/s^2], [deg/s], [deg/s^2]
/// - axle, max_wheel_speed: differential drive, 0.4 and 0, no limit [m], [m/s]
/// - wheelbase, max_steer: car, 1.25 and 75 [m], [deg]
/// - ring_count, ring_range, ring_beam_width, ring_noise, ring_dropout: range sensors, 0, 5, 0, 0, 0: number,
///   [m], [deg], [m], share
/// - ring_arc: over which the range sensors are spread, ahead in the middle, 0, all round [deg]
/// - ring_obstacles: 1 where obstacles are what the range sensors hit; odometry_noise: 0, the pose is exact
/// - camera_field_of_view, camera_max_pan, camera_pan_rate: what sees objects, 360, 180 to each side, 0, no
/// limit
///   [deg], [deg], [deg/s]
/// - radio_range, radio_loss: how far it is heard, and what of it is lost, 0, everywhere, and 0 [m], share
///
/// @errors  a value of one of these keys that is no number or out of range
/// @param configured  what the class of a configured robot says of its body, by the same keys, in SI units;
///                    `radius` for robot_radius, `drive` as the number of a binding::Drive. Parameters win
binding::BodySpec body_of(const mission::RobotType& type, const std::map<std::string, double>& configured,
                          text::Diagnostics& sink);

/// All keys that are not the program's: those of `body_of`, and the historic ones of hardware that simulation
/// ignores.
const std::vector<std::string>& vehicle_keys();

}  // namespace mlab::run
