#pragma once

#include <optional>
#include <string>

#include "mlab/export/format.h"

namespace mlab::exports {

/// The robot's sequence as a behavior tree of BehaviorTree.CPP, version 4. A tree has no transitions; the
/// state stands on the blackboard, and a tick is a control cycle (docs/languages/exports.md).
///
/// @errors  those of `plan_of`
std::optional<std::string> write_btcpp(const Subject& subject, text::Diagnostics& sink);

}  // namespace mlab::exports
