#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/study/condition.h"
#include "mlab/study/dimension.h"
#include "mlab/text/diagnostic.h"

namespace mlab::study {

/// What a batch is: which mission, how often, with what in place of what it says, and what is asked of it.
struct Definition {
  Written mission;           ///< file
  Written against;           ///< file of another version that is compared in pairs; empty: none
  std::uint32_t runs = 100;  ///< of each combination
  std::uint64_t seed = 1;    ///< of the first run of each combination; the others follow
  std::vector<Dimension> dimensions;
  bool is_paired =
      false;  ///< the first values of all lists together, then the second ones; else each with each
  bool is_latin = false;           ///< drawn values fill a Latin hypercube; else each by itself
  std::string start_time;          ///< as --start-time; empty: now
  text::Place start_time_place;    ///< where it was written
  double patience = 600.0;         ///< [s]
  std::optional<double> limit;     ///< as RunOptions
  std::optional<double> duration;  ///< likewise
  Written environment;             ///< file; empty: none
  std::optional<Condition> success;
  std::vector<Requirement> requirements;
  std::optional<Until> until;
  double confidence = 0.0;  ///< of intervals that are shown; 0: that of the first requirement

  std::string table;       ///< file, CSV or JSON by its name; empty: none
  std::string page;        ///< HTML file; empty: none
  std::string recordings;  ///< folder; `none`: no run is recorded; empty: by the others' names
  std::string results;     ///< file that runs are kept in; empty: by the others' names
};

/// In place of a folder of recordings.
inline constexpr std::string_view kNoRecordings = "none";

/// A field of a definition: an option of the command line, and a key of a study's file.
struct Field {
  std::string_view name;   ///< `runs`; `--runs`
  std::string_view value;  ///< what stands there, for help: `N`
  std::string_view help;
  bool is_file = false;      ///< relative to the study's file where it stands in one
  bool is_repeated = false;  ///< a list in the file
};
std::span<const Field> fields();

/// Takes what was written for a field.
/// @errors  what can't be understood, at its place
std::optional<text::Diagnostic> take(Definition& definition, std::string_view field, const Written& value);

/// To be called once all is there: fills in what follows from the rest.
/// @errors  what only can be said now: lists of different lengths that are to be paired, `decided` without a
///          requirement, two settings of one name, or one of a name that the table has for a column
std::optional<text::Diagnostic> settle(Definition& definition);

}  // namespace mlab::study
