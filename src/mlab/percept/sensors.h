#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "mlab/base/table.h"

namespace mlab::percept {

/// What senses only where somebody asks for it. All else of `Percepts` is always told.
enum class Sensor : std::uint8_t { kObstacles, kRobots, kObjects, kRanges, kTouch, kGround, kRadio };

/// All that is to be known of a sensor but how it senses. CNL, `mlab describe`, completion, messages between
/// processes, recordings and the documentation take it from here; `tools/tables` writes what is not C++.
struct SensorInfo {
  Sensor sensor;
  std::string_view name;   ///< one word in small letters: `senses NAME`
  bool has_own_reach;      ///< it senses as far as it is built to; else who asks says how far
  bool is_told;            ///< by who carries the mission out; no device senses it
  std::string_view label;  ///< in messages: `range sensors`
  std::string_view tells;  ///< for the documentation, in Markdown: what the simulator's tells
};

/// By their numbers.
inline constexpr std::array kSensors = {
    SensorInfo{
        Sensor::kObstacles, "obstacles", false, false, "obstacles",
        "every disc whose centre is within range + radius, exactly; discs hide nothing. Walls: 16 rays, "
        "22.5 degrees apart from the heading, from the robot's centre; the nearest hit of each within "
        "range as a disc of 0.1 m at the place that was hit. Those that move have their `velocity`, over the "
        "ground, in the robot's frame. Sorted by distance of the edge"},
    SensorInfo{
        Sensor::kRobots, "robots", false, false, "robots",
        "all others with their centre within range, unless a wall crosses the line between the centres. "
        "Sorted by distance of the centre"},
    SensorInfo{
        Sensor::kObjects, "objects", false, false, "objects",
        "objects, robots and obstacles with their centre in range and in the camera's field of view, not "
        "behind a wall; nothing that is carried or lies in a basket. Sorted by distance of the edge. "
        "Robots and obstacles have ids of their own ranges (`kRobotObjectBase`, `kDiscObjectBase`, "
        "`kRoamerObjectBase` of those that move)"},
    SensorInfo{
        Sensor::kRanges, "ranges", true, false, "range sensors",
        "a ring of `count` beams, beam i at first_angle + i 2 pi / count (with an `arc`: spread over it, "
        "ahead in the middle), from the body's surface; they see walls, discs and robots, not objects"},
    SensorInfo{
        Sensor::kTouch, "touch", true, false, "touch sensors",
        "the direction of the nearest disc, wall or robot whose edge is less than 1 cm from the body's, "
        "as a vector of length 1 in the robot's frame; of length 0 where nothing is. Every body has it"},
    SensorInfo{
        Sensor::kGround, "ground", true, true, "known ground",
        "what robots know to stand on the ground, near or far: obstacles, walls and the edges of areas to "
        "keep out of that the overlay has, and obstacles that robots of the team have sensed. Told, not "
        "sensed"},
    SensorInfo{
        Sensor::kRadio, "radio", true, false, "radio",
        "all others whose radio is heard, wherever they are, with the strength of the signal in percent "
        "(`radio_range` of the body, and zones without; docs/simulator.md has the law). Sorted by strength, "
        "then distance; of more than 64 the first. Every body has it"},
};
static_assert(base::has_a_row_for_each<kSensors, &SensorInfo::sensor>());

constexpr const SensorInfo& info(Sensor sensor) {
  return base::row_of(kSensors, &SensorInfo::sensor, sensor);
}

/// Null where there is none of the name.
constexpr const SensorInfo* sensor_named(std::string_view name) {
  for (const SensorInfo& sensor : kSensors) {
    if (sensor.name == name) return &sensor;
  }
  return nullptr;
}

}  // namespace mlab::percept
