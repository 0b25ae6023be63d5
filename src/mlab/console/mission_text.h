#pragma once

#include <string>

#include "mlab/console/splices.h"
#include "mlab/text/source.h"

namespace mlab::console {

/// `OVERLAY name` as a line of a mission: below its titles and the overlays that it has.
Splice overlay_statement(const text::SourcePtr& mission, const std::string& name);

/// A name as MDL and ODL both read it: a plain word, or in quotes. Empty where neither can hold it.
std::string written_name(const std::string& name);
/// The same for a name in a mission, where words of the language stand in quotes.
std::string written_reference(const std::string& name);

}  // namespace mlab::console
