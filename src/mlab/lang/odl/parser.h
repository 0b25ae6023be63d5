#pragma once

#include "mlab/lang/odl/tree.h"
#include "mlab/text/diagnostic.h"

namespace mlab::odl {

/// Parses what WAYPOINT-FILE brings in: features without a header. Otherwise as `parse`.
Tree parse_features(const text::SourcePtr& source, text::Diagnostics& sink);

}  // namespace mlab::odl
