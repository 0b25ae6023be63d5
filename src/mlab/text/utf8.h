#pragma once

#include <string>
#include <string_view>

namespace mlab::text {

/// Whether the bytes are UTF-8 as messages want it.
bool is_utf8(std::string_view bytes);
/// Each byte taken for a character of Latin 1, as old files have them.
std::string utf8_of_latin1(std::string_view bytes);
/// The text itself where it is UTF-8, else taken for Latin 1.
std::string as_utf8(std::string_view bytes);
/// False in the middle of a character.
bool is_character_boundary(std::string_view text, std::size_t at);

}  // namespace mlab::text
