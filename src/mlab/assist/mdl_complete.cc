#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string_view>

#include "mlab/assist/statement_candidates.h"
#include "mlab/lang/mdl/token.h"
#include "mlab/mission/maneuver.h"
#include "mlab/mission/search.h"
#include "mlab/mission/tasks.h"
#include "mlab/percept/formation_names.h"

namespace mlab::assist {
namespace {

using mdl::TokenKind;
using mdl::Word;

struct Option {
  Word word;
  bool is_number;
  bool in_steps;
  const char* help;
};
constexpr auto kOptions = std::to_array<Option>({
    {Word::kShowTrails, false, true, "draws where robots have been"},
    {Word::kHighlightRepellingObstacles, false, true, "draws how far obstacles are felt"},
    {Word::kShowMovementVectors, false, true, "draws where robots want to go"},
    {Word::kUseMilitaryStyle, false, true, "draws units with military symbols"},
    {Word::kShowColormap, false, false, "draws the colours"},
    {Word::kScaleRobots, false, false, "robots are drawn in metres, else in pixels"},
    {Word::kRobotLength, true, false, "for drawing"},
    {Word::kZoomFactor, true, false, "10 to 400 per cent"},
    {Word::kCycleDuration, true, true, "0.01 to 1 second"},
    {Word::kFailingRobots, true, false, "how many fail in each simulated run"},
    {Word::kFailuresWithin, true, false, "seconds after their start, at the latest"},
    {Word::kSeed, true, false, "for CREATE-OBSTACLES"},
    {Word::kObstacleCoverage, true, false, "0 to 30 per cent of the area"},
    {Word::kMinObstacleRadius, true, false, "metres"},
    {Word::kMaxObstacleRadius, true, false, "metres"},
    {Word::kDebugRobots, false, true, "tells more"},
    {Word::kDebugSimulator, false, true, "tells more"},
    {Word::kDebugScheduler, false, true, "tells more"},
});

enum class Part { kPreamble, kSteps, kTyped };

/// Looks at the words of the statement that the cursor is in.
class MissionCompleter {
 public:
  MissionCompleter(const std::string& before, bool is_typed, const KnownNames& names,
                   StatementCandidates& out)
      : names_(names), out_(out), part_(is_typed ? Part::kTyped : Part::kPreamble) {
    text::Diagnostics unsaid;
    source_ = std::make_shared<const text::Source>("", before);
    tokens_ = mdl::lex(source_, unsaid).tokens;
    tokens_.pop_back();  // the end
    find_statement(is_typed);
  }

  void run() {
    const bool is_preamble = part_ == Part::kPreamble;
    if (count() == 0) {
      is_preamble ? preamble_words() : command_words();
      return;
    }
    if (is(0, Word::kUnit)) {
      is_preamble ? unit_definition() : unit_command();
      return;
    }
    if (names_robots()) {
      robots_command();
      return;
    }
    if (is(0, Word::kSet)) {
      option();
      return;
    }
    if (is(0, Word::kPrint) && count() == 1) {
      out_.add("CONSOLE-DATABASE", "keyword", "what is known of the map");
      out_.add("ROBOT-INFO", "keyword", "what is known of the robots");
      return;
    }
    if (is(0, Word::kFailsafe) && failsafe()) return;
    if (is(0, Word::kInjectTrack) && count() == 1) {
      out_.add("RED", "keyword");
      out_.add("YELLOW", "keyword");
      return;
    }
    if (is(0, Word::kOverlay) && count() == 1) {
      for (const std::string& file : names_.overlay_files) out_.add_name(file, "overlay", "");
      return;
    }
    if (part_ == Part::kPreamble) {
      if (is_whole_preamble_statement()) preamble_words();
    } else if (is_whole_command()) {
      out_.add("AND", "keyword", "another command that begins together with this one");
    }
  }

 private:
  std::size_t count() const { return tokens_.size() - first_; }
  const mdl::Token& token(std::size_t i) const { return tokens_[first_ + i]; }
  bool is(std::size_t i, Word word) const {
    return i < count() && token(i).kind == TokenKind::kWord && token(i).word == word;
  }
  bool last_is(Word word) const { return count() > 0 && is(count() - 1, word); }

  static bool starts_preamble_statement(const mdl::Token& t) {
    if (t.kind == TokenKind::kMissionName) return true;
    if (t.kind != TokenKind::kWord) return false;
    switch (t.word) {
      case Word::kScenario:
      case Word::kOverlay:
      case Word::kMissionArea:
      case Word::kLoadMap:
      case Word::kSp:
      case Word::kUnit:
      case Word::kNewRobot:
      case Word::kCreateObstacles:
      case Word::kObstacle:
      case Word::kSet:
      case Word::kPrint:
      case Word::kFailsafe:
        return true;
      default:
        return false;
    }
  }

  // In the preamble the last word that begins a statement and a line does; in steps what follows a label or
  // AND.
  void find_statement(bool is_typed) {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
      const mdl::Token& t = tokens_[i];
      const bool is_header = t.kind == TokenKind::kCommandList || t.kind == TokenKind::kImmediateCommand;
      if (t.kind == TokenKind::kCommandList && !is_typed) part_ = Part::kSteps;
      const bool is_and = t.kind == TokenKind::kWord && t.word == Word::kAnd;
      if (is_header || is_and || (t.kind == TokenKind::kLabel && part_ == Part::kSteps)) {
        first_ = i + 1;
      } else if (part_ == Part::kPreamble && starts_preamble_statement(t) && (t.first_on_line || i == 0)) {
        first_ = i;
      }
    }
  }

  void preamble_words() {
    for (const auto& [word, help] : std::to_array<std::pair<const char*, const char*>>(
             {{"MISSION NAME", "name: the title"},
              {"SCENARIO", "name: a second title"},
              {"OVERLAY", "file: loads a map"},
              {"MISSION-AREA", "width height"},
              {"LOAD-MAP", "file: a background picture"},
              {"SP", "name x y: a start place"},
              {"OBSTACLE", "x y radius"},
              {"CREATE-OBSTACLES", "random ones, in place of all others"},
              {"NEW-ROBOT", "type program [colour [host]] [(parameters)]"},
              {"UNIT", "<name> robots: a group of robots"},
              {"SET", "option value"},
              {"PRINT", "what is known"},
              {"FAILSAFE", "condition action: what holds below all programs"},
              {"COMMAND LIST:", "the steps follow"}})) {
      out_.add(word, "keyword", help);
    }
  }

  void command_words() {
    out_.add("UNIT", "keyword", "name action: tells a unit what to do");
    out_.add("ROBOT", "keyword", "number action: tells one robot what to do");
    out_.add("ROBOTS", "keyword", "numbers action: robots that are a unit as long as the command lasts");
    out_.add("SET", "keyword", "option value");
    out_.add("PRINT", "keyword", "what is known");
    out_.add("QUIT", "keyword", "ends the run");
    if (part_ != Part::kTyped) return;
    out_.add("OBSTACLE", "keyword", "x y radius");
    out_.add("CREATE-OBSTACLES", "keyword", "random ones, in place of all others");
    out_.add("INJECTTRACK", "keyword", "has no effect");
  }

  // What may come next in one; false: it is whole.
  bool failsafe() {
    const auto is_written = [&](std::size_t i, std::string_view word) {
      return i < count() && mdl::equal_without_case(source_->text(token(i).span), word);
    };
    const bool has_type = is_written(1, "FOR");
    if (has_type && count() == 2) {
      robot_types();
      return true;
    }
    std::size_t begin = has_type ? 3 : 1;  // of the condition
    if (count() <= begin) {
      for (const mission::FailsafeConditionInfo& one : mission::kFailsafeConditions)
        out_.add(std::string(one.word), "keyword", std::string(one.help));
      if (!has_type) out_.add("FOR", "keyword", "type of robots that it holds for; without, all");
      return true;
    }
    const bool has_fence = is_written(begin, mission::info(mission::FailsafeCondition::kOutside).word);
    if (has_fence && count() == begin + 1) {
      places(any);
      return true;
    }
    const bool has_share = is_written(begin, mission::info(mission::FailsafeCondition::kBattery).word);
    if (has_share && count() < begin + 4) {
      if (count() == begin + 1) out_.add("BELOW", "keyword", "per cent of the battery: `BELOW 30%`");
      return true;
    }
    if (has_share) begin += 3;  // of what stands behind it
    if (is_written(count() - 1, "AFTER")) return true;
    if (count() > begin + 1 && !has_fence && !is_written(count() - 2, "AFTER")) return false;
    if (has_fence && count() > begin + 2) return false;
    if (!has_fence && count() == begin + 1) out_.add("AFTER", "keyword", "seconds for which it has to hold");
    for (const mission::FailsafeActionInfo& one : mission::kFailsafeActions) {
      if (!one.needs_fence || has_fence) out_.add(std::string(one.word), "keyword", std::string(one.help));
    }
    return true;
  }

  bool is_whole_preamble_statement() const {
    const bool is_named = is(0, Word::kOverlay) || is(0, Word::kScenario) || is(0, Word::kLoadMap) ||
                          token(0).kind == TokenKind::kMissionName || is(0, Word::kPrint);
    if (is_named) return count() == 2;
    if (is(0, Word::kMissionArea)) return count() == 3;
    if (is(0, Word::kSp) || is(0, Word::kObstacle)) return count() == 4;
    if (is(0, Word::kFailsafe)) return true;  // of one that isn't whole more was said already
    return is(0, Word::kCreateObstacles) ? count() == 1 : is(0, Word::kNewRobot) && count() >= 3;
  }

  bool is_whole_command() const {
    if (is(0, Word::kObstacle)) return count() == 4;
    return is(0, Word::kPrint) ? count() == 2 : is(0, Word::kQuit) || is(0, Word::kCreateObstacles);
  }

  void unit_definition() {
    const TokenKind last = token(count() - 1).kind;
    if (last == TokenKind::kLess || count() == 1) return;
    robot_types();
    if (last != TokenKind::kGreater && last != TokenKind::kOpen) preamble_words();
  }

  void robot_types() {
    if (names_.mission == nullptr) {
      out_.add("ROBOT", "robot", "the standard robot");
      return;
    }
    for (const mission::RobotType& type : names_.mission->types)
      mdl::equal_without_case(type.name, "ROBOT") ? out_.add("ROBOT", "robot", "the standard robot")
                                                  : out_.add_name(type.name, "robot", type.program);
    for (const mission::Society& society : names_.mission->societies)
      out_.add_name(society.name, "society", "all of its robots");
  }

  void unit_command() {
    if (count() == 1) {
      units();
      return;
    }
    if (token(1).kind == TokenKind::kLess) {
      robot_types();
      return;
    }
    behind_addressee(2);
  }

  // ROBOT is a word of the language, ROBOTS only where a command begins.
  bool names_robots() const {
    if (part_ == Part::kPreamble) return false;
    return is(0, Word::kRobot) || (token(0).kind == TokenKind::kName &&
                                   mdl::equal_without_case(source_->text(token(0).span), "ROBOTS"));
  }

  void robots_command() {
    std::size_t i = 1;
    while (i < count() && token(i).kind == TokenKind::kNumber) ++i;
    const bool takes_more = i == 1 || token(0).kind == TokenKind::kName;
    if (i == count() && takes_more) robots();
    if (i > 1) behind_addressee(i);
  }

  void robots() {
    if (names_.mission == nullptr) return;
    for (const mission::Robot& robot : names_.mission->robots) {
      const std::string number = std::to_string(robot.id.value);
      const bool is_named =
          std::ranges::any_of(tokens_.begin() + static_cast<std::ptrdiff_t>(first_), tokens_.end(),
                              [&](const mdl::Token& t) { return source_->text(t.span) == number; });
      if (!is_named) out_.add(number, "robot", names_.mission->types[robot.type].name);
    }
  }

  // `at`: the word that says what shall be done.
  void behind_addressee(std::size_t at) {
    if (count() == at) {
      actions();
      return;
    }
    const mdl::Token& action = token(at);
    if (action.kind != TokenKind::kWord) return;
    const std::optional<mission::Task> task = mdl::task_of(action.word);
    if (!task) return;
    if (mission::info(*task).place.empty()) {
      out_.add("AND", "keyword", "another command that begins together with this one");
      return;
    }
    if (count() == at + 1) {
      const std::string_view wanted = mission::info(*task).place;
      places([&](const overlay::ControlMeasure& measure) {
        return wanted == "line" ? measure.is_line() : wanted != "area" || !mission::area_of(measure).empty();
      });
      return;
    }
    if (mission::info(*task).place == "places" && is_places(at + 1)) places(any);
    const std::size_t behind_place = at + (token(at + 1).kind == TokenKind::kNumber ? 3 : 2);
    if (count() >= behind_place) clauses(*task);
  }

  // Whether from there on nothing else stands.
  bool is_places(std::size_t from) const {
    for (std::size_t i = from; i < count(); ++i) {
      const TokenKind kind = token(i).kind;
      if (kind != TokenKind::kName && kind != TokenKind::kString && kind != TokenKind::kNumber) return false;
    }
    return true;
  }

  void units() {
    if (part_ == Part::kTyped) out_.add("<", "keyword", "defines a new unit");
    if (names_.mission == nullptr) return;
    for (const mission::Unit& unit : names_.mission->units) {
      if (unit.name.empty()) continue;
      const std::size_t robots = unit.members.size();
      out_.add_name(unit.name, "unit", std::to_string(robots) + (robots == 1 ? " robot" : " robots"));
    }
  }

  void actions() {
    // What moves robots comes first.
    for (const bool has_clauses : {true, false}) {
      for (const mission::TaskInfo& task : mission::kTasks) {
        if ((task.clauses != 0) != has_clauses) continue;
        const std::string place(task.place);
        out_.add(std::string(task.word), "keyword",
                 place + (place.empty() ? "" : ": ") + std::string(task.help));
      }
    }
  }

  static bool any(const overlay::ControlMeasure& /*measure*/) { return true; }
  template <class Fits>
  void places(const Fits& fits) {
    if (names_.map == nullptr) return;
    for (const overlay::ControlMeasure& measure : names_.map->measures) {
      if (!fits(measure)) continue;
      const std::string kind(overlay::keyword(measure.kind));
      const std::string full = kind + '-' + measure.name;
      const bool is_found = overlay::find_measure(*names_.map, full) == &measure;
      if (measure.name.empty()) continue;
      out_.add_name(is_found ? full : measure.name, "place", kind, measure.name);
    }
  }

  void clauses(mission::Task task) {
    const Word last = token(count() - 1).kind == TokenKind::kWord ? token(count() - 1).word : Word::kNone;
    const bool is_behind_equals = token(count() - 1).kind == TokenKind::kEquals;
    const Word asked =
        is_behind_equals && token(count() - 2).kind == TokenKind::kWord ? token(count() - 2).word : last;
    switch (asked) {
      case Word::kFormation:
        formations();
        return;
      case Word::kTechnique:
        techniques();
        return;
      case Word::kPhaseLine:
        places(any);
        return;
      case Word::kUntil:
        out_.add("TIMEOUT", "keyword",
                 task == mission::Task::kOccupy ? "seconds, from when the unit is in place"
                                                : "seconds, from when the command begins");
        return;
      case Word::kOnCompletion:
        out_.add("MESSAGE", "keyword", "text");
        return;
      case Word::kSpeed:
      case Word::kTimeout:
      case Word::kAcknowledge:
      case Word::kMessage:
        return;  // a number or a text
      default:
        break;
    }
    if (is_behind_phase_line(1)) out_.add("ACKNOWLEDGE", "keyword", "text that you acknowledge");
    if (count() > 2 && is(count() - 2, Word::kAcknowledge))
      out_.add("WAIT", "keyword", "the unit halts until then");
    for (const mission::ClauseInfo& clause : mission::kClauses) {
      if (!mission::takes(task, clause.kind)) continue;
      const bool proceeds = clause.kind == mission::ClauseKind::kUntil && task == mission::Task::kOccupy;
      out_.add(std::string(clause.word), "keyword",
               proceeds ? "when it goes on without your answer" : std::string(clause.argument));
    }
    out_.add("AND", "keyword", "another command that begins together with this one");
    if (mission::takes(task, mission::ClauseKind::kFormation)) formations();
    if (mission::takes(task, mission::ClauseKind::kTechnique)) techniques();
  }

  bool is_behind_phase_line(std::size_t words) const {
    return count() > words + 1 && is(count() - 1 - words, Word::kPhaseLine);
  }

  void formations() {
    for (const percept::FormationInfo& one : percept::kFormations)
      out_.add(std::string(one.name), "formation", "");
  }

  void techniques() {
    out_.add("Traveling", "technique", "all move");
    out_.add("Traveling-Overwatch", "technique", "the rear part keeps its distance");
    out_.add("Bounding-Overwatch", "technique", "one part moves, the other one watches");
  }

  void option() {
    if (count() == 1) {
      for (const Option& each : kOptions) {
        if (each.in_steps || part_ != Part::kSteps)
          out_.add(std::string(mdl::spelling(each.word)), "option", each.help);
      }
      if (part_ == Part::kPreamble) {
        for (const mission::ManeuverInfo& each : mission::kManeuvers)
          out_.add(std::string(each.word), "option", std::string(each.help));
      }
      return;
    }
    const auto* const maneuver =
        std::ranges::find_if(mission::kManeuvers, [&](const mission::ManeuverInfo& each) {
          return mdl::equal_without_case(source_->text(tokens_[first_ + 1].span), each.word);
        });
    if (maneuver != mission::kManeuvers.end()) {
      if (count() == 2 && !maneuver->on.empty()) {
        out_.add(std::string(maneuver->on), "value", "");
        out_.add(std::string(maneuver->off), "value", "");
      } else if (count() == 3) {
        preamble_words();
      }
      return;
    }
    const auto found = std::ranges::find_if(kOptions, [&](const Option& each) { return is(1, each.word); });
    if (count() == 2 && found != kOptions.end() && !found->is_number) {
      out_.add("ON", "value", "");
      out_.add("OFF", "value", "");
    }
    const bool is_whole = found != kOptions.end() && (count() == 3 || (count() == 2 && !found->is_number));
    if (!is_whole) return;
    if (part_ == Part::kPreamble) {
      preamble_words();
      return;
    }
    out_.add("AND", "keyword", "another command that begins together with this one");
  }

  const KnownNames& names_;
  StatementCandidates& out_;
  Part part_;
  text::SourcePtr source_;
  std::vector<mdl::Token> tokens_;
  std::size_t first_ = 0;  // word of the statement at the cursor
};

}  // namespace

void complete_mission(const std::string& before, bool is_typed, const KnownNames& names,
                      StatementCandidates& out) {
  MissionCompleter(before, is_typed, names, out).run();
}

}  // namespace mlab::assist
