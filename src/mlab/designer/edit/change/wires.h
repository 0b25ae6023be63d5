#pragma once

#include "mlab/designer.pb.h"
#include "mlab/designer/edit/page_writer.h"
#include "mlab/designer/edit/refusal.h"

// Changes of what stands at an input of a node, or of what a page gives. They touch what is written there,
// and the `let` of a node that comes or goes with the wire; and commit. No node is lost: one that nobody
// reads any more gets a `let`.
//
// @errors of all  `cannot-edit`: there is no such page, node or input, or nothing of that kind can stand
// there

namespace mlab::designer {

/// A wire from a node to an input, in place of what drove it.
/// @errors  `cannot-edit`: the types do not fit, or a loop without a delay would be closed
Done connect(PageWriter& pages, const Connect& change);
/// @errors  `cannot-edit`: nothing is connected there
Done disconnect(PageWriter& pages, const Disconnect& change);
/// What somebody typed stands at the input; nothing: its default.
Done set_value(PageWriter& pages, const SetValue& change);

}  // namespace mlab::designer
