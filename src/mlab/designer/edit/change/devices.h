#pragma once

#include "mlab/designer.pb.h"
#include "mlab/designer/edit/refusal.h"
#include "mlab/designer/edit/workspace.h"

// Changes of which devices a class of robots or an operator of societies has, what is behind them, and what
// they serve. They touch the class or operator, choices of robots of that class, and where a new device
// stands in the layout; and commit. What the body and the devices are given is in equipment_values.h.
//
// @errors of all  `cannot-edit`: there is no such owner, device, component or binding point, or the one can't
//                 serve the other

namespace mlab::designer {

/// There is one more, or one is by another component, or serves another binding point.
Done set_device(Workspace& work, const SetDevice& change);
/// A wire between a device and the binding point that it is to serve.
Done connect_device(Workspace& work, const Connect& change);
/// For a binding point that nothing serves yet, before one that is served.
Done place_device(Workspace& work, const Place& change);
/// Another component in its place: what both take stays.
Done replace_device(Workspace& work, const Replace& change);
Done remove_devices(Workspace& work, const Remove& change);

}  // namespace mlab::designer
