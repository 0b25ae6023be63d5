#pragma once

#include "mlab/designer.pb.h"
#include "mlab/designer/edit/refusal.h"
#include "mlab/designer/edit/workspace.h"

// Changes of societies: their members, castes of those, and who coordinates them. They touch the declaration
// of the society and nothing else, and commit.
//
// @errors of all  `cannot-edit`: there is no such society or member, or what is said can't be one

namespace mlab::designer {

/// A member becomes another one, or there is one more; of a caste that is there: who coordinates it.
Done set_member(Workspace& work, const SetMember& change);
/// A caste of which nothing is left goes as well; the society itself stays, without members.
Done remove_member(Workspace& work, const RemoveMember& change);
Done move_member(Workspace& work, const MoveMember& change);

/// Members of a caste become a caste in it.
Done group_members(Workspace& work, const GroupMembers& change);
/// The members of a caste stand where it stood; its operator coordinates what has none of its own.
Done ungroup_members(Workspace& work, const UngroupMembers& change);

}  // namespace mlab::designer
