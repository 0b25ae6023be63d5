#pragma once

#include <optional>
#include <string>

#include "mlab/export/format.h"

namespace mlab::exports {

/// The robot's sequence as a behavior tree of BehaviorTree.CPP, version 4. A tree has no transitions back, so
/// the sequence has to be a chain: each state leads to one next state, the last one is final or leads to the
/// first again (docs/languages/exports.md).
///
/// @errors  `not-a-tree` at the transition that a tree can't make; those of `plan_of`
std::optional<std::string> write_btcpp(const Subject& subject, text::Diagnostics& sink);

}  // namespace mlab::exports
