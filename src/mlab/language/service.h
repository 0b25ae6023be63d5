#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mlab/language/language.h"
#include "mlab/robot/robot_program.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/files.h"
#include "mlab/text/source.h"

/// What an editor asks of a text in one of the languages: one set of questions for all of them. Texts are
/// taken as they are while somebody types: whatever is missing or wrong, there is an answer. Offsets count
/// bytes; one past the end counts as the end.
namespace mlab::language {

/// A text that somebody edits. The source's name is the path of its file, and relative names in it start at
/// that file's folder.
struct Text {
  text::SourcePtr source;
  Language language = Language::kConfiguration;
};

/// What stands beside a text.
struct Surroundings {
  /// How other files are read; an editor's other open texts come before what is on disk.
  text::Files files = text::files_on_disk();
  /// The names of the files in a folder, for completion of file names; null: none are offered.
  std::function<std::vector<std::string>(const std::string& folder)> list;
  /// Where overlays are looked for after the mission's own folder.
  std::vector<std::string> overlay_folders;
  /// For compiling what is checked; its folder and files are set from the text and `files`.
  robot::ProgramSources programs;
  /// Whether C++ in procedures is given to the compiler, which takes about a second.
  bool checks_code = true;
};

/// A part of the text, and what comes into its place.
struct Splice {
  text::Span span;
  std::string text;
};

// ------------------------------------------------------------------------------------------- what is wrong

/// All that `mlab check` says of the text. With an error here and there the rest is checked all the same.
text::Diagnostics problems(const Text& text, const Surroundings& around);

/// An offered mend.
struct Fix {
  std::string title;            ///< `write Wander`
  std::vector<Splice> splices;  ///< of this text, ascending, not overlapping
};

/// Ways to mend one of the problems. Each was tried: with it the problem is gone, and no other error has
/// come.
std::vector<Fix> fixes(const Text& text, const text::Diagnostic& problem, const Surroundings& around);

// ----------------------------------------------------------------------------------------------- completion

/// Something that could stand at the cursor.
struct Candidate {
  std::string text;  ///< what is written
  /// keyword, assemblage, procedure, binding, class, robot, operator, society, parameter, argument, let,
  /// node, state, device, type, unit, word, file, place, team, option, number, ...
  std::string kind;
  std::string detail = {};  ///< on one line: signature, type, where from
  std::string help = {};    ///< one line
  bool is_call = false;     ///< parentheses follow, with the cursor between them
  bool has_more = false;    ///< a name that something else follows: ` = ` behind an argument
};

inline constexpr std::size_t kMostCandidates = 200;
struct Completions {
  text::Span replaced;                ///< what the chosen one takes the place of
  std::vector<Candidate> candidates;  ///< the most likely first
  bool is_cut = false;                ///< there were more of them than `kMostCandidates`
};

/// What could stand at the cursor: words of the language, components with their signature, inputs of the call
/// that one is in, units that fit, words of the wanted type, names that are known there. In comments and
/// where only a new name can stand, there is nothing.
Completions complete(const Text& text, std::uint32_t cursor, const Surroundings& around);

/// The call that the cursor is in.
struct Signature {
  std::string label;  ///< `Noise(persistence: double [s] = 6) -> Vector`
  std::string help;   ///< markdown
  struct Part {
    text::Span span;  ///< of the label
    std::string help;
  };
  std::vector<Part> parts;
  std::size_t active = 0;  ///< index into `parts`; past the end: none of them
};
std::optional<Signature> signature(const Text& text, std::uint32_t cursor, const Surroundings& around);

// ---------------------------------------------------------------------------------------------------- names

struct Hover {
  std::string markdown;  ///< help, type, unit, default, range
  text::Span span;       ///< of what it speaks of
};
std::optional<Hover> hover(const Text& text, std::uint32_t cursor, const Surroundings& around);

/// Where what is named at the cursor is declared, in this or another text. Nothing where it is a word of the
/// language or a procedure that was compiled in.
std::optional<text::Place> definition(const Text& text, std::uint32_t cursor, const Surroundings& around);

/// Everywhere in this text and in `others` where the same thing is named, its declaration too.
std::vector<text::Place> references(const Text& text, std::uint32_t cursor, const std::vector<Text>& others,
                                    const Surroundings& around);

/// The name at the cursor, where it can be changed; nothing for words of the language and what the library
/// declares.
std::optional<text::Span> renamable(const Text& text, std::uint32_t cursor, const Surroundings& around);

/// What changes in one of the texts.
struct Change {
  text::SourcePtr source;
  std::vector<Splice> splices;  ///< ascending
};
/// Gives it another name everywhere. @errors a sentence, where the name is none or stands for something else
std::expected<std::vector<Change>, std::string> rename(const Text& text, std::uint32_t cursor,
                                                       const std::string& name,
                                                       const std::vector<Text>& others,
                                                       const Surroundings& around);

/// A declaration in a text, with those inside of it.
struct Symbol {
  std::string name;
  std::string kind;    ///< as `Candidate::kind`
  std::string detail;  ///< its type
  text::Span span;     ///< of all of it
  text::Span name_span;
  std::vector<Symbol> parts;
};
std::vector<Symbol> symbols(const Text& text, const Surroundings& around);

// --------------------------------------------------------------------------------------------------- layout

/// The text in its canonical layout. Nothing where it has errors, which are then in `sink`.
std::optional<std::string> formatted(const Text& text, text::Diagnostics& sink);

/// A token and what it is.
struct Shade {
  /// kDeclared: the name of something is declared here.
  enum class Kind : std::uint8_t {
    kComment,
    kKeyword,
    kNumber,
    kText,
    kOperator,
    kType,       ///< types, classes
    kFunction,   ///< procedures, assemblages, binding points
    kParameter,  ///< parameters, arguments
    kVariable,   ///< lets, nodes
    kMember,     ///< states, devices, words of a type
    kThing,      ///< robots, teams, places
    kUnit,
    kMacro  ///< directives
  };
  text::Span span;
  Kind kind = Kind::kKeyword;
  bool is_declaration = false;
  bool is_library = false;  ///< comes with missionlab
};
/// All tokens that have a meaning, ascending, not overlapping.
std::vector<Shade> shades(const Text& text, const Surroundings& around);

}  // namespace mlab::language
