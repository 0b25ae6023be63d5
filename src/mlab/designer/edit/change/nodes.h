#pragma once

#include "mlab/designer.pb.h"
#include "mlab/designer/edit/page_writer.h"
#include "mlab/designer/edit/refusal.h"

// Changes of which nodes a page has, and what they are. They touch the nodes that they name with what stands
// at their inputs and reads them, and where a new one stands in the layout; and commit.
//
// @errors of all  `cannot-edit`: there is no such page, node or component, or the one can't be the other

namespace mlab::designer {

/// One more, under a name of its own, with a wire where the change says one.
Done place_node(PageWriter& pages, const Place& change);
/// Nodes, states (states.h) and parameters (parameters.h) that stand on a page. What drives a node stays, as
/// one that leads nowhere, unless it is to be removed as well.
/// @errors  `cannot-edit`: a trigger needs it
Done remove_from_page(PageWriter& pages, const Remove& change);
/// Another component in its place: inputs of the same name and a fitting type stay.
Done replace_node(PageWriter& pages, const Replace& change);
/// What says when a behavior or a percept is active; none: it always is.
Done set_active(PageWriter& pages, const SetActive& change);

}  // namespace mlab::designer
