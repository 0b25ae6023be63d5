#pragma once

#include <cstddef>
#include <expected>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/text/source.h"

namespace mlab::text {

enum class Severity {
  kError,
  kWarning,
  kNote,  ///< nothing is wrong, and people should know it all the same
};

std::string_view name(Severity severity);

/// A second place that a diagnostic speaks of ("declared here").
struct Note {
  std::string message;
  Place place;
};

/// One thing that is wrong, said so that its author can mend it: what stands there, then the rule.
/// Lower case, no full stop, names in backticks.
struct Diagnostic {
  Severity severity = Severity::kError;
  std::string kind;     ///< stable, kebab-case: `unknown-control-measure`
  std::string message;  ///< first line
  Place place;          ///< the narrowest wrong thing
  std::string label;    ///< said beside the carets; may be empty
  std::vector<std::string> hints;
  std::vector<Note> notes;
};

/// Collects what a parser or checker has to say. Parsers go on after an error; the sink keeps the first
/// `kMaxErrors` errors and as many warnings and notes, and counts the rest.
class Diagnostics {
 public:
  static constexpr std::size_t kMaxErrors = 100;

  void report(Diagnostic diagnostic);
  /// Shorthands for the common case; the returned reference takes label, hints and notes, and is valid until
  /// the next report.
  Diagnostic& error(std::string kind, Place place, std::string message);
  Diagnostic& warning(std::string kind, Place place, std::string message);
  Diagnostic& note(std::string kind, Place place, std::string message);

  const std::vector<Diagnostic>& items() const { return items_; }
  std::size_t error_count() const { return error_count_; }
  std::size_t warning_count() const { return warning_count_; }
  std::size_t note_count() const { return note_count_; }
  bool has_errors() const { return error_count_ > 0; }

 private:
  Diagnostic& add(Severity severity, std::string kind, Place place, std::string message);

  std::vector<Diagnostic> items_;
  Diagnostic dropped_;  // takes what is said of a diagnostic past the limit
  std::size_t error_count_ = 0;
  std::size_t warning_count_ = 0;
  std::size_t note_count_ = 0;
};

/// The diagnostic as a person reads it in a terminal:
///
///     demo.mdl:9:23: error: unknown control measure `ATK-AP9` [unknown-control-measure]
///         9 |   2. UNIT scouts MOVETO ATK-AP9 FORMATION Column
///           |                         ^^^^^^^ not in overlay `democ.odl`
///           = hint: did you mean `ATK-AP1`?
///     democ.odl:14:1: note: `ATK-AP1` declared here
///
/// Ends with a newline. Control characters of the source are shown as `?`; long lines are cut around the
/// carets.
std::string render(const Diagnostic& diagnostic);
/// All of them in order, and a line that counts what was dropped.
std::string render(const Diagnostics& diagnostics);

template <class T>
using Result = std::expected<T, Diagnostic>;

/// Reads a whole file. @errors `cannot-read` with the system's reason, `file-too-large`
[[nodiscard]] Result<SourcePtr> read_source(const std::string& path);

/// The candidate that is most like `name` (letter case does not count), or empty when none is near enough
/// that somebody could have meant it.
std::string nearest_name(std::string_view name, std::span<const std::string> candidates);

}  // namespace mlab::text
