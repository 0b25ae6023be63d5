#pragma once

#include <string>
#include <string_view>

namespace mlab::text {

/// A piece of text as a person has to type it for a shell to take it as one word: as it is where that will
/// do, else in single quotes.
std::string shell_word(std::string_view text);

}  // namespace mlab::text
