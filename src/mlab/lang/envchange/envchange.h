#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mlab/overlay/environment_change.h"
#include "mlab/text/diagnostic.h"

namespace mlab::envchange {

/// Parses an environment-change file: what obstacles come and go while a mission runs.
///
///     STEP_COUNT 1 100                       // at cycle 1 and every 100
///       REGION 0 0 200 200 ADD OBSTACLE 3 1 5 1
///
/// @param origin  the overlay's ORIGIN, added to all positions [m]
/// @errors  several, one for each broken command; then nothing is returned, and what was in force stays so
std::optional<overlay::EnvironmentChanges> parse(const text::SourcePtr& source, geom::Offset origin,
                                                 text::Diagnostics& sink);

/// Reads and parses a file.
std::optional<overlay::EnvironmentChanges> load(const std::string& path, geom::Offset origin,
                                                text::Diagnostics& sink);

/// True where the text is an environment-change file rather than one of another language.
bool looks_like_envchange(std::string_view text);

}  // namespace mlab::envchange
