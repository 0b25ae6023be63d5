#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"

// What tests of components may say: what is sensed, and what is done. Parser, checks, completion, help and
// who runs them read these tables.

namespace mlab::cdl {

/// What a test tells a component that it senses.
enum class TestPercept : std::uint8_t {
  kSelf,
  kObstacle,
  kRobot,
  kObject,
  kCarrying,
  kOrder,
  kWaypoint,
  kUnit,
  kStick,
  kMessage,
  kCamera,
  kBeam,
  kSharedPlace,
  kClaim,
  kDoor,
  kHallway,
  kPlace
};

struct TestInput {
  std::string_view name;
  std::string_view type;     ///< as parameters have it: `length`, `Point`
  std::string_view initial;  ///< a constant of the type, in SI units; empty: it has to be given
  std::string_view help;
  double min = -1e300;
  double max = 1e300;
};

struct TestPerceptInfo {
  TestPercept percept;
  std::string_view name;  ///< `given NAME(...);`
  bool is_many;           ///< each `given` adds one; else it takes the place of the one before
  std::span<const TestInput> inputs;
  std::string_view help;
};

/// By their numbers.
std::span<const TestPerceptInfo> test_percepts();
/// Null where there is none of the name.
const TestPerceptInfo* test_percept_named(std::string_view name);

/// What can be done with an object: `style = "fixed"`.
struct TestObjectStyle {
  std::string_view name;
  percept::ObjectStyle style;
};
std::span<const TestObjectStyle> test_object_styles();
const TestObjectStyle* test_object_style_named(std::string_view name);

/// What a robot may do besides moving: `expect action PickUp;`
struct TestAction {
  std::string_view name;
  std::optional<percept::Request::Kind> request;  ///< nothing: it is told otherwise
  std::string_view help;
};
std::span<const TestAction> test_actions();
const TestAction* test_action_named(std::string_view name);
/// Whether the robot did that.
bool is_done(const TestAction& what, const percept::Action& action);

}  // namespace mlab::cdl
