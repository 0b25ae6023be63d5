#pragma once

#include "mlab/designer.pb.h"
#include "mlab/designer/edit/refusal.h"
#include "mlab/designer/edit/workspace.h"

namespace mlab::designer {

/// Changes the help, the `///` lines, of a declaration, or of what stands on its pages: a state, a name, a
/// member, a device. It touches these lines and nothing else, and commits.
/// @errors  `cannot-edit`: there is no such thing, or it has no line of its own
Done set_help(Workspace& work, const SetHelp& change);

}  // namespace mlab::designer
