#pragma once

#include "mlab/designer.pb.h"
#include "mlab/designer/edit/owner_names.h"
#include "mlab/designer/edit/refusal.h"
#include "mlab/designer/edit/workspace.h"

namespace mlab::designer {

/// Gives another name to a declaration, or to what stands on its pages: a node, a parameter, a state, a
/// device. It touches every word of the text that means it and nothing else, and commits.
/// @param names  that are taken: what has been given in this edit, too
/// @errors       `cannot-edit`: there is no such thing, it has no name, the other is none or taken
Done rename(Workspace& work, const OwnerNames& names, const Rename& change);

}  // namespace mlab::designer
