#pragma once

#include <initializer_list>
#include <string>

#include "mlab/assist/language.h"

namespace mlab::cli {

/// What to do with a file whose ending says that it is in none of the `wanted` languages: what it is, and
/// which command or statement takes it. Empty where it may be in one of them. The file is not read.
std::string other_language(const std::string& file, std::initializer_list<assist::Language> wanted);

}  // namespace mlab::cli
