#include "mlab/viewers/viewers.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include <fmt/core.h>

#include "mlab/base/hash.h"
#include "mlab/mission/wording.h"
#include "mlab/percept/object_classes.h"
#include "mlab/viewers/colors.h"
#include "mlab/viewers/shapes.h"

namespace mlab::viewers {
namespace {

constexpr const char* kMap = "map";
constexpr double kRobotHeight = 0.5;     // of bodies, for the eye [m]
constexpr double kObstacleHeight = 1.0;  // [m]
constexpr double kObjectHeight = 0.3;    // [m]
constexpr double kFontSize = 14.0;       // pixels
constexpr std::size_t kPointsOfPiece = 30;

std::string frame_of(base::RobotId robot) {
  return fmt::format("robot_{}", robot.value);
}

const mission::RobotType* type_of(const mission::Mission& mission, const fleet::FleetRobot& robot) {
  const auto found = std::ranges::find(mission.types, robot.type, &mission::RobotType::name);
  return found == mission.types.end() ? nullptr : &*found;
}

bool is_area(const overlay::ControlMeasure& measure) {
  return overlay::info(measure.kind).shape == overlay::MeasureShape::kRegion;
}

void add_measure(foxglove::SceneEntity& entity, const overlay::ControlMeasure& measure) {
  const bool is_solid = overlay::info(measure.kind).substance == overlay::Substance::kSolid;
  const foxglove::Color color = color_named(is_solid ? "darkgray" : "steelblue");
  if (measure.points.size() == 1) {
    const double radius = measure.size > 0.0 ? 0.5 * measure.size : 1.0;
    add_cylinder(entity, measure.points.front(), radius, 0.05, color_named("steelblue", 0.4));
  } else {
    add_line(entity, measure.points, is_area(measure), 0.0, color);
  }
  if (measure.shows_label && !measure.name.empty())
    add_text(entity, measure.center(), 0.5, kFontSize, measure.name, color_named("gray"));
}

bool is_number(geom::Point point) {
  return std::isfinite(point.x) && std::isfinite(point.y);
}

}  // namespace

google::protobuf::Timestamp Viewers::now() const {
  const double time = std::max(0.0, started_at_ + run_.time());
  google::protobuf::Timestamp out;
  out.set_seconds(static_cast<std::int64_t>(time));
  out.set_nanos(static_cast<std::int32_t>((time - std::floor(time)) * 1e9));
  return out;
}

foxglove::SceneEntity& Viewers::entity(foxglove::SceneUpdate& update, const std::string& id) const {
  foxglove::SceneEntity& out = *update.add_entities();
  out.set_frame_id(kMap);
  out.set_id(id);
  return out;
}

void Viewers::note_cycle() {
  // In the cycle that is nearest, so that rounding leaves out none.
  const double time = run_.time() + 0.5 * run_.cycle_duration();
  if (time >= next_scene_) {
    next_scene_ = std::max(next_scene_ + 1.0 / rates_.scene, run_.time());
    tell_map();
    tell_robots();
    tell_goals();
    tell_ways();
  }
  if (time < next_poses_) return;
  next_poses_ = std::max(next_poses_ + 1.0 / rates_.poses, run_.time());
  tell_poses();
}

void Viewers::tell_poses() {
  foxglove::FrameTransforms transforms;
  const google::protobuf::Timestamp time = now();
  for (const fleet::FleetRobot& robot : run_.fleet().robots()) {
    const geom::Pose pose = run_.fleet().pose(robot);
    if (robot.life == fleet::RobotLife::kNotStarted || !is_number(pose.position)) continue;
    const foxglove::Pose said = pose_of(pose.position, pose.heading);
    foxglove::FrameTransform& transform = *transforms.add_transforms();
    *transform.mutable_timestamp() = time;
    transform.set_parent_frame_id(kMap);
    transform.set_child_frame_id(frame_of(robot.id));
    *transform.mutable_translation() = said.position();
    *transform.mutable_rotation() = said.orientation();
    foxglove::PoseInFrame own;
    *own.mutable_timestamp() = time;
    own.set_frame_id(kMap);
    *own.mutable_pose() = said;
    sink_(fmt::format("/robots/{}/pose", robot.id.value), own);
  }
  if (transforms.transforms_size() > 0) sink_("/tf", transforms);
}

void Viewers::tell_map() {
  foxglove::SceneUpdate update;
  foxglove::SceneEntity& obstacles = entity(update, "obstacles");
  for (const binding::Disc& disc : run_.world().discs())
    add_cylinder(obstacles, disc.center, disc.radius, kObstacleHeight, color_named("sienna"));
  for (const binding::MovingDisc& disc : run_.world().moving_discs())
    add_cylinder(obstacles, disc.center, disc.radius, kObstacleHeight, color_named("sienna"));
  foxglove::SceneEntity& walls = entity(update, "walls");
  for (const binding::Wall& wall : run_.world().walls()) {
    if (wall.is_solid) add_line(walls, {wall.segment.a, wall.segment.b}, false, 0.1, color_named("darkgray"));
  }
  const overlay::Area area = run_.mission().overlay.mission_area();
  add_line(entity(update, "area"),
           {{0.0, 0.0}, {area.width, 0.0}, {area.width, area.height}, {0.0, area.height}}, true, 0.0,
           color_named("gray"));
  std::map<std::string, int> names;  // of which there may be several
  for (const overlay::ControlMeasure& measure : run_.mission().overlay.measures) {
    if (measure.points.empty()) continue;
    const std::string name = fmt::format("measure/{}", utf8_of(measure.name));
    const int count = ++names[name];
    add_measure(entity(update, count == 1 ? name : fmt::format("{}#{}", name, count)), measure);
  }
  for (const binding::Object& object : run_.world().objects()) {
    if (object.carrier.value != 0 || object.basket.value != 0) continue;
    const auto& known = percept::kObjectClasses[static_cast<std::size_t>(object.object_class)];
    add_cylinder(entity(update, fmt::format("object/{}", object.id.value)), object.center, object.radius,
                 kObjectHeight, color_named(known.color_word));
  }
  send_scene("/scene", update);
}

void Viewers::tell_robots() {
  foxglove::SceneUpdate update;
  for (const fleet::FleetRobot& robot : run_.fleet().robots()) {
    if (robot.life == fleet::RobotLife::kNotStarted) continue;
    foxglove::SceneEntity& out = entity(update, fmt::format("robot/{}", robot.id.value));
    out.set_frame_id(frame_of(robot.id));
    out.set_frame_locked(true);
    const mission::RobotType* const type = type_of(run_.mission(), robot);
    const foxglove::Color color = color_named(type == nullptr ? "blue" : type->color);
    const double radius = robot.capabilities.radius;
    add_cylinder(out, {}, radius, kRobotHeight, color);
    foxglove::ArrowPrimitive& ahead = *out.add_arrows();
    *ahead.mutable_pose() = pose_of({}, 0.0, kRobotHeight);
    ahead.set_shaft_length(1.5 * radius);
    ahead.set_shaft_diameter(0.3 * radius);
    ahead.set_head_length(0.5 * radius);
    ahead.set_head_diameter(0.6 * radius);
    *ahead.mutable_color() = color;
    add_text(out, {}, 2.0 * kRobotHeight, kFontSize, std::to_string(robot.id.value), color_named("gray"));
    foxglove::KeyValuePair& state = *out.add_metadata();
    state.set_key("state");
    state.set_value(std::string(fleet::name(robot.life)));
    foxglove::KeyValuePair& kind = *out.add_metadata();
    kind.set_key("type");
    kind.set_value(utf8_of(robot.type));
  }
  send_scene("/scene/robots", update);
}

void Viewers::tell_goals() {
  foxglove::SceneUpdate update;
  for (const mission::Group& group : run_.state().groups) {
    if (group.command.value == nullptr || group.task == percept::Task::kNone ||
        group.task == percept::Task::kStop || !is_number(group.goal))
      continue;
    foxglove::SceneEntity& out = entity(update, fmt::format("goal/{}", group.sequence));
    add_cylinder(out, group.goal, 0.5, 0.1, color_named("limegreen", 0.7));
    add_text(out, group.goal, 1.0, kFontSize, mission::command_text(run_.mission(), *group.command),
             color_named("limegreen"));
  }
  send_scene("/scene/goals", update);
}

void Viewers::tell_ways() {
  foxglove::SceneUpdate update;
  for (const fleet::FleetRobot& robot : run_.fleet().robots()) {
    const geom::Point at = run_.fleet().pose(robot).position;
    if (robot.life == fleet::RobotLife::kNotStarted || !is_number(at)) continue;
    Way& way = ways_[robot.id.value];
    if (!way.points.empty() && geom::distance(way.points.back(), at) < 1e-3) continue;
    way.points.push_back(at);
    if (way.points.size() < kPointsOfPiece) continue;
    const mission::RobotType* const type = type_of(run_.mission(), robot);
    foxglove::SceneEntity& out = entity(update, fmt::format("way/{}/{}", robot.id.value, ++way.piece));
    *out.mutable_timestamp() = now();
    add_line(out, way.points, false, 0.0, color_named(type == nullptr ? "blue" : type->color, 0.6));
    way.points = {at};
  }
  if (update.entities_size() > 0) sink_("/scene/ways", update);
}

void Viewers::send_scene(const std::string& topic, foxglove::SceneUpdate& update) {
  // Without its time: what only is later is not another scene.
  const std::uint64_t hash = base::hash_text(update.SerializeAsString());
  const auto [known, is_first] = sent_.try_emplace(topic);
  Sent& sent = known->second;
  if (!is_first && sent.hash == hash) return;
  sent.hash = hash;
  std::vector<std::string> ids;
  for (foxglove::SceneEntity& one : *update.mutable_entities()) {
    *one.mutable_timestamp() = now();
    ids.push_back(one.id());
  }
  std::ranges::sort(ids);
  for (const std::string& id : sent.ids) {
    if (std::ranges::binary_search(ids, id)) continue;
    foxglove::SceneEntityDeletion& gone = *update.add_deletions();
    *gone.mutable_timestamp() = now();
    gone.set_id(id);
  }
  sent.ids = std::move(ids);
  sink_(topic, update);
}

void Viewers::see(const mission::Effect& effect) {
  const auto* told = std::get_if<mission::effect::Tell>(&effect);
  const auto* asked = std::get_if<mission::effect::Ask>(&effect);
  if (told == nullptr && asked == nullptr) return;
  foxglove::Log log;
  *log.mutable_timestamp() = now();
  const bool is_warning = told != nullptr && told->kind == mission::effect::Tell::Kind::kWarning;
  log.set_level(is_warning ? foxglove::Log::WARNING : foxglove::Log::INFO);
  log.set_message(utf8_of(told != nullptr ? told->text : asked->text));
  log.set_name("mlab");
  sink_("/log", log);
}

}  // namespace mlab::viewers
