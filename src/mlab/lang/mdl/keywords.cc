#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

#include "mlab/lang/mdl/token.h"

namespace mlab::mdl {
namespace {

constexpr Keyword word(std::string_view text, Word which) {
  return {text, TokenKind::kWord, which, 0};
}
constexpr Keyword boolean(std::string_view text, std::uint8_t value) {
  return {text, TokenKind::kBoolean, Word::kNone, value};
}
constexpr Keyword formation(std::string_view text, std::uint8_t value) {
  return {text, TokenKind::kFormation, Word::kNone, value};
}
constexpr Keyword technique(std::string_view text, std::uint8_t value) {
  return {text, TokenKind::kTechnique, Word::kNone, value};
}

// The first spelling of a word is the canonical one. Sorted by the compiler below.
constexpr auto kWritten = std::to_array<Keyword>({
    word("SCENARIO", Word::kScenario),
    word("OVERLAY", Word::kOverlay),
    word("MISSION-AREA", Word::kMissionArea),
    word("LOAD-MAP", Word::kLoadMap),
    word("SP", Word::kSp),
    word("UNIT", Word::kUnit),
    word("HEIGHTMAP", Word::kHeightMap),
    word("NEW-ROBOT", Word::kNewRobot),
    word("CREATE-OBSTACLES", Word::kCreateObstacles),
    word("OBSTACLE", Word::kObstacle),
    word("START", Word::kStart),
    word("MOVETO", Word::kMoveTo),
    word("TELEOPERATE", Word::kTeleoperate),
    word("TELOP", Word::kTeleoperate),
    word("SWEEPTO", Word::kSweepTo),
    word("OCCUPY", Word::kOccupy),
    word("FOLLOW", Word::kFollow),
    word("STOP", Word::kStop),
    word("QUIT", Word::kQuit),
    word("SET", Word::kSet),
    word("PRINT", Word::kPrint),
    word("CONSOLE-DATABASE", Word::kConsoleDatabase),
    word("CONSOLE-DB", Word::kConsoleDatabase),
    word("ROBOT-INFO", Word::kRobotInfo),
    word("AND", Word::kAnd),
    word("FORMATION", Word::kFormation),
    word("TECHNIQUE", Word::kTechnique),
    word("SPEED", Word::kSpeed),
    word("PHASE-LINE", Word::kPhaseLine),
    word("UNTIL", Word::kUntil),
    word("TIMEOUT", Word::kTimeout),
    word("ON-COMPLETION", Word::kOnCompletion),
    word("ACKNOWLEDGE", Word::kAcknowledge),
    word("ACK", Word::kAcknowledge),
    word("MESSAGE", Word::kMessage),
    word("MSG", Word::kMessage),
    word("WAIT", Word::kWait),
    word("SEED", Word::kSeed),
    word("SYSTEM-SEED", Word::kSeed),
    word("SHOW-TRAILS", Word::kShowTrails),
    word("SHOW-ROBOT-TRAILS", Word::kShowTrails),
    word("HIGHLIGHT-REPELLING-OBSTACLES", Word::kHighlightRepellingObstacles),
    word("SHOW-REPELLING-OBSTACLES", Word::kHighlightRepellingObstacles),
    word("USE-MILITARY-STYLE", Word::kUseMilitaryStyle),
    word("SHOW-MILITARY-STYLE", Word::kUseMilitaryStyle),
    word("SHOW-MOVEMENT-VECTORS", Word::kShowMovementVectors),
    word("SHOW-COLORMAP", Word::kShowColormap),
    word("OBSTACLE-COVERAGE", Word::kObstacleCoverage),
    word("ZOOM-FACTOR", Word::kZoomFactor),
    word("SCALE-ROBOTS", Word::kScaleRobots),
    word("ROBOT-LENGTH", Word::kRobotLength),
    word("MIN-OBSTACLE-RADIUS", Word::kMinObstacleRadius),
    word("MAX-OBSTACLE-RADIUS", Word::kMaxObstacleRadius),
    word("CYCLE-DURATION", Word::kCycleDuration),
    word("DEBUG-ROBOTS", Word::kDebugRobots),
    word("DEBUG-SIMULATOR", Word::kDebugSimulator),
    word("DEBUG-SCHEDULER", Word::kDebugScheduler),
    word("INJECTTRACK", Word::kInjectTrack),
    word("RED", Word::kRed),
    word("YELLOW", Word::kYellow),
    word("ROBOT", Word::kRobot),
    boolean("ON", 1),
    boolean("TRUE", 1),
    boolean("YES", 1),
    boolean("OFF", 0),
    boolean("FALSE", 0),
    boolean("NO", 0),
    formation("NO-FORMATION", 0),
    formation("LINE", 1),
    formation("LINE-LEFT", 2),
    formation("LINE-RIGHT", 3),
    formation("WEDGE", 4),
    formation("WEDGE-LEFT", 5),
    formation("WEDGE-RIGHT", 6),
    formation("DIAMOND", 7),
    formation("COLUMN", 8),
    formation("SWEEP", 9),
    technique("TRAVELING", 0),
    technique("TRAVELING-OVERWATCH", 1),
    technique("BOUNDING-OVERWATCH", 2),
});

constexpr auto kSorted = [] {
  auto sorted = kWritten;
  std::ranges::sort(sorted, {}, &Keyword::text);
  return sorted;
}();

constexpr std::size_t kLongest =
    std::ranges::max(kWritten, {}, [](const Keyword& k) { return k.text.size(); }).text.size();

constexpr char upper(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}
constexpr char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

}  // namespace

const Keyword* find_keyword(std::string_view text) {
  if (text.size() > kLongest) return nullptr;
  std::array<char, kLongest> buffer{};
  std::ranges::transform(text, buffer.begin(), upper);
  const std::string_view wanted(buffer.data(), text.size());
  const auto* found = std::ranges::lower_bound(kSorted, wanted, {}, &Keyword::text);
  return found != kSorted.end() && found->text == wanted ? found : nullptr;
}

std::string_view spelling(Word which) {
  const auto* found = std::ranges::find(kWritten, which, &Keyword::word);
  return found == kWritten.end() ? std::string_view{} : found->text;
}

bool equal_without_case(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](char x, char y) { return lower(x) == lower(y); });
}

std::string lower_case(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), lower);
  return out;
}

}  // namespace mlab::mdl
