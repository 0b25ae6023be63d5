#pragma once

#include <string>
#include <string_view>

namespace mlab::assist {

/// What a word of a language means, in one line of markdown; empty where it is none of its words.
std::string_view cdl_word_help(std::string_view word);
std::string_view cnl_word_help(std::string_view word);
/// Letter case does not count.
std::string mdl_word_help(std::string_view word);
std::string_view odl_word_help(std::string_view word);

}  // namespace mlab::assist
