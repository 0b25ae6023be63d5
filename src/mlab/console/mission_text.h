#pragma once

#include <cstdint>
#include <string>

#include "mlab/text/source.h"

namespace mlab::console {

/// A text to be put in at a byte.
struct Insertion {
  std::uint32_t at = 0;
  std::string text;
};

/// `OVERLAY name` as a line of a mission: below its titles and the overlays that it has.
Insertion overlay_statement(const text::SourcePtr& mission, const std::string& name);

/// A statement as the last one of the preamble, on a line of its own.
Insertion preamble_statement(const text::SourcePtr& mission, const std::string& statement);

/// A name as MDL and ODL both read it: a plain word, or in quotes. Empty where neither can hold it.
std::string written_name(const std::string& name);
/// The same for a name in a command, where words of the language stand in quotes.
std::string written_reference(const std::string& name);

}  // namespace mlab::console
