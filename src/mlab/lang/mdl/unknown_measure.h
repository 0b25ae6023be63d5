#pragma once

#include <string>
#include <vector>

#include "mlab/lang/mdl/names.h"
#include "mlab/lang/mdl/tree.h"
#include "mlab/overlay/overlay.h"
#include "mlab/text/diagnostic.h"

namespace mlab::mdl {

/// Reports a name that no control measure has, with where it was looked for and the one that may have been
/// meant.
///
/// @param overlays  that the mission names, as written
/// @param places    of the overlay
void report_unknown_measure(const Name& name, const overlay::Overlay& overlay,
                            const std::vector<std::string>& overlays, const PlaceIndex& places,
                            const text::SourcePtr& source, text::Diagnostics& diagnostics);

}  // namespace mlab::mdl
