#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/designer/drawing/graph.h"
#include "mlab/designer/drawing/model.h"

namespace mlab::designer {

/// Shows the robot itself and every assemblage that it calls, however deep, in every place where it runs.
/// @param show  the levels, and the path of the owner's value in the robot's program: `movement.Searching`;
///              of the robot itself empty
void visit_instances(const Model& model, std::string_view robot,
                     const std::function<void(const OwnerGraph& graph, const std::string& path)>& show);

/// Where a page's nodes are in the program of a robot: what stands before `live` of what is drawn. Empty
/// where the robot does not use the page's owner.
/// @param source  name of the text that declares the owner
std::vector<std::string> live_paths(const Model& model, std::string_view robot, std::string_view source,
                                    std::string_view page);
/// The same of a robot that the text does not declare. It must live as long as the model.
std::vector<std::string> live_paths(const Model& model, const cdl::Robot& robot, std::string_view source,
                                    std::string_view page);

using cdl::joined_path;

}  // namespace mlab::designer
