#pragma once

#include "mlab/designer.pb.h"
#include "mlab/designer/edit/refusal.h"
#include "mlab/designer/edit/workspace.h"

namespace mlab::designer {

/// Puts what `copied` (edit.h) has written into a page, or among the declarations, each under a free name. It
/// touches that page and its layout, or adds declarations; and commits.
/// @errors  `cannot-edit`: the words hold nothing that can stand there
Done paste(Workspace& work, const Paste& change);

}  // namespace mlab::designer
