#pragma once

#include "mlab/designer.pb.h"
#include "mlab/designer/edit/page_writer.h"
#include "mlab/designer/edit/refusal.h"
#include "mlab/designer/edit/workspace.h"

// Changes of parameters: of assemblages, robots, classes and binding points. They touch the declaration, what
// reads the parameter there, and calls that give it; and commit.
//
// @errors of both  `cannot-edit`: there is no such owner or parameter, or what is said can't be one

namespace mlab::designer {

/// There is one more, or it is another one; without a type what is not said stays.
Done set_parameter(Workspace& work, const SetParameter& change);
/// What read it gets its default, and who gave it gives it no more.
Done remove_parameter(PageWriter& pages, const RemoveParameter& change);

}  // namespace mlab::designer
