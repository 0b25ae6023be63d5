#pragma once

#include <optional>
#include <string>

#include "mlab/export/format.h"

namespace mlab::exports {

/// The robot's sequence as a SAUSAGES plan for the UGV architecture, with all of its states, transitions and
/// conditions (docs/languages/exports.md).
///
/// Warns (`other-architecture`) where the configuration is not for UGV.
/// @errors  those of `plan_of`
std::optional<std::string> write_sausages(const Subject& subject, text::Diagnostics& sink);

}  // namespace mlab::exports
