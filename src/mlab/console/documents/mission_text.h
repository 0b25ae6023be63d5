#pragma once

#include <string>

#include "mlab/assist/statement_candidates.h"
#include "mlab/text/source.h"
#include "mlab/text/splice.h"

namespace mlab::console {

/// `OVERLAY name` as a line of a mission: below its titles and the overlays that it has.
text::Splice overlay_statement(const text::SourcePtr& mission, const std::string& name);

using assist::written_name;
using assist::written_reference;

}  // namespace mlab::console
