#pragma once

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): of the library
class App;
class ParseError;
}  // namespace CLI

namespace mlab::cli {

/// Tells on standard error, in words of ours, what of a command line can't be understood: a first word that
/// is no command or an option that the command doesn't have, with the nearest that there is; what is missing,
/// is too much, or is of the wrong kind.
/// @param words  behind the program's name
void tell_wrong_words(const CLI::App& app, const CLI::ParseError& error,
                      const std::vector<std::string>& words);

/// Whether the first word is to be a command, and there is none of that name.
bool is_unknown_command(const CLI::App& app, const std::vector<std::string>& words);
/// The same, told.
void tell_unknown_command(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace mlab::cli
