#pragma once

#include <optional>
#include <string>
#include <utility>

#include "mlab/designer/edit/find/pages.h"
#include "mlab/designer/edit/workspace.h"

// Nodes that are found again after a commit, whatever they are called then and wherever they stand.

namespace mlab::designer {

/// @return  a handle of the node; -1: it stands nowhere, and can't be found again
int follow(Workspace& work, const PageView& view, int node);
/// Where the node is now: its page and its place there. Nothing where it has gone.
/// @param owner   the assemblage or robot that has it
/// @param handle  as `follow` gave it
std::optional<std::pair<PageView, int>> followed(const Workspace& work, const std::string& owner, int handle);

}  // namespace mlab::designer
