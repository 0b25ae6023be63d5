#pragma once

#include "mlab/designer.pb.h"
#include "mlab/designer/edit/page_writer.h"
#include "mlab/designer/edit/refusal.h"
#include "mlab/designer/edit/workspace.h"

// A value becomes a parameter: whoever calls the assemblage, or makes robots of the class, may change it.
// These touch what stands at the input and the parameters of its owner, and commit.
//
// @errors of both  `cannot-edit`: there is no such input, or it can't be a parameter of that name

namespace mlab::designer {

/// An input of a node; where there is a parameter of that name that fits, it is that one.
Done expose_input(PageWriter& pages, const Expose& change);
/// A number of the body, or an input of a device: a parameter of the class.
Done expose_equipment(Workspace& work, const Expose& change);

}  // namespace mlab::designer
