#pragma once

#include <string>

#include "mlab/text/diagnostic.h"

namespace mlab::text {

/// The diagnostic where there is room for a sentence only: the file without its folders, line and column,
/// what stands there, what is expected, and the first hint.
///
///     demo.mdl:9:23: unknown control measure `ATK-AP9`: not in overlay `democ.odl`; did you mean `ATK-AP1`?
///
/// Control characters are shown as `?`.
std::string one_line(const Diagnostic& diagnostic);
/// Of all of them the first error, and how many there are beside it; empty: there is none.
std::string first_error(const Diagnostics& diagnostics);

}  // namespace mlab::text
