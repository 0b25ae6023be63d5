#include "mlab/console/published/frame_encoder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mlab/console/published/wire.h"

namespace mlab::console {
namespace {

using fleet::FleetRobot;
using fleet::RobotLife;

struct Mark {
  std::uint32_t id;
  float x;
  float y;
};

struct ObjectMark {
  std::uint32_t id;
  float x;
  float y;
  std::uint32_t carrier;
};

std::uint8_t flags_of(const run::MissionRun& run, const FleetRobot& robot, const Alarms::Robot* alarm,
                      bool is_teleoperated) {
  const auto bit = [](bool is_set, int place) { return is_set ? 1U << place : 0U; };
  // RobotLife counts as the flags do: running 1, parked 2, stopped 3, faulted 4.
  const auto life = static_cast<unsigned>(robot.life);
  const percept::OrderStatus& status = robot.action.status;
  return static_cast<std::uint8_t>(life | bit(run.world().body(robot.body).in_contact, 3) |
                                   bit(alarm != nullptr && alarm->is_stuck, 4) | bit(is_teleoperated, 5) |
                                   bit(status.sequence != 0 && status.done, 6) |
                                   bit(alarm != nullptr && alarm->is_lost, 7));
}

}  // namespace

std::uint16_t packed_heading(double heading) {
  const double turns = heading / (2.0 * std::numbers::pi);
  return static_cast<std::uint16_t>(std::lround((turns - std::floor(turns)) * 65536.0) & 0xffff);
}

void RobotRows::gather(const run::MissionRun& run, const std::vector<Alarms::Robot>& alarms,
                       std::span<const base::RobotId> teleoperated) {
  rows_.clear();
  const std::vector<FleetRobot>& robots = run.fleet().robots();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const FleetRobot& robot = robots[i];
    if (robot.life == RobotLife::kNotStarted) continue;
    const geom::Pose pose = run.fleet().pose(robot);
    const bool is_teleoperated = std::ranges::binary_search(teleoperated, robot.id);
    rows_.push_back({robot.id.value, static_cast<float>(pose.position.x), static_cast<float>(pose.position.y),
                     packed_heading(pose.heading),
                     flags_of(run, robot, i < alarms.size() ? &alarms[i] : nullptr, is_teleoperated), 0});
  }
}

std::uint32_t RobotRows::encode(const std::optional<Box>& view, std::string& robots) const {
  if (!view) {
    robots.assign(reinterpret_cast<const char*>(rows_.data()), rows_.size() * sizeof(Row));
    return 0;
  }
  robots.clear();
  std::uint32_t left_out = 0;
  for (const Row& row : rows_) {
    const bool is_inside =
        row.x >= view->x_min() && row.x <= view->x_max() && row.y >= view->y_min() && row.y <= view->y_max();
    if (is_inside)
      append(robots, row);
    else
      ++left_out;
  }
  return left_out;
}

std::size_t count_not_started(const run::MissionRun& run) {
  return static_cast<std::size_t>(
      std::ranges::count(run.fleet().robots(), RobotLife::kNotStarted, &FleetRobot::life));
}

void encode_starts(const run::MissionRun& run, std::string& out) {
  for (const run::PlannedStart& start : run.planned_starts()) {
    const geom::Pose& pose = start.pose;
    append(out, RobotRows::Row{start.robot.value, static_cast<float>(pose.position.x),
                               static_cast<float>(pose.position.y), packed_heading(pose.heading), 0, 0});
  }
}

void encode_stations(const run::MissionRun& run, std::string& out) {
  for (const FleetRobot& robot : run.fleet().robots()) {
    if (robot.life != RobotLife::kRunning) continue;
    if (const auto place = run.fleet().station_place(robot))
      append(out, Mark{robot.id.value, static_cast<float>(place->x), static_cast<float>(place->y)});
  }
}

void encode_vectors(const run::MissionRun& run, std::string& out) {
  for (const FleetRobot& robot : run.fleet().robots()) {
    if (robot.life != RobotLife::kRunning) continue;
    const geom::Offset v = run.fleet().pose(robot).to_world(robot.action.velocity);
    append(out, Mark{robot.id.value, static_cast<float>(v.x), static_cast<float>(v.y)});
  }
}

void encode_objects(const run::MissionRun& run, std::string& out) {
  const auto& planned = run.mission().overlay.objects;
  const auto objects = run.world().objects();
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const binding::Object& object = objects[i];
    const bool stays = object.carrier.value == 0 && i < planned.size() && planned[i].center == object.center;
    if (stays) continue;
    append(out, ObjectMark{object.id.value, static_cast<float>(object.center.x),
                           static_cast<float>(object.center.y), object.carrier.value});
  }
}

}  // namespace mlab::console
