#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>

#include "mlab/lang/mdl/token.h"
#include "mlab/mission/tasks.h"
#include "mlab/percept/formation_names.h"

namespace mlab::mdl {
namespace {

constexpr Keyword word(std::string_view text, Word which) {
  return {text, TokenKind::kWord, which, 0};
}
constexpr Keyword boolean(std::string_view text, std::uint8_t value) {
  return {text, TokenKind::kBoolean, Word::kNone, value};
}
constexpr Keyword technique(std::string_view text, std::uint8_t value) {
  return {text, TokenKind::kTechnique, Word::kNone, value};
}

// Besides commands of units and formations. The first spelling of a word is the canonical one.
constexpr auto kOwn = std::to_array<Keyword>({
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
    word("QUIT", Word::kQuit),
    word("SET", Word::kSet),
    word("PRINT", Word::kPrint),
    word("FAILSAFE", Word::kFailsafe),
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
    word("FAILING-ROBOTS", Word::kFailingRobots),
    word("FAILURES-WITHIN", Word::kFailuresWithin),
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
    technique("TRAVELING", 0),
    technique("TRAVELING-OVERWATCH", 1),
    technique("BOUNDING-OVERWATCH", 2),
});

constexpr std::size_t kSecondSpellings = static_cast<std::size_t>(
    std::ranges::count_if(mission::kTasks, [](const mission::TaskInfo& task) { return !task.also.empty(); }));

constexpr auto kWritten = [] {
  std::array<Keyword, kOwn.size() + mission::kTasks.size() + kSecondSpellings + percept::kFormations.size()>
      out;
  auto next = std::ranges::copy(kOwn, out.begin()).out;
  for (const mission::TaskInfo& task : mission::kTasks) {
    *next++ = word(task.word, word_of(task.task));
    if (!task.also.empty()) *next++ = word(task.also, word_of(task.task));
  }
  for (const percept::FormationInfo& one : percept::kFormations)
    *next++ = {one.keyword, TokenKind::kFormation, Word::kNone, static_cast<std::uint8_t>(one.formation)};
  return out;
}();

// For the search.
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

std::span<const Keyword> keywords() {
  return kWritten;
}

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
