#pragma once

#include "mlab/designer.pb.h"
#include "mlab/designer/edit/page_writer.h"
#include "mlab/designer/edit/refusal.h"

namespace mlab::designer {

/// Does one change of an edit, and commits. What it means depends on its kind and on the page: on that of a
/// class or an operator nodes are devices.
/// @param pages  the same for all changes of an edit: it knows the names that have been given
/// @errors       `cannot-edit`: why it can't be done; the text may be half changed, and is thrown away
Done apply(PageWriter& pages, const Change& change);

}  // namespace mlab::designer
