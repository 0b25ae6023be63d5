#pragma once

#include "mlab/designer.pb.h"
#include "mlab/designer/edit/find/pages.h"
#include "mlab/designer/edit/page_writer.h"
#include "mlab/designer/edit/refusal.h"
#include "mlab/designer/edit/workspace.h"

// Changes of triggers that are put together by choosing. They touch the trigger of one transition and nothing
// else, and commit.
//
// @errors of both  `cannot-edit`: that part of the trigger has gone, or the component can't stand there

namespace mlab::designer {

/// A part of it is asked of another component, joined with one, negated, taken away.
Done change_trigger(Workspace& work, const ChangeTrigger& change);
/// @param view  a page that a trigger asks
Done place_in_trigger(PageWriter& pages, const PageView& view, const Place& change);

}  // namespace mlab::designer
