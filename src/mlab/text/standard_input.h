#pragma once

#include "mlab/text/diagnostic.h"

namespace mlab::text {

/// Standard input to its end; the source is called `<stdin>`.
/// @errors as `read_source`
[[nodiscard]] Result<SourcePtr> read_standard_input();

}  // namespace mlab::text
