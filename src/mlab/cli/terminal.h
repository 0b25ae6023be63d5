#pragma once

#include <string>

#include "mlab/text/diagnostic.h"

namespace mlab::cli {

/// Whether what goes to this descriptor is coloured: it is a terminal that can, and nobody asked for none
/// (NO_COLOR, as no-color.org has it).
bool is_colored(int descriptor);

enum class Color { kGood, kWarning, kBad };
/// A piece of text in a colour; as it is where standard output is not coloured.
std::string colored(const std::string& text, Color color);

/// Diagnostics on standard error, coloured on a terminal.
void tell(const text::Diagnostics& diagnostics);
void tell(const text::Diagnostic& diagnostic);

}  // namespace mlab::cli
