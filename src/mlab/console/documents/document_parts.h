#pragma once

#include "mlab/documents/refused.h"

namespace mlab::console {

using documents::refused;
using documents::shown;

/// What an overlay begins as.
inline constexpr const char* kEmptyOverlay = "CONTROL MEASURES:\n";

}  // namespace mlab::console
