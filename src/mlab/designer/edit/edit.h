#pragma once

#include <memory>
#include <optional>
#include <string>

#include "mlab/designer.pb.h"
#include "mlab/designer/drawing/model.h"
#include "mlab/designer/edit/offered.h"
#include "mlab/designer/edit/workspace.h"

namespace mlab::designer {

/// What an Edit makes of a text.
struct Edited {
  std::string text;
  std::string name;  ///< for undo
};

/// Does all changes of an edit, one after the other, or none.
///
/// @param offered  files that it may use from now on, where the changes name what they declare
/// @errors  `cannot-edit`: why it can't be done, as a sentence for a person
text::Result<Edited> edited(std::shared_ptr<const Model> model, const cdl::Environment& environment,
                            const Edit& edit, const std::vector<Offered>& offered = {});

/// The CDL text of nodes, states, or (page empty) declarations, for the clipboard.
text::Result<std::string> copied(const Model& model, const Copy& request);

/// Where a wire from a node or a component may lead, or what may drive an input.
FitList fitting(const Model& model, const Fits& request, const std::vector<Offered>& offered = {});

}  // namespace mlab::designer
