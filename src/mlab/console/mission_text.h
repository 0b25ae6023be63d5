#pragma once

#include <string>

#include "mlab/console/splices.h"
#include "mlab/language/statement_candidates.h"
#include "mlab/text/source.h"

namespace mlab::console {

/// `OVERLAY name` as a line of a mission: below its titles and the overlays that it has.
Splice overlay_statement(const text::SourcePtr& mission, const std::string& name);

using language::written_name;
using language::written_reference;

}  // namespace mlab::console
