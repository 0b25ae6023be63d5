#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/mission/tasks.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/source.h"

namespace mlab::mdl {

/// Reserved words, synonyms folded. HEADING and FREEZE are none: they are told by where they stand.
enum class Word : std::uint8_t {
  kNone,
  // statements
  kScenario,
  kOverlay,
  kMissionArea,
  kLoadMap,
  kSp,
  kUnit,
  kHeightMap,
  kNewRobot,
  kCreateObstacles,
  kObstacle,
  kSet,
  kPrint,
  kFailsafe,
  kQuit,
  kInjectTrack,
  // clauses
  kAnd,
  kFormation,
  kTechnique,
  kSpeed,
  kPhaseLine,
  kUntil,
  kTimeout,
  kOnCompletion,
  kAcknowledge,
  kMessage,
  kWait,
  // options
  kSeed,
  kShowTrails,
  kHighlightRepellingObstacles,
  kUseMilitaryStyle,
  kShowMovementVectors,
  kShowColormap,
  kObstacleCoverage,
  kZoomFactor,
  kScaleRobots,
  kRobotLength,
  kMinObstacleRadius,
  kMaxObstacleRadius,
  kCycleDuration,
  kFailingRobots,
  kFailuresWithin,
  kDebugRobots,
  kDebugSimulator,
  kDebugScheduler,
  // the rest
  kConsoleDatabase,
  kRobotInfo,
  kRed,
  kYellow,
  kRobot,
  kFirstTask  ///< from here on what units do, by the numbers of mission::Task
};
/// The word of a command of a unit.
constexpr Word word_of(mission::Task task) {
  return static_cast<Word>(static_cast<std::uint8_t>(Word::kFirstTask) + static_cast<std::uint8_t>(task));
}
/// The command of a unit that begins with it, where one does.
constexpr std::optional<mission::Task> task_of(Word word) {
  if (word < Word::kFirstTask) return std::nullopt;
  return static_cast<mission::Task>(static_cast<std::uint8_t>(word) -
                                    static_cast<std::uint8_t>(Word::kFirstTask));
}
constexpr bool is_statement(Word word) {
  return word >= Word::kScenario && word <= Word::kInjectTrack;
}
constexpr bool is_clause(Word word) {
  return word >= Word::kAnd && word <= Word::kWait;
}
constexpr bool is_option(Word word) {
  return word >= Word::kSeed && word <= Word::kDebugScheduler;
}

enum class TokenKind : std::uint8_t {
  kEnd,
  kMissionName,       ///< `MISSION NAME`
  kCommandList,       ///< `COMMAND LIST:`
  kImmediateCommand,  ///< `IMMEDIATE COMMAND:`
  kWord,              ///< a reserved word
  kBoolean,           ///< `value` 1 or 0
  kFormation,         ///< `value` a percept::Formation
  kTechnique,         ///< `value` a mission::Technique
  kName,
  kString,
  kFile,  ///< a name with points, slashes or a digit first; understood after OVERLAY alone
  kNumber,
  kTime,
  kDate,
  kLabel,  ///< with its point
  kColon,
  kOpen,
  kClose,
  kLess,
  kGreater,
  kEquals,
  kComma,
  kPercent  ///< behind `BELOW` and a number alone; elsewhere it is skipped
};

struct Token {
  TokenKind kind = TokenKind::kEnd;
  Word word = Word::kNone;
  std::uint8_t value = 0;
  bool first_on_line = false;
  bool blank_line_before = false;  ///< between it and the token or comment before it
  text::Span span;
};

/// From `--` to the end of the line, blanks at the end left out.
struct CommentToken {
  text::Span span;
  std::uint32_t next_token = 0;  ///< index of the token that follows
  bool own_line = false;
  bool blank_line_before = false;
};

struct Tokens {
  std::vector<Token> tokens;  ///< the last one is kEnd
  std::vector<CommentToken> comments;
};

/// Cuts the text into tokens. Characters that belong to no token are skipped with a warning.
Tokens lex(const text::SourcePtr& source, text::Diagnostics& diagnostics);

/// A reserved word of the language, as the lexer tells it.
struct Keyword {
  std::string_view text;
  TokenKind kind = TokenKind::kWord;
  Word word = Word::kNone;
  std::uint8_t value = 0;
};
/// All of them; of several spellings of a word the canonical one comes first.
std::span<const Keyword> keywords();
/// Null where the text is no reserved word. Letter case does not count.
const Keyword* find_keyword(std::string_view text);
/// How the canonical layout writes the word.
std::string_view spelling(Word which);

bool equal_without_case(std::string_view a, std::string_view b);
std::string lower_case(std::string_view text);

}  // namespace mlab::mdl
