#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "mlab/base/table.h"
#include "mlab/flow/type_info.h"

namespace mlab::flow {

/// The types of values that everybody knows. A library may bring more.
enum class ValueType : std::uint8_t {
  kBool,
  kInt,
  kDouble,
  kVector,
  kPoint,
  kPose,
  kObstacles,
  kRobots,
  kObjects,
  kObject,
  kRanges,
  kObjectClasses,
  kFormation,
  kFormationReference,
  kTask,
  kText,
  kWay
};

/// All that is to be known of a type but how its values are kept (`ValueTypes` in port_types.h) and read.
/// CNL, CDL, the designer, editors' grammars and the documentation take it from here; `tools/tables` writes
/// what is not C++.
struct ValueTypeInfo {
  ValueType type;
  std::string_view name;      ///< as CNL and CDL write it
  TypeKind kind;              ///< what a value looks like from outside
  std::string_view cpp;       ///< in the code of procedures, within `using namespace mlab::schema`
  std::string_view historic;  ///< what historic networks call it; empty: the same
  /// How wires show what flows in them: `movement`, `flag`, `number`, `percept`, `thing` or `text`.
  std::string_view look;
  bool is_for_parameters;   ///< offered for parameters of assemblages; others may be typed
  bool is_sensed;           ///< offered for what a binding point gives
  std::string_view format;  ///< how a person writes a value, where nobody could guess it
  /// The procedure of the library whose value stands where nothing is yet, and what that means.
  std::string_view neutral, neutral_means;
  /// What a component is given that is tried by itself, in CDL; empty: nobody can know.
  std::string_view sample;
  std::string_view help;  ///< for the documentation, in Markdown
};

// So that a row says what its yes and no are about.
inline constexpr bool kForParameters = true;
inline constexpr bool kSensed = true;

/// In the order in which they are offered.
inline constexpr std::array kValueTypes = {
    ValueTypeInfo{ValueType::kObstacles, "Obstacles", TypeKind::kList, "Obstacles", "obs_array", "percept",
                  !kForParameters, kSensed, "", "NoObstacles", "it sees none", "sense_obstacles()",
                  "readings of solid things in this cycle; seen as a list, made with `output.clear(); "
                  "output.add(index)`"},
    ValueTypeInfo{ValueType::kRobots, "Robots", TypeKind::kList, "Robots", "", "thing", !kForParameters,
                  kSensed, "", "NoRobots", "it sees none", "sense_robots()", "the same of other robots"},
    ValueTypeInfo{ValueType::kObjects, "Objects", TypeKind::kList, "Objects", "ObjectList", "thing",
                  !kForParameters, kSensed, "", "NoObjects", "it sees none", "sense_objects()",
                  "the same of objects"},
    ValueTypeInfo{ValueType::kObject, "Object", TypeKind::kOther, "ObjectReading", "ObjectReading", "thing",
                  kForParameters, kSensed, "", "NoObject", "it gives no object",
                  "ClosestObject(sense_objects())", "one object, or none"},
    ValueTypeInfo{ValueType::kPose, "Pose", TypeKind::kPose, "Pose", "robot_position", "percept",
                  !kForParameters, kSensed, "", "ZeroPose", "it is always the origin", "sense_location()",
                  "place and heading [rad]"},
    ValueTypeInfo{ValueType::kRanges, "Ranges", TypeKind::kList, "Ranges", "", "percept", !kForParameters,
                  kSensed, "", "NoRanges", "it measures nothing", "sense_ranges()",
                  "the ring of range sensors"},
    ValueTypeInfo{ValueType::kVector, "Vector", TypeKind::kVector, "Vector", "", "movement", kForParameters,
                  kSensed, "ahead, left", "Stand", "the robot stands still in its place",
                  "DetectGoal(goal = GetOrderGoal())",
                  "in the robot's frame: x ahead, y left [m, or share of full strength]"},
    ValueTypeInfo{ValueType::kPoint, "Point", TypeKind::kPoint, "Point", "", "percept", kForParameters,
                  kSensed, "x, y", "ZeroPoint", "it is always the origin", "",
                  "place in the world: x east, y north [m]"},
    ValueTypeInfo{ValueType::kWay, "Way", TypeKind::kOther, "PlannedWay", "", "percept", !kForParameters,
                  !kSensed, "", "NoWay", "there is none",
                  "PlanWay(from = GetOrderGoal(), goal = GetOrderGoal())",
                  "a planned way: its corners in the world, and the clearance that it keeps [m]"},
    ValueTypeInfo{ValueType::kBool, "bool", TypeKind::kBool, "bool", "boolean", "flag", !kForParameters,
                  kSensed, "", "Constant", "it is never true", "true", "`true`, `false`"},
    ValueTypeInfo{ValueType::kDouble, "double", TypeKind::kReal, "double", "float", "number", !kForParameters,
                  kSensed, "", "ZeroNumber", "it is always 0", "1", "number"},
    ValueTypeInfo{ValueType::kInt, "int", TypeKind::kInteger, "int", "", "number", !kForParameters, !kSensed,
                  "", "ZeroCount", "it is always 0", "1", "whole number"},
    ValueTypeInfo{ValueType::kObjectClasses, "ObjectClasses", TypeKind::kMask, "ObjectClasses",
                  "OneObjectClass", "thing", !kForParameters, !kSensed, "", "NoClasses", "it gives no class",
                  "", R"(set of classes: `"Flag\|Basket"`, `"AnyObject"`)"},
    ValueTypeInfo{ValueType::kFormation, "Formation", TypeKind::kChoice, "Formation", "gt_Formation",
                  "percept", !kForParameters, !kSensed, "", "NoFormation", "it gives none", "",
                  R"(`"Column"`, `"Wedge-Left"`)"},
    ValueTypeInfo{ValueType::kFormationReference, "FormationReference", TypeKind::kChoice,
                  "FormationReference", "", "percept", !kForParameters, !kSensed, "", "NoFormationReference",
                  "it gives the usual one", "", "what a formation is kept to: `\"Leader\"`"},
    ValueTypeInfo{ValueType::kTask, "Task", TypeKind::kChoice, "Task", "", "percept", !kForParameters,
                  !kSensed, "", "NoTask", "it gives none", "", "what an order wants: `\"MoveTo\"`"},
    ValueTypeInfo{ValueType::kText, "Text", TypeKind::kText, "Text", "CNLString_t", "text", !kForParameters,
                  !kSensed, "", "NoText", "it gives the empty text", "", "up to 63 bytes"},
};
static_assert(base::has_a_row_for_each<kValueTypes, &ValueTypeInfo::type>());

constexpr const ValueTypeInfo& info(ValueType type) {
  return base::row_of(kValueTypes, &ValueTypeInfo::type, type);
}
/// Null where the name is of no such type.
constexpr const ValueTypeInfo* value_type_named(std::string_view name) {
  for (const ValueTypeInfo& type : kValueTypes) {
    if (type.name == name) return &type;
  }
  return nullptr;
}

/// A word of configurations that says what values of a type mean: `length` is a real number in m.
struct QuantityInfo {
  std::string_view name;
  ValueType type;
  std::string_view unit;    ///< of its values; empty: none
  std::string_view sample;  ///< as of a type
  std::string_view help;    ///< for the documentation, in Markdown
};

/// In the order in which they are offered.
inline constexpr std::array kQuantities = {
    QuantityInfo{"gain", ValueType::kDouble, "", "1", "a share or a weight"},
    QuantityInfo{"number", ValueType::kDouble, "", "1", "a plain number"},
    QuantityInfo{"length", ValueType::kDouble, "m", "1 m", ""},
    QuantityInfo{"speed", ValueType::kDouble, "m/s", "1 m/s", ""},
    QuantityInfo{"angle", ValueType::kDouble, "rad", "0 deg", ""},
    QuantityInfo{"duration", ValueType::kDouble, "s", "1 s", ""},
    QuantityInfo{"turning", ValueType::kDouble, "rad/s", "0 deg/s", ""},
    QuantityInfo{"flag", ValueType::kBool, "", "true", "`true` or `false`"},
    QuantityInfo{"count", ValueType::kInt, "", "1", "a whole number"},
    QuantityInfo{"text", ValueType::kText, "", "", "`\"...\"`"},
    QuantityInfo{"object_class", ValueType::kObjectClasses, "", "Mine", R"(`Flag`, `"Flag\|Basket"`)"},
};
/// Null where there is none of that name.
constexpr const QuantityInfo* quantity_named(std::string_view name) {
  for (const QuantityInfo& quantity : kQuantities) {
    if (quantity.name == name) return &quantity;
  }
  return nullptr;
}

}  // namespace mlab::flow
