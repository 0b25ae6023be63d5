#pragma once

#include <string_view>
#include <vector>

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
/// Those of them that the code of a procedure uses, in this order: they are handed in.
std::vector<std::string_view> used_context(const Procedure& procedure);

}  // namespace mlab::cnl
