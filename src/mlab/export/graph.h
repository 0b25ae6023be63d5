#pragma once

#include <optional>
#include <string>

#include "mlab/export/format.h"

namespace mlab::exports {

/// The robot's network as JSON (docs/languages/exports.md): nodes with ports and types, wires, groups, states
/// and transitions, layout.
std::optional<std::string> write_graph(const Subject& subject, text::Diagnostics& sink);

/// The same for Graphviz, groups as clusters.
std::optional<std::string> write_dot(const Subject& subject, text::Diagnostics& sink);

}  // namespace mlab::exports
