#pragma once

#include <string>

#include "mlab/console.pb.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/mission/mission.h"
#include "mlab/text/diagnostic.h"

namespace mlab::console {

/// What is wrong with a typed line or a text that is no document. Nothing is changed and nothing is run.
///
/// @param mission  that a typed line is meant for; null: as if nothing were defined
/// @param folder   of the machine, where a mission's overlays are looked for first
text::Diagnostics check_text(const Check& request, const mission::Mission* mission, const std::string& folder,
                             const mdl::LoadOptions& options);

}  // namespace mlab::console
