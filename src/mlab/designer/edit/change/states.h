#pragma once

#include <set>
#include <string>

#include "mlab/designer.pb.h"
#include "mlab/designer/edit/refusal.h"
#include "mlab/designer/edit/workspace.h"

// Changes of sequences: their states and transitions. They touch the sequence of one page, and where a new
// state stands in its layout; and commit. A trigger is written here as words; put together by choosing it is
// in triggers.h.
//
// @errors of all  `cannot-edit`: there is no such page, state or transition, or what is said can't be one

namespace mlab::designer {

/// The first of a sequence is its start.
Done add_state(Workspace& work, const AddState& change);
/// What is not said stays. There is one start.
Done set_state(Workspace& work, const SetState& change);
/// The states with their transitions, and those that lead to them.
Done remove_states(Workspace& work, const cdl::Sequence& all, const std::set<std::string>& gone);

/// Without a trigger it is never made, which the checker marks.
Done add_transition(Workspace& work, const AddTransition& change);
/// What is not said stays.
Done set_transition(Workspace& work, const SetTransition& change);
Done remove_transition(Workspace& work, const RemoveTransition& change);

}  // namespace mlab::designer
