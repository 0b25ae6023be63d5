#pragma once

#include <string>

#include "mlab/designer.pb.h"
#include "mlab/designer/edit/refusal.h"
#include "mlab/designer/edit/workspace.h"

// Changes of what robots are made of. They touch the declaration of a robot (the last one: devices of its
// class, too), and commit.
//
// @errors of all  `cannot-edit`: there is no such robot, class or device

namespace mlab::designer {

/// Its class, or none; devices that it chose and its class does not have are chosen no more.
Done set_class(Workspace& work, const SetClass& change);
/// Which device of its class serves a binding point; none: whichever the class says.
Done use_device(Workspace& work, const UseDevice& change);
/// A class gets the usual devices for what a robot asks for, and the robot gets the class.
Done add_class_for(Workspace& work, const std::string& name, const std::string& robot_name);

}  // namespace mlab::designer
