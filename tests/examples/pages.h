#pragma once

// What the pages show: command lines with what they print, read out of Markdown and carried out.

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace mlab::examples {

using Words = std::vector<std::string>;

/// The folder with the sources.
const std::filesystem::path& root();

/// How a command ended and what it printed: standard output and standard error together, as on a screen.
struct Answer {
  int status = -1;  ///< of its exit; -1 where it did not exit by itself
  std::string output;
};

/// What a page tells its reader to change in a file: Change `FROM` to `TO` in `FILE`. Or, with an empty file,
/// to take all changes back: Change it back.
struct Change {
  std::string from;
  std::string to;
  std::filesystem::path file;  ///< beside the page, or else from the root
};

/// A folder as a reader of the pages has it, with `./mlab` in it and a folder `build`. It is gone at the end.
class Workplace {
 public:
  Workplace();
  ~Workplace();
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  /// Copies a file or folder of the sources; both paths are relative.
  void take(const std::filesystem::path& from, const std::filesystem::path& to) const;
  /// Does what `page` (from the root) tells its reader to change; a test fails where that can't be done.
  void make(const Change& change, const std::filesystem::path& page);
  /// Whether all changes have been taken back.
  bool is_unchanged() const;
  /// Carries a shell command out in the folder; `typed` is its standard input.
  Answer carry_out(const std::string& command, const std::string& typed = {}) const;

 private:
  std::filesystem::path all_;
  std::filesystem::path folder_;
  std::map<std::filesystem::path, std::string> unchanged_;
};

/// A command line that a page shows, with the output that stands below it.
struct ShownCommand {
  std::string place;    ///< page:line
  std::string command;  ///< as it stands, without `$ `; empty for changes at the end of the page
  bool has_prompt = false;
  std::vector<std::string> output;
  std::vector<Change> changes;  ///< to be made before it
};

std::vector<std::string> lines_of(const std::filesystem::path& file);

/// The pages (`.md`) below folders of the root, in the order of their names.
std::vector<std::filesystem::path> pages_in(const std::vector<std::string>& folders);

/// The text of a file; empty where there is none.
std::string text_of(const std::filesystem::path& file);

/// The words behind `mlab` or `./mlab`, without what stands behind ` #` or ` |`;
/// nothing for any other command.
Words command_words(std::string_view command);

/// The commands in the indented blocks of a page: lines that begin with `$ `, with the lines below as their
/// output, and calls of `mlab` without that.
std::vector<ShownCommand> commands_in_blocks(const std::filesystem::path& page);

/// Calls of `mlab` between back quotes, in sentences: `mlab run MISSION --report FILE.json`.
std::vector<ShownCommand> commands_in_sentences(const std::filesystem::path& page);

/// What is carried out of a command that a page shows: one with a prompt as it stands; of others what shows
/// that they work, without a browser and without a compiler. Empty: nothing.
std::string trial_of(const ShownCommand& shown);

/// Makes the changes that the page asks for, carries the command out, and fails the test where it does not
/// end or print as shown. Answers that are shown behind `[y/n]` are typed.
void expect_as_shown(Workplace& here, const ShownCommand& shown);

/// Whether the output is the expected one, from its first line to its last. A line `...` stands for any
/// lines, and `...` in a line for anything in it.
bool is_shown_by(const std::vector<std::string>& expected, const std::string& output);

}  // namespace mlab::examples
