#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/lang/mdl/options.h"
#include "mlab/lang/mdl/parser.h"
#include "mlab/lang/mdl/quoted.h"
#include "mlab/lang/odl/token.h"
#include "mlab/mission/maneuver.h"

namespace mlab::mdl {
namespace {

using mission::BooleanOption;
using mission::NumberOption;

struct OptionWord {
  Word word;
  std::variant<BooleanOption, NumberOption> option;
  bool in_steps;
};
// Those of kManeuvers stand before the steps only.
constexpr auto kOptions = std::to_array<OptionWord>({
    {Word::kUseMilitaryStyle, BooleanOption::kUseMilitaryStyle, true},
    {Word::kShowTrails, BooleanOption::kShowTrails, true},
    {Word::kHighlightRepellingObstacles, BooleanOption::kHighlightRepellingObstacles, true},
    {Word::kShowMovementVectors, BooleanOption::kShowMovementVectors, true},
    {Word::kShowColormap, BooleanOption::kShowColormap, false},
    {Word::kDebugRobots, BooleanOption::kDebugRobots, true},
    {Word::kDebugSimulator, BooleanOption::kDebugSimulator, true},
    {Word::kDebugScheduler, BooleanOption::kDebugScheduler, true},
    {Word::kScaleRobots, BooleanOption::kScaleRobots, false},
    {Word::kSeed, NumberOption::kSeed, false},
    {Word::kRobotLength, NumberOption::kRobotLength, false},
    {Word::kObstacleCoverage, NumberOption::kObstacleCoverage, false},
    {Word::kMinObstacleRadius, NumberOption::kMinObstacleRadius, false},
    {Word::kMaxObstacleRadius, NumberOption::kMaxObstacleRadius, false},
    {Word::kZoomFactor, NumberOption::kZoomFactor, false},
    {Word::kCycleDuration, NumberOption::kCycleDuration, true},
    {Word::kFailingRobots, NumberOption::kFailingRobots, false},
    {Word::kFailuresWithin, NumberOption::kFailuresWithin, false},
});

const std::vector<std::string>& statement_words(Section section) {
  static const std::vector<std::string> kPreamble = {
      "MISSION NAME",     "SCENARIO",  "OVERLAY", "MISSION-AREA", "LOAD-MAP", "SP",       "OBSTACLE",
      "CREATE-OBSTACLES", "NEW-ROBOT", "UNIT",    "SET",          "PRINT",    "FAILSAFE", "COMMAND LIST:"};
  static const std::vector<std::string> kStep = {"UNIT", "ROBOT", "ROBOTS", "SET", "PRINT", "QUIT"};
  static const std::vector<std::string> kTyped = {
      "UNIT", "ROBOT", "ROBOTS", "SET", "PRINT", "QUIT", "OBSTACLE", "CREATE-OBSTACLES", "INJECTTRACK"};
  return section == Section::kPreamble ? kPreamble : section == Section::kStep ? kStep : kTyped;
}

bool is_allowed(Word word, Section section) {
  switch (word) {
    case Word::kUnit:
    case Word::kSet:
    case Word::kPrint:
      return true;
    case Word::kQuit:
    case Word::kRobot:
      return section != Section::kPreamble;
    case Word::kInjectTrack:
      return section == Section::kTyped;
    case Word::kObstacle:
    case Word::kCreateObstacles:
      return section != Section::kStep;
    case Word::kScenario:
    case Word::kOverlay:
    case Word::kMissionArea:
    case Word::kLoadMap:
    case Word::kSp:
    case Word::kNewRobot:
    case Word::kFailsafe:
      return section == Section::kPreamble;
    default:
      return false;
  }
}

bool is_action(Word word) {
  return task_of(word).has_value();
}

// What an author of an overlay may take for a statement of a mission.
bool is_overlay_word(std::string_view text) {
  const odl::Keyword keyword = odl::find_keyword(text);
  const bool begins_statement = odl::is_information(keyword) || odl::is_feature(keyword);
  const Keyword* own = find_keyword(text);
  const bool is_own = own != nullptr && own->word != Word::kHeightMap;
  return (begins_statement && !is_own) || equal_without_case(text, "CONTROL");
}

bool has_program(const Statement& statement) {
  const auto* robot = std::get_if<statement::NewRobot>(&statement.what);
  return robot != nullptr && robot->program.span.end > robot->program.span.begin;
}

}  // namespace

std::optional<Statement> Parser::parsed_statement(Section section, Damage& damage) {
  Statement out;
  out.span = token().span;
  if (at(TokenKind::kMissionName) && section == Section::kPreamble) {
    advance();
    out.what = statement::MissionName{name("the mission's name")};
  } else if (is_robots(token()) && section != Section::kPreamble) {
    advance();
    out.what = robots_action(true);
  } else if (at(TokenKind::kWord) && is_allowed(token().word, section)) {
    statement_by_word(section, out, damage);
  } else {
    refuse_statement(section, damage);
  }
  // A robot type counts as known as soon as its program is.
  return !stuck_ || has_program(out) ? std::optional(std::move(out)) : std::nullopt;
}

// NOLINTNEXTLINE(readability-function-size): a row for each word
void Parser::statement_by_word(Section section, Statement& out, Damage& damage) {
  const Word word = token().word;
  advance();
  switch (word) {
    case Word::kScenario:
      out.what = statement::Scenario{name("the scenario's name")};
      break;
    case Word::kOverlay:
      out.what = overlay_file();
      damage.places |= stuck_;
      break;
    case Word::kMissionArea: {
      const Number width = number("the width of the mission area");
      out.what = statement::MissionArea{width, number("the height of the mission area")};
      break;
    }
    case Word::kLoadMap:
      out.what = statement::LoadMap{name("the name of a map file")};
      break;
    case Word::kSp: {
      Name start = name("the start point's name");
      const Number x = number("the x coordinate");
      out.what = statement::StartPlace{std::move(start), x, number("the y coordinate")};
      damage.places |= stuck_;
      break;
    }
    case Word::kObstacle: {
      const Number x = number("the x coordinate");
      const Number y = number("the y coordinate");
      out.what = statement::Obstacle{x, y, number("the obstacle's radius")};
      break;
    }
    case Word::kCreateObstacles:
      out.what = statement::CreateObstacles{};
      break;
    case Word::kNewRobot:
      out.what = new_robot();
      damage.types |= stuck_ && !has_program(out);
      break;
    case Word::kUnit:
      if (section == Section::kStep || (section == Section::kTyped && !at(TokenKind::kLess))) {
        out.what = unit_action();
      } else {
        out.what = unit_definition();
        damage.units |= stuck_;
      }
      break;
    case Word::kRobot:
      out.what = robots_action(false);
      break;
    case Word::kSet:
      out.what = set(section);
      break;
    case Word::kPrint:
      out.what = print();
      break;
    case Word::kFailsafe:
      out.what = failsafe();
      break;
    case Word::kInjectTrack:
      out.what = inject_track();
      break;
    default:
      out.what = statement::Quit{};
      break;
  }
}

// A word that begins something in a step or in an overlay.
bool Parser::is_known_elsewhere(const Token& t) const {
  if (t.kind == TokenKind::kWord)
    return is_action(t.word) || t.word == Word::kQuit || t.word == Word::kHeightMap;
  return t.kind == TokenKind::kName && is_overlay_word(written(t));
}

std::string Parser::near_statement(std::string_view word) {
  return text::nearest_name(word.substr(0, 40), statement_words(Section::kPreamble));
}

// Something stands where a statement should begin.
void Parser::refuse_statement(Section section, Damage& damage) {
  const Token t = token();
  const std::string said = in_backticks(written(t));
  const bool is_preamble_word = starts_statement(t);
  if (section == Section::kPreamble) damage = {true, true, true};
  if (section == Section::kTyped && t.kind == TokenKind::kLabel) {
    fail("not-typed", t.span, fmt::format("a typed command has no step label, found {}", said));
  } else if (section == Section::kTyped && is_preamble_word) {
    fail("not-typed", t.span, fmt::format("{} cannot be typed, it belongs into the mission file", said));
  } else if (section == Section::kStep && is_preamble_word) {
    fail("not-in-steps", t.span, fmt::format("{} belongs before `COMMAND LIST:`", said));
  } else if (section == Section::kPreamble &&
             ((t.kind == TokenKind::kWord && (is_action(t.word) || t.word == Word::kQuit)) ||
              (starts_command(t) && token(1).kind == TokenKind::kNumber))) {
    fail("not-in-preamble", t.span, fmt::format("{} belongs into a step behind `COMMAND LIST:`", said));
  } else if (is_overlay_word(written(t))) {
    fail("not-in-missions", t.span, fmt::format("{} belongs into an overlay, not into a mission", said));
  } else {
    auto& error = fail("unknown-statement", t.span,
                       fmt::format("expected {}, found {}",
                                   section == Section::kPreamble ? "a statement" : "a command", describe(t)));
    const std::string near = text::nearest_name(written(t).substr(0, 40), statement_words(section));
    if (!near.empty()) {
      error.hints.push_back(fmt::format("did you mean `{}`?", near));
    } else if (section == Section::kPreamble && !t.first_on_line && next_ > 0 &&
               tokens_.tokens[next_ - 1].kind == TokenKind::kName) {
      error.hints.emplace_back("a name of several words stands in quotes");
    } else {
      error.hints.push_back("known are " + listed(statement_words(section), " and "));
    }
  }
}

statement::OverlayFile Parser::overlay_file() {
  if (!stuck_ && at(TokenKind::kFile)) return {take_name()};
  return {name("the name of an overlay file")};
}

statement::NewRobot Parser::new_robot() {
  statement::NewRobot out;
  out.name = name("the new type's name");
  const bool is_standard = !stuck_ && at(Word::kRobot) && at(TokenKind::kWord);
  out.program = name("the robot program's name");
  if (is_standard) out.program.text = "robot";
  out.color = color_or_host();
  if (out.color) out.host = color_or_host();
  if (out.host && (at(TokenKind::kName) || at(TokenKind::kString)) && !token().first_on_line) {
    fail("too-many-words", token().span,
         fmt::format("nothing but parameters may follow the host, found {}", describe(token())))
        .hints.emplace_back("NEW-ROBOT takes type, program, colour, host and then parameters in parentheses");
  }
  if (!stuck_ && at(TokenKind::kFile) && !token().first_on_line) {
    name(out.color ? "a host" : "a colour");
  }
  if (!stuck_ && at(TokenKind::kOpen)) parameter_list(out);
  return out;
}

// The position is optional, so of the reserved words only the two that were colours before they were reserved
// count.
std::optional<Name> Parser::color_or_host() {
  if (stuck_ || looks_like_header()) return std::nullopt;
  const bool is_color_word = at(Word::kRed) || at(Word::kYellow);
  if (!is_color_word && !at(TokenKind::kName) && !at(TokenKind::kString)) return std::nullopt;
  return take_name();
}

void Parser::parameter_list(statement::NewRobot& robot) {
  const text::Span open = token().span;
  advance();
  if (at(TokenKind::kClose)) {
    fail("empty-parameter-list", {open.begin, token().span.end},
         "a parameter list names at least one parameter")
        .hints.emplace_back("leave out the parentheses");
    return;
  }
  do {
    Comments comments;
    collect_comments(robot.parameters.empty() ? nullptr : &robot.parameters.back().comments, comments);
    if (at(TokenKind::kClose)) {
      fail("trailing-comma", tokens_.tokens[next_ - 1].span, "a comma stands behind the last parameter");
      return;
    }
    while (robot.parameters.empty() && !comments.above.empty() && comments.above.front().empty()) {
      comments.above.erase(comments.above.begin());
    }
    Parameter read = parameter();
    if (stuck_) return;
    read.comments = std::move(comments);
    robot.parameters.push_back(std::move(read));
  } while (take(TokenKind::kComma));
  Comments below;
  collect_comments(&robot.parameters.back().comments, below);
  std::erase(below.above, "");
  robot.comments_below = std::move(below.above);
  if (take(TokenKind::kClose)) return;
  const bool is_value = at(TokenKind::kName) || at(TokenKind::kString) || at(TokenKind::kNumber);
  fail("unclosed-parameter-list", token().span,
       fmt::format("expected {} before {}", is_value ? "`,`" : "`,` or `)`", describe(token())))
      .notes.push_back({"the parameter list begins here", place(open)});
}

Parameter Parser::parameter() {
  Parameter out;
  const bool is_timeout = at(Word::kTimeout);
  out.key = name("a parameter's name");
  if (is_timeout && !out.key.quoted) out.key.text = "timeout";
  if (!stuck_ && !take(TokenKind::kEquals)) {
    fail("unexpected-token", token().span,
         fmt::format("expected `=` behind {}, found {}", in_backticks(out.key.text), describe(token())));
  }
  if (stuck_) return out;
  const Token t = token();
  out.value_span = t.span;
  out.written = written(t);
  if (t.kind == TokenKind::kBoolean) {
    out.value = t.value == 1 ? "1" : "0";
    advance();
  } else if (t.kind == TokenKind::kNumber || t.kind == TokenKind::kLabel || t.kind == TokenKind::kTime) {
    out.value = number("the parameter's value").text;
    const Token second = token();
    if (!stuck_ && second.kind == TokenKind::kNumber) {  // the coordinates of a place
      out.value_span.end = second.span.end;
      out.written += ' ';
      out.written += written(second);
      out.value += ' ';
      out.value += number("the parameter's second coordinate").text;
    }
  } else {
    out.value = name("the parameter's value").text;
  }
  return out;
}

statement::UnitDefinition Parser::unit_definition() {
  statement::UnitDefinition out;
  if (!at(TokenKind::kLess)) {
    auto& error = fail("unit-without-brackets", token().span,
                       fmt::format("expected `<` before the unit's name, found {}", describe(token())));
    if (at(TokenKind::kName))
      error.hints.push_back(fmt::format("write `UNIT <{}> ROBOT`", written(token()).substr(0, 40)));
    return out;
  }
  Group& root = out.groups.emplace_back();
  root.span = token().span;
  root.name = group_name();
  group_content(out, 0, 1);
  return out;
}

Name Parser::group_name() {
  take(TokenKind::kLess);
  Name out = name("the unit's name");
  if (!stuck_ && !take(TokenKind::kGreater)) fail_expected("`>` behind the unit's name");
  return out;
}

bool Parser::at_robot() const {
  if (stuck_ || looks_like_header()) return false;
  return at(Word::kRobot) || at(TokenKind::kName) || at(TokenKind::kString);
}

// Robots, or groups in parentheses; never both.
void Parser::group_content(statement::UnitDefinition& unit, std::uint32_t group, std::uint32_t depth) {
  if (stuck_) return;
  if (at(TokenKind::kOpen)) {
    while (!stuck_ && at(TokenKind::kOpen)) {
      const std::uint32_t part = parenthesized_group(unit, depth + 1);
      if (!stuck_) unit.groups[group].parts.push_back(part);
    }
  } else {
    if (!at_robot())
      fail_expected(unit.groups[group].name ? "a robot or a group in parentheses" : "a robot or `<name>`");
    while (at_robot()) unit.groups[group].robots.push_back(take_name());
  }
  if (stuck_) return;
  const bool has_parts = !unit.groups[group].parts.empty();
  const bool is_mixed =
      has_parts ? at_robot() && (depth > 1 || !token().first_on_line) : at(TokenKind::kOpen);
  if (is_mixed) {
    fail("mixed-group", token().span, "a unit has either robots or groups, not both on one level")
        .hints.emplace_back("put the robots into parentheses of their own");
  }
}

std::uint32_t Parser::parenthesized_group(statement::UnitDefinition& unit, std::uint32_t depth) {
  const auto index = static_cast<std::uint32_t>(unit.groups.size());
  Group& group = unit.groups.emplace_back();
  group.span = token().span;
  if (depth > kMaxGroupDepth) {
    fail("unit-too-deep", token().span, fmt::format("groups are nested more than {} deep", kMaxGroupDepth));
    return index;
  }
  const text::Span open = token().span;
  advance();
  if (at(TokenKind::kLess)) {
    Name read = group_name();
    unit.groups[index].name = std::move(read);
    group_content(unit, index, depth);
  } else {
    group_content(unit, index, depth);
  }
  if (!stuck_ && !take(TokenKind::kClose)) {
    fail("unclosed-group", token().span, fmt::format("expected `)` before {}", describe(token())))
        .notes.push_back({"the group begins here", place(open)});
  }
  return index;
}

// One whose words are told by where they stand.
statement::Set Parser::set_maneuver(const mission::ManeuverInfo& maneuver, Section section) {
  statement::Set out;
  out.option = maneuver.option;
  out.option_span = token().span;
  if (section != Section::kPreamble) {
    fail("not-in-steps", token().span,
         fmt::format("{} is set before `COMMAND LIST:`{}", in_backticks(maneuver.word),
                     section == Section::kStep ? ", not in a step" : ""));
    return out;
  }
  advance();
  if (maneuver.on.empty()) {
    out.number = number(fmt::format("a number for {}", maneuver.word));
    return out;
  }
  for (const bool value : {true, false}) {
    const std::string_view word = value ? maneuver.on : maneuver.off;
    if (!at(TokenKind::kName) || !equal_without_case(written(token()), word)) continue;
    out.flag = value;
    advance();
    return out;
  }
  fail_expected(fmt::format("`{}` or `{}`", maneuver.on, maneuver.off));
  return out;
}

statement::Set Parser::set(Section section) {
  statement::Set out;
  if (stuck_) return out;
  const Token t = token();
  const auto* maneuver = std::ranges::find_if(mission::kManeuvers, [&](const mission::ManeuverInfo& one) {
    return t.kind == TokenKind::kName && equal_without_case(written(t), one.word);
  });
  if (maneuver != mission::kManeuvers.end()) return set_maneuver(*maneuver, section);
  const auto* found = std::ranges::find(kOptions, t.word, &OptionWord::word);
  if (t.kind != TokenKind::kWord || found == kOptions.end()) {
    std::vector<std::string> known;
    for (const OptionWord& option : kOptions) known.emplace_back(spelling(option.word));
    for (const mission::ManeuverInfo& one : mission::kManeuvers) known.emplace_back(one.word);
    fail_unknown("unknown-option", "an option", known);
    return out;
  }
  out.option = found->option;
  out.option_span = t.span;
  if (section == Section::kStep && !found->in_steps) {
    fail("not-in-steps", t.span,
         fmt::format("{} is set before `COMMAND LIST:`, not in a step", in_backticks(spelling(t.word))));
    return out;
  }
  advance();
  if (std::holds_alternative<NumberOption>(out.option)) {
    out.number = number(fmt::format("a number for {}", spelling(t.word)));
  } else if (at(TokenKind::kBoolean)) {
    out.flag = token().value == 1;
    advance();
  }
  return out;
}

statement::Print Parser::print() {
  if (take(Word::kConsoleDatabase)) return {false};
  if (take(Word::kRobotInfo)) return {true};
  fail_expected("`CONSOLE-DATABASE` or `ROBOT-INFO`");
  return {};
}

statement::InjectTrack Parser::inject_track() {
  if (take(Word::kRed)) return {true};
  if (take(Word::kYellow)) return {false};
  fail_expected("`RED` or `YELLOW`");
  return {};
}

std::optional<mission::NumberOption> number_option(std::string_view word) {
  const auto upper = [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; };
  for (const OptionWord& option : kOptions) {
    const auto* number = std::get_if<NumberOption>(&option.option);
    if (number != nullptr && std::ranges::equal(spelling(option.word), word, {}, {}, upper)) return *number;
  }
  for (const mission::ManeuverInfo& one : mission::kManeuvers) {
    const auto* number = std::get_if<NumberOption>(&one.option);
    if (number != nullptr && std::ranges::equal(one.word, word, {}, {}, upper)) return *number;
  }
  return std::nullopt;
}

}  // namespace mlab::mdl
