#pragma once

#include <string_view>

#include "mlab/lang/cnl/tree.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cnl {

/// Checks what declarations must obey by themselves: known types, names used once, sections, what a state may
/// be, aliases and sensors that speak of inputs that are there. What a network must obey is checked where its
/// program is built.
void check_declarations(const Tree& tree, text::Diagnostics& diagnostics);

/// The inputs and context names (`percepts`, `random`, ...) that the code of a procedure can use.
inline constexpr std::string_view kContextNames[] = {"percepts", "action", "random",
                                                     "cycle",    "time",   "cycle_duration"};
/// True where the procedure's code uses this name of the context: it is then handed in.
bool uses_context(const Procedure& procedure, std::string_view name);

}  // namespace mlab::cnl
