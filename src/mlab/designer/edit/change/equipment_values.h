#pragma once

#include "mlab/designer.pb.h"
#include "mlab/designer/edit/refusal.h"
#include "mlab/designer/edit/workspace.h"

namespace mlab::designer {

/// Changes what the body of a class has, or what is given to a device of a class or an operator; nothing: its
/// default. It touches the body or the device and nothing else, and commits.
/// @param change  a number without a unit is in the one that its field shows
/// @errors        `cannot-edit`: there is no such number, device or input, or the value can't be one
Done set_equipment_value(Workspace& work, const SetValue& change);

}  // namespace mlab::designer
