#pragma once

#include <string>

// What follows from mission::kFailsafeConditions and mission::kFailsafeActions.

namespace mlab::tables {

/// Each condition with its form and meaning, as a table of the documentation.
std::string failsafe_condition_documentation();
/// The same of actions.
std::string failsafe_action_documentation();

}  // namespace mlab::tables
