#pragma once

#include <string>

#include "mlab/designer.pb.h"
#include "mlab/designer/edit/refusal.h"
#include "mlab/designer/edit/workspace.h"

// Changes of where things stand: places of nodes, notes and frames. They touch layout blocks and nothing
// else, and commit.
//
// @errors of all  `cannot-edit`: there is no such page

namespace mlab::designer {

/// What the page has stands at other places [px]; names that no layout block could have are left out.
Done arrange(Workspace& work, const Arrange& change);

/// @param where  has x and y; both 0: nobody said where
Done arrange_one(Workspace& work, const std::string& page, const std::string& node, const auto& where) {
  if (where.x() == 0.0 && where.y() == 0.0) return true;
  Arrange change;
  change.set_page(page);
  Arrange::At& at = *change.add_nodes();
  at.set_node(node);
  at.set_x(where.x());
  at.set_y(where.y());
  return arrange(work, change);
}

/// A note or a frame is there, is another one, or (without words and size) has gone.
/// @errors  `cannot-edit`: it has gone already
Done set_note(Workspace& work, const SetNote& change);

}  // namespace mlab::designer
