#pragma once

#include "mlab/designer.pb.h"
#include "mlab/designer/edit/refusal.h"
#include "mlab/designer/edit/workspace.h"

// Assemblages made of nodes, and put back. These touch the declaration that has the page, declare an
// assemblage more (one that is taken apart stays), and layouts of both; and commit.

namespace mlab::designer {

/// The nodes have one value that others take: it is what the new assemblage gives. What drives them from
/// outside becomes its parameters.
/// @errors  `cannot-edit`: they give several values, the name is none or taken, a type is not known
Done group_nodes(Workspace& work, const Group& change);
/// What the called assemblage is made of, with the call's values in place of its parameters.
/// @errors  `cannot-edit`: the node is no assemblage, it is empty, a parameter has no value here
Done ungroup_node(Workspace& work, const Ungroup& change);

}  // namespace mlab::designer
