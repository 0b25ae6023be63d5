#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mlab/assist/language.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/files.h"
#include "mlab/text/source.h"
#include "mlab/text/splice.h"

/// What an editor asks of a text in one of the languages: one set of questions for all of them. Texts are
/// taken as they are while somebody types: whatever is missing or wrong, there is an answer. Offsets count
/// bytes; one past the end counts as the end.
namespace mlab::assist {

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
  /// All texts of the project as they stand, open ones first. Null: the text that is asked about is alone.
  std::function<std::vector<Text>()> project;
  /// Why a file can't be changed, as `is read only`; empty: it can. Null: all can.
  std::function<std::string(const std::string& path)> fixed;
  /// Asked by what goes through the whole project. True: nobody waits for the answer any more, any will do.
  std::function<bool()> given_up;
};

using text::Splice;

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

/// A place where something is named.
struct Use {
  text::Place place;
  std::string kind;  ///< what stands there, as `Candidate::kind`: an argument, a node, ...
  bool is_declaration = false;
  std::string within;  ///< the declaration that it stands in; empty: none
};
struct Uses {
  std::string name;
  std::string kind;         ///< of what is named
  bool is_library = false;  ///< it is declared in the library
  std::vector<Use> places;  ///< by file, ascending; those of the text that is asked about first
};
/// Everywhere in the project where the same thing is named as at the cursor, its declaration too; of
/// something of the library, where the project names it. No places where there is no name.
Uses uses(const Text& text, std::uint32_t cursor, const Surroundings& around);

/// The name at the cursor, where it can be changed; nothing for words of the language and what the library
/// declares.
std::optional<text::Span> renamable(const Text& text, std::uint32_t cursor, const Surroundings& around);

/// What changes in one of the texts.
struct Change {
  text::SourcePtr source;
  std::vector<Splice> splices;  ///< ascending
};
/// The text with the change done to it.
std::string changed_text(const Change& change);

/// What giving something another name changes in the whole project.
struct Renaming {
  std::string from;
  std::string kind;
  std::vector<Change> changes;  ///< one for each file, the declaring one's first
  /// A file that names it, and stays as it is.
  struct UnchangedFile {
    text::SourcePtr source;
    std::size_t places = 0;
    std::string why;  ///< as Surroundings::fixed
  };
  std::vector<UnchangedFile> kept;
  std::vector<std::string> notes;  ///< what else follows from it: sentences
};
/// Why it can't be had.
struct Refusal {
  std::string message;  ///< a sentence
  text::Place place;    ///< what is in the way; no source: nothing in a text
};
/// Gives it another name in all texts of the project. Was tried: every place that named it names it still, no
/// other one does, and no text has an error that it had not before.
std::expected<Renaming, Refusal> rename(const Text& text, std::uint32_t cursor, const std::string& name,
                                        const Surroundings& around);

/// A declaration in a text, with those inside of it.
struct Symbol {
  std::string name;
  std::string kind;    ///< as `Candidate::kind`
  std::string detail;  ///< its type
  text::Span span;     ///< of all of it
  text::Span name_span;
  std::vector<Symbol> parts;
  std::string help = {};  ///< its first sentence
};
std::vector<Symbol> symbols(const Text& text, const Surroundings& around);

/// Lines that can be folded away, from the one that stays to the last that goes; both count from 1.
struct Fold {
  std::uint32_t first = 1;
  std::uint32_t last = 1;
  bool is_comment = false;

  friend bool operator==(const Fold&, const Fold&) = default;
};
/// What stands between braces, declarations, steps, comments of several lines; by line.
std::vector<Fold> folds(const Text& text, const Surroundings& around);

/// What a text leaves out, for somebody who reads it.
struct Hint {
  std::uint32_t at = 0;  ///< where it would stand
  std::string text;      ///< `m/s`, `radius:`
  bool is_unit = false;  ///< behind a number; false: a name before an argument
  std::string help;      ///< of the input; one line
};
/// Units of numbers that are written without one, names of inputs to which a number, text or list is given by
/// position. Ascending.
std::vector<Hint> hints(const Text& text, const Surroundings& around);

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

}  // namespace mlab::assist
