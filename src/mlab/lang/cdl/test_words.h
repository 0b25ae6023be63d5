#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "mlab/lang/cdl/test_percepts.h"
#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"

// What tests of components may say: what is sensed, and what is done. Parser, checks, completion, help and
// who runs them read these tables.

namespace mlab::cdl {

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
