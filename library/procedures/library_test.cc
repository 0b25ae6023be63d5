#include "mlab/library/library.h"

#include <cmath>
#include <cstring>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"
#include "mlab/base/random.h"

namespace mlab::library_test {
namespace {

using flow::Behavior;
using flow::Input;
using flow::TypeKind;

TEST(Library, FindsEveryBehaviorUnderEveryName) {
  std::set<std::string_view> names;
  for (const Behavior* b : mlab_library_behaviors()) {
    EXPECT_TRUE(names.insert(b->name).second) << b->name << " is there twice";
    for (const flow::Alias& alias : b->aliases)
      EXPECT_TRUE(names.insert(alias.name).second) << alias.name << " is there twice";
  }
  for (const std::string_view name : names) EXPECT_NE(library().find(name).behavior, nullptr) << name;
}

TEST(Library, ExplainsEveryBehaviorAndInput) {
  for (const Behavior* b : mlab_library_behaviors()) {
    EXPECT_GT(b->help.size(), 9U) << b->name;
    for (const Input& input : b->inputs) EXPECT_FALSE(input.help.empty()) << b->name << "." << input.name;
  }
}

TEST(Library, HasDefaultsOfTheRightTypeAndRange) {
  for (const Behavior* b : mlab_library_behaviors()) {
    for (const Input& input : b->inputs) {
      if (input.default_text.empty()) continue;
      std::vector<std::byte> value(input.type->size);
      ASSERT_NE(input.type->parse, nullptr) << b->name << "." << input.name;
      EXPECT_TRUE(input.type->parse(input.default_text, value.data())) << b->name << "." << input.name;
      if (input.type->kind != TypeKind::kReal) continue;
      double number = 0.0;
      std::memcpy(&number, value.data(), sizeof number);
      EXPECT_LE(input.min, number) << b->name << "." << input.name;
      EXPECT_GE(input.max, number) << b->name << "." << input.name;
    }
  }
}

// Every historic procedure of the 1995 report, or needed by one of its examples, that is no operator of the
// language.
TEST(Library, AnswersToTheHistoricNames) {
  constexpr std::pair<const char*, const char*> kNames[] = {
      {"GET_LOCATION", "GetPose"},
      {"SHAFTENCODERS", "GetPose"},
      {"SENSE_LOCATION", "GetPose"},
      {"GET_XY", "GetPosition"},
      {"GET_HEADING", "GetHeading"},
      {"DETECT_OBSTACLES", "DetectObstacles"},
      {"ULTRASONICS", "DetectObstacles"},
      {"DETECT_ROBOTS", "DetectRobots"},
      {"DETECT_OBJECTS", "DetectObjects"},
      {"REMOVE_ROBOTS", "RemoveRobots"},
      {"CLOSEST_OBSTACLE", "ClosestObstacle"},
      {"CLOSEST_OBJECT", "ClosestObject"},
      {"OBJECT_LOCATION", "ObjectLocation"},
      {"FILTER_OBJECTS", "FilterObjectsByColor"},
      {"FILTER_OBJECT_CLASSES", "FilterObjectsByColor"},
      {"FILTER_OBJECTS_BY_CLASS", "FilterObjectsByClass"},
      {"COUNT_OBJECTS", "CountObjects"},
      {"EXTRACT_GOAL", "GetOrderGoal"},
      {"DETECT_GOAL_WITH_SHAFT_ENCODERS", "DetectGoal"},
      {"GLOBAL_TO_EGOCENTRIC", "GlobalToEgocentric"},
      {"PROJECTED_GOAL", "ProjectGoal"},
      {"DETECT_CENTER_OF_MASS", "CenterOfRobots"},
      {"DETECT_UNIT_CENTER", "DetectUnitCenter"},
      {"COMPUTE_UNIT_CENTER", "CenterOfObjects"},
      {"DETECT_FORM_HEADING", "DetectFormationHeading"},
      {"DETECT_FORM_POSITION", "DetectFormationPosition"},
      {"COMPUTE_FORM_POSITION", "ComputeFormationPosition"},
      {"MAINTAIN_FORM", "MaintainFormation"},
      {"DETECT_IN_POSITION", "InPosition"},
      {"MOVE_TO_GOAL", "MoveToGoal"},
      {"MOVE_TO", "MoveTo"},
      {"MOVE_TO_GUARDED", "MoveToGuarded"},
      {"MOVE_AHEAD", "MoveAhead"},
      {"MOVE_FORWARD", "MoveForward"},
      {"NOOP", "Stand"},
      {"NULL_MS", "Stand"},
      {"STAY_ON_PATH", "StayOnPath"},
      {"AVOID_STATIC_OBSTACLES", "AvoidStaticObstacles"},
      {"AVOID_OBSTACLES", "AvoidStaticObstacles"},
      {"AVOID_OBJECTS", "AvoidObjects"},
      {"AVOID_ROBOT", "AvoidRobots"},
      {"SWIRL_STATIC_OBSTACLES", "SwirlObstacles"},
      {"PROBE", "Probe"},
      {"MOVE_TO_FREE_SPACE", "MoveToFreeSpace"},
      {"NOISE", "Noise"},
      {"TELOP", "Teleoperate"},
      {"SPIN", "Spin"},
      {"SUM_WEIGHTED_VECTORS", "WeightedSum"},
      {"COOP", "WeightedSum"},
      {"SUBTRACT_VECTORS", "SubtractVectors"},
      {"SCALE_VECTOR", "ScaleVector"},
      {"SUM", "SumIntegers"},
      {"SUM_DOUBLE", "Sum"},
      {"EXECUTIVE", "Executive"},
      {"PUT_STATUS", "ReportFlags"},
      {"DRIVE", "Drive"},
      {"MOVE_ROBOT", "Drive"},
      {"MRV2_DRIVE", "Drive"},
      {"DRIVE_W_SPIN", "DriveAndSpin"},
      {"IS_AT_GOAL", "IsAtGoal"},
      {"IS_AN_OBJECT", "IsAnyObject"},
      {"IS_VALID_OBJECT", "IsValidObject"},
      {"pt_attractor_present", "Detect"},
      {"pt_holding_attractor", "Holding"},
      {"CONSTANT", "Constant"},
      {"FIRST_TIME", "Constant"},
      {"WAIT", "Wait"},
      {"WAIT_FOR_PROCEED", "AskToProceed"},
      {"ISFACING", "IsFacing"},
      {"HAS_TURNED", "HasTurned"},
      {"MOVED_DISTANCE", "MovedDistance"},
      {"HAS_STOPPED", "HasStopped"},
      {"V_IS_ZERO", "IsZero"},
      {"EQUAL_INT", "EqualIntegers"},
      {"AND", "And"},
      {"OR", "Or"},
      {"NOR", "Nor"},
      {"NOT", "Not"},
      {"NOTIFY", "NotifySelf"},
      {"NOTIFY_ROBOTS", "Notify"},
      {"NOTIFIED_ONCE", "NotifiedOnce"},
      {"PICKUP_OBJECT", "PickUp"},
      {"DROP_IN_BASKET", "DropInBasket"},
      {"DROP_OBJECT", "Drop"}};
  for (const auto& [historic, name] : kNames) {
    const flow::Library::Entry found = library().find(historic);
    ASSERT_NE(found.behavior, nullptr) << historic;
    EXPECT_EQ(found.behavior->name, name);
    EXPECT_NE(found.alias, nullptr) << historic;
  }
}

TEST(Library, TakesAnglesInDegreesUnderHistoricNames) {
  for (const Behavior* b : mlab_library_behaviors()) {
    for (std::size_t i = 0; i < b->inputs.size(); ++i) {
      if (b->inputs[i].unit != "rad") continue;
      for (const flow::Alias& alias : b->aliases) {
        ASSERT_LT(i, alias.inputs.size()) << alias.name;
        EXPECT_EQ(alias.inputs[i].unit, "deg") << alias.name << "." << alias.inputs[i].name;
      }
    }
  }
}

// A random value for any port: what robots meet, and now and then something extreme.
class AnyValue {
 public:
  explicit AnyValue(std::uint64_t seed) : random_(seed) {}

  double number(double min, double max) {
    constexpr double kUsual[] = {0.0, 1.0, -1.0, 0.5, 1e-9, 1e12, -1e12, std::numbers::pi};
    const double value = random_.below(4) == 0 ? kUsual[random_.below(8)] : random_.uniform(-100.0, 100.0);
    return std::fmin(std::fmax(value, min), max);
  }
  double number() { return number(-1e13, 1e13); }
  geom::Vector vector() { return {number(), number(), random_.below(2) == 0 ? 0.0 : number()}; }
  geom::Point point() { return {number(), number()}; }
  bool yes() { return random_.below(2) == 0; }
  std::uint32_t below(std::uint64_t n) { return static_cast<std::uint32_t>(random_.below(n)); }

 private:
  base::Random random_;
};

template <class T>
void set(flow::BehaviorProbe& p, const Input& input, T value) {
  if constexpr (!std::is_same_v<T, bool>) {
    if (input.is_list) {
      p.set_list<T>(input.name, {value, value});
      return;
    }
  }
  p.set<T>(input.name, value);
}

ways::PlannedWay any_way(AnyValue& any) {
  ways::PlannedWay out;
  out.count = static_cast<std::uint16_t>(any.below(4));
  for (std::uint16_t i = 0; i < out.count; ++i) out.corners[i] = any.point();
  out.version = static_cast<std::uint16_t>(any.below(3));
  out.clearance = std::abs(any.number());
  return out;
}

void set_any(flow::BehaviorProbe& p, const Input& input, AnyValue& any) {
  const std::string_view type = input.type->name;
  if (type == "bool") set<bool>(p, input, any.yes());
  if (type == "int")
    set<int>(p, input, static_cast<int>(any.number(std::fmax(input.min, -1e9), std::fmin(input.max, 1e9))));
  if (type == "double") set<double>(p, input, any.number(input.min, input.max));
  if (type == "Vector") set<geom::Vector>(p, input, any.vector());
  if (type == "Point") set<geom::Point>(p, input, any.point());
  if (type == "Pose") set<geom::Pose>(p, input, {any.point(), any.number()});
  if (type == "Obstacles") set<flow::Obstacles>(p, input, all<flow::Obstacles>(p.percepts.obstacles.size()));
  if (type == "Robots") set<flow::Robots>(p, input, all<flow::Robots>(p.percepts.robots.size()));
  if (type == "Objects") set<flow::Objects>(p, input, all<flow::Objects>(p.percepts.objects.size()));
  if (type == "Ranges") set<flow::Ranges>(p, input, {static_cast<std::uint16_t>(p.percepts.ranges.size())});
  if (type == "Way") set<ways::PlannedWay>(p, input, any_way(any));
  if (type == "Formation") set<percept::Formation>(p, input, static_cast<percept::Formation>(any.below(10)));
  if (type == "ObjectClasses") set<flow::ObjectClasses>(p, input, {any.below(2048)});
  if (type == "FormationReference")
    set<percept::FormationReference>(p, input, static_cast<percept::FormationReference>(any.below(3)));
}

// The readings that the percepts of one cycle point to.
struct Surroundings {
  std::vector<percept::Obstacle> obstacles;
  std::vector<percept::RobotReading> robots;
  std::vector<percept::ObjectReading> objects;
  std::vector<percept::RangeReading> ranges;
  std::vector<geom::Point> route;

  explicit Surroundings(AnyValue& any) {
    for (std::uint32_t n = any.below(4); n > 0; --n) {
      obstacles.push_back({any.vector(), std::abs(any.number())});
      robots.push_back({.id = {n}, .center = any.vector(), .heading = any.number()});
      objects.push_back({.id = {n},
                         .object_class = static_cast<percept::ObjectClass>(any.below(11)),
                         .center = any.vector(),
                         .radius = std::abs(any.number())});
      ranges.push_back(
          {static_cast<float>(any.number()), static_cast<float>(std::abs(any.number())), any.yes()});
      route.push_back(any.point());
    }
  }

  void fill(percept::Percepts& p, AnyValue& any) const {
    p.pose = {any.point(), any.number()};
    p.obstacles = obstacles;
    p.robots = robots;
    p.objects = objects;
    p.ranges = ranges;
    p.range_limit = std::abs(any.number());
    p.carried = {any.below(2)};
    p.order = {.sequence = any.below(3),
               .task = static_cast<percept::Task>(any.below(8)),
               .goal = any.point(),
               .route = route,
               .formation = static_cast<percept::Formation>(any.below(10)),
               .heading = any.number(),
               .has_heading = any.yes(),
               .speed = std::abs(any.number()),
               .halted = any.yes()};
    const auto size = static_cast<std::uint16_t>(1 + any.below(9));
    p.unit = {.size = size,
              .rank = static_cast<std::uint16_t>(any.below(size)),
              .center = any.point(),
              .center_step = {any.number(), any.number()},
              .leader = {any.point(), any.number()},
              .neighbor = {any.point(), any.number()},
              .formation_heading = any.number()};
    p.joystick = {
        .x = any.number(), .y = any.number(), .magnitude = any.number(), .is_robot_frame = any.yes()};
  }
};

template <class T>
bool is_finite_as(const Behavior& b, const flow::BehaviorProbe& p) {
  return b.output->name != flow::type_info<T>().name || b.output->is_finite(&p.output<T>());
}

bool is_output_finite(const Behavior& b, const flow::BehaviorProbe& p) {
  return b.output == nullptr || (is_finite_as<double>(b, p) && is_finite_as<geom::Vector>(b, p) &&
                                 is_finite_as<geom::Point>(b, p) && is_finite_as<geom::Pose>(b, p));
}

TEST(Library, NeverMakesANumberThatIsNone) {
  for (const Behavior* b : mlab_library_behaviors()) {
    // What is divided by zero is none: that is told, and the robot stops (not_a_number_test.cc).
    if (b->name == "DivideNumbers" || b->name == "DivideVector") continue;
    AnyValue any(base::hash_text(b->name));
    flow::BehaviorProbe p(*b);
    for (int i = 0; i < 500; ++i) {
      const Surroundings around(any);
      around.fill(p.percepts, any);
      p.action = {};
      for (const Input& input : b->inputs) set_any(p, input, any);
      p.step();
      const geom::Vector v = p.action.velocity;
      ASSERT_TRUE(std::isfinite(v.x + v.y + p.action.spin + p.action.status.remaining))
          << b->name << " in cycle " << i;
      ASSERT_TRUE(is_output_finite(*b, p)) << b->name << " in cycle " << i;
    }
  }
}

TEST(FindRobot, KnowsTheHistoricStockRobots) {
  for (const char* name : {"standard", "robot", "ROBOT", "mlab-2.0-robot", "tmr_robot-1998"}) {
    EXPECT_EQ(library::find_robot(name), "Scout") << name;
  }
  EXPECT_EQ(library::find_robot("forager"), "");
  EXPECT_EQ(library::find_robot(""), "");
}

}  // namespace
}  // namespace mlab::library_test
