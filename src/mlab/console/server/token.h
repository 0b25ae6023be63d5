#pragma once

#include <string>
#include <string_view>

namespace mlab::console {

/// 160 random bits of the operating system, as 40 hexadecimal digits.
std::string make_token();

/// Takes the same time wherever the two differ, so that nobody can guess digit by digit.
bool is_same_token(std::string_view given, std::string_view token);

}  // namespace mlab::console
