#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/designer.pb.h"
#include "mlab/designer/drawing/drawing.h"
#include "mlab/designer/drawing/model.h"
#include "mlab/designer/edit/workspace.h"

// The project's own library: files that a configuration could `use`, and does not yet. What they declare is
// offered, and whoever places it gets the `use`, so that the compiler finds it the same way.

namespace mlab::designer {

struct Offered {
  std::string document;                ///< its id
  std::string file;                    ///< as a `use` of the configuration names it
  std::shared_ptr<const Model> model;  ///< of it; where it is CNL, of a text that only uses it
};

/// What it declares that can be called: assemblages of a configuration, procedures of CNL.
std::vector<Callable> callables_of(const Model& offered);

/// Whether the configuration may use it: it can be read, is not used yet, does not use the configuration
/// itself, and declares nothing that the configuration declares as well.
bool can_use(const Model& model, const std::string& disk_path, const Model& offered);

/// The file that declares what a change names; null where the configuration knows it already, or nobody does.
/// @param component  as Place::component
const Offered* find_offered(const std::vector<Offered>& all, const Model& model, std::string_view component);
const Callable* find_callable(const std::vector<Callable>& all, std::string_view name);

/// The files that the changes need, once each.
std::vector<std::string> files_needed(const Edit& edit, const Model& model, const std::vector<Offered>& all);

/// `use "FILE";` behind those that are there.
Done add_use(Workspace& work, const std::string& file);

/// The components of files that are not used yet.
void add_offered(const std::vector<Offered>& all, const DrawingContext& context, Palette& palette);

}  // namespace mlab::designer
