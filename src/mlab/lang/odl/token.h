#pragma once

#include <cstdint>
#include <string_view>

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
  // features, after it
  kAa,
  kAtk,
  kAxis,
  kBoundary,
  kAttractor,
  kObject,
  kBasket,
  kFlag,
  kBp,
  kGap,
  kLdlc,
  kObj,
  kObstacle,
  kPl,
  kPp,
  kSp,
  kWall,
  kRoom,
  kDoor,
  kHallway,
  kRoad,
  kWaypointFile,
  // inside a statement
  kZoomFactor,
  kLat,
  kLon,
  kUtm,
  kCenterline,
  kWidth,
  kExtents,
  kMovable,
  kFixed,
  kContainer
};
/// How it is written: `MISSION-AREA`; empty for kNone.
std::string_view spelling(Keyword keyword);
/// The reserved word that a word is, whatever its letter case; kNone for any other word.
Keyword find_keyword(std::string_view word);
constexpr bool is_information(Keyword k) {
  return k >= Keyword::kScenario && k <= Keyword::kHeightmap;
}
constexpr bool is_feature(Keyword k) {
  return k >= Keyword::kAa && k <= Keyword::kWaypointFile;
}
/// True where a statement (or the header) can begin with it.
constexpr bool starts_statement(Keyword k) {
  return k >= Keyword::kScenario && k <= Keyword::kWaypointFile;
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
