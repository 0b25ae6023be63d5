#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "mlab/overlay/measure_kinds.h"
#include "mlab/text/source.h"

namespace mlab::odl {

/// The reserved words. A word is one of these only where a keyword may stand; as a name it is just a name.
enum class Keyword : std::uint8_t {
  kNone,
  // information, before CONTROL MEASURES:
  kScenario,
  kSite,
  kOrigin,
  kGlobalRefPoint,
  kHeading,
  kMissionArea,
  kLoadMap,
  kSet,
  kScale,
  kHeightmap,
  kControlMeasures,
  // features that are no control measures, after it
  kAttractor,
  kObject,
  kBasket,
  kFlag,
  kObstacle,
  kWaypointFile,
  // inside a statement
  kZoomFactor,
  kLat,
  kLon,
  kUtm,
  kGeo,
  kCenterline,
  kWidth,
  kExtents,
  kRoute,
  kSpeed,
  kMovable,
  kFixed,
  kContainer,
  kFirstMeasure  ///< from here on the kinds of control measures, by their numbers
};
/// The word that begins the statement of a control measure.
constexpr Keyword keyword_of(overlay::MeasureKind kind) {
  return static_cast<Keyword>(static_cast<std::uint8_t>(Keyword::kFirstMeasure) +
                              static_cast<std::uint8_t>(kind));
}
/// The kind whose statement begins with it; nothing where it is no control measure.
constexpr std::optional<overlay::MeasureKind> measure_of(Keyword k) {
  if (k < Keyword::kFirstMeasure) return std::nullopt;
  return static_cast<overlay::MeasureKind>(static_cast<std::uint8_t>(k) -
                                           static_cast<std::uint8_t>(Keyword::kFirstMeasure));
}

/// How a reserved word is written, and what it means.
struct Word {
  Keyword keyword = Keyword::kNone;
  std::string_view spelling;  ///< `MISSION-AREA`
  std::string_view also;      ///< a second spelling; empty: none
  std::string_view help;      ///< a line for people who write it
};
/// All reserved words: those before CONTROL MEASURES, that header, features, those inside of statements.
std::span<const Word> words();

/// How it is written: `MISSION-AREA`; empty for kNone.
std::string_view spelling(Keyword keyword);
/// The reserved word that a word is, whatever its letter case; kNone for any other word.
Keyword find_keyword(std::string_view word);
constexpr bool is_information(Keyword k) {
  return k >= Keyword::kScenario && k <= Keyword::kHeightmap;
}
constexpr bool is_feature(Keyword k) {
  return (k >= Keyword::kAttractor && k <= Keyword::kWaypointFile) || k >= Keyword::kFirstMeasure;
}
/// True where a statement (or the header) can begin with it.
constexpr bool starts_statement(Keyword k) {
  return is_information(k) || k == Keyword::kControlMeasures || is_feature(k);
}

enum class TokenKind : std::uint8_t {
  kNumber,  ///< `12`, `-.5`, `605.`, `1e+3`
  kWord,    ///< a name or a reserved word, perhaps with a final `*`
  kFile,    ///< a run of letters, digits, `_`, `-`, `.` that is neither of these
  kString,  ///< in quotes; without the closing one where the line ended first
  kHeader,  ///< `CONTROL MEASURES:`
  kEnd
};

struct Token {
  TokenKind kind = TokenKind::kEnd;
  Keyword keyword = Keyword::kNone;  ///< of a word; the parser clears it where the word serves as a name
  bool starts_line = false;          ///< first token of its line
  bool after_blank_line = false;     ///< a blank line stands between it and what comes before it
  text::Span span;
  std::uint32_t comments_begin = 0;  ///< the comments between the token before and this one, as a range of
  std::uint32_t comments_end = 0;    ///< `Tree::comments`
};

struct Comment {
  text::Span span;  ///< from `--`, without white space at its end
  bool starts_line = false;
  bool after_blank_line = false;
};

}  // namespace mlab::odl
