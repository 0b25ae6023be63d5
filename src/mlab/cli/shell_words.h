#pragma once

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): of the library
class App;
}

namespace mlab::cli {

/// An option or a positional argument, as its definition says it.
struct OptionWords {
  std::vector<std::string> names;    ///< `--output`, `-o`; of a positional argument its one name
  std::string value;                 ///< what a person puts in: `FILE.json`, `N`; empty for a flag
  std::vector<std::string> choices;  ///< the words that can stand there; empty: anything
  std::string initial;               ///< the value without it; may be empty
  std::string help;                  ///< on one line
  std::string group;                 ///< heading under which it stands
  bool is_required = false;
  bool is_repeated = false;  ///< any number of values may follow
};

/// One command with all that can follow it.
struct CommandWords {
  std::string name;
  std::string help;  ///< on one line
  std::vector<OptionWords> options;
  std::vector<OptionWords> positionals;
};

/// The whole command line as data: what help, completion and manual pages are made of. Commands that are
/// hidden are left out.
struct ProgramWords {
  CommandWords own;
  std::vector<CommandWords> commands;
  std::string footer;
};

/// Reads the definitions. Whatever option is added to them is in here by itself.
ProgramWords words_of(const CLI::App& app);

enum class FileKind { kNone, kFile, kFolder };
/// Whether a value is the name of a file or a folder.
FileKind file_kind(const OptionWords& option);
/// `json` of `FILE.json`; empty: any file.
std::string file_ending(const OptionWords& option);

/// What the shells read to complete a command line of mlab.
std::string bash_completion(const ProgramWords& program);
std::string zsh_completion(const ProgramWords& program);
std::string fish_completion(const ProgramWords& program);

/// Manual pages in roff: of the program, and of one command.
std::string manual_page(const ProgramWords& program);
std::string manual_page(const ProgramWords& program, const CommandWords& command);

/// Writes all of them below `folder`, where `share/` of an installation has them.
bool write_shell_files(const ProgramWords& program, const std::string& folder);

}  // namespace mlab::cli
