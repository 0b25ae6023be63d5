#pragma once

#include "mlab/lang/cdl/lower/owner_model.h"

namespace mlab::designer {

// What is drawn of an assemblage or a robot.
using GraphInput = cdl::ModelInput;
using GraphNode = cdl::ModelNode;
using GraphPage = cdl::ModelPage;
using OwnerGraph = cdl::OwnerModel;
using Role = cdl::InputRole;

}  // namespace mlab::designer
