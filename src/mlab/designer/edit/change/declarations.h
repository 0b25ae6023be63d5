#pragma once

#include "mlab/designer.pb.h"
#include "mlab/designer/edit/refusal.h"
#include "mlab/designer/edit/workspace.h"

// Changes of which declarations a text has. They touch the declarations that they name, and where a new one
// stands in the layout; and commit.
//
// @errors of all  `cannot-edit`: there is no such declaration, its name is none or taken

namespace mlab::designer {

/// An empty one of its kind; a class may be for a robot, which gets it (robots.h).
Done add_declaration(Workspace& work, const AddDeclaration& change);
/// Those that the change names as nodes; who speaks of them is the checker's to mark.
Done remove_declarations(Workspace& work, const Remove& change);
/// What another file declares stands in this one, too.
Done copy_component(Workspace& work, const CopyComponent& change);
/// What a binding point gives.
Done set_binding(Workspace& work, const SetBinding& change);

}  // namespace mlab::designer
