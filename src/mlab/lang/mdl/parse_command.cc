#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/lang/mdl/parser.h"
#include "mlab/lang/mdl/quoted.h"
#include "mlab/mission/tasks.h"
#include "mlab/percept/formation_names.h"

namespace mlab::mdl {
namespace {

using mission::Task;

using mission::ClauseKind;
static_assert(mission::kClauses.size() == std::variant_size_v<decltype(Clause::what)>);

std::string_view command_word(Task task) {
  return mission::info(task).word;
}

}  // namespace

statement::UnitAction Parser::unit_action() {
  statement::UnitAction out;
  if (at(TokenKind::kLess)) {
    fail("unit-in-brackets", token().span, "a command names its unit without `<` and `>`")
        .hints.emplace_back("units are defined before `COMMAND LIST:`");
    return out;
  }
  out.unit = name("the unit's name");
  if (!stuck_) action(out, "unit " + in_backticks(out.unit.text));
  return out;
}

// Behind the word ROBOT or ROBOTS.
statement::UnitAction Parser::robots_action(bool says_robots) {
  statement::UnitAction out;
  out.says_robots = says_robots;
  robot_numbers(out);
  if (stuck_) return out;
  const bool is_one = out.robots.size() == 1;
  action(out, is_one ? "robot " + out.robots.front().text : fmt::format("the {} robots", out.robots.size()));
  return out;
}

void Parser::robot_numbers(statement::UnitAction& action) {
  action.robots.push_back(number("a robot's number"));
  while (!stuck_ && action.says_robots && at(TokenKind::kNumber)) action.robots.push_back(number("a number"));
  if (stuck_) return;
  if (at(TokenKind::kNumber)) {
    fail("several-robots", token().span,
         fmt::format("ROBOT takes one number, here is {} too", in_backticks(written(token()))))
        .hints.push_back(fmt::format("write `ROBOTS {} {}`", action.robots.front().text, written(token())));
  } else if (at(TokenKind::kComma)) {
    fail("comma-between-robots", token().span, "the numbers of robots stand side by side, without commas")
        .hints.emplace_back("write `ROBOTS 2 5 7`");
  }
}

// What they shall do. `whom`: in words
void Parser::action(statement::UnitAction& out, const std::string& whom) {
  const std::optional<Task> task = at(TokenKind::kWord) ? task_of(token().word) : std::nullopt;
  if (!task) {
    std::vector<std::string> known;
    for (const mission::TaskInfo& each : mission::kTasks) known.emplace_back(each.word);
    fail_unknown("unknown-command", fmt::format("what {} shall do", whom), known);
    return;
  }
  out.task = *task;
  advance();
  if (!mission::info(out.task).place.empty()) out.location = location(command_word(out.task));
  if (mission::info(out.task).place == "places") more_places(out);
  if (out.task == Task::kStart) start_step(out);
  clauses(out);
}

Location Parser::location(std::string_view command) {
  Location out;
  if (stuck_) return out;
  if (at(TokenKind::kNumber)) {
    out.x = number("the x coordinate");
    if (at(TokenKind::kLabel) && !at_misread_number()) {
      fail("one-coordinate", out.x.span,
           fmt::format("a place has two coordinates, here is only {}", in_backticks(out.x.text)))
          .hints.emplace_back("a place whose name looks like a number stands in quotes");
    }
    out.y = number("the y coordinate");
    out.span = {out.x.span.begin, out.y.span.end};
    return out;
  }
  out.name = name(fmt::format("the place of {}", command));
  out.span = out.name->span;
  return out;
}

// Those behind the first one. Of the words of the language those for commands may name them, as no command
// begins there.
void Parser::more_places(statement::UnitAction& action) {
  const auto at_place = [&] {
    if (at(TokenKind::kWord) && task_of(token().word)) return true;
    if (token().first_on_line && is_robots(token())) return false;
    const bool is_clause = at(TokenKind::kName) && (equal_without_case(written(token()), "SWATH") ||
                                                    equal_without_case(written(token()), "HEADING"));
    if (is_clause && (token(1).kind == TokenKind::kNumber || token(1).kind == TokenKind::kEquals))
      return false;
    return at(TokenKind::kName) || at(TokenKind::kString) || at(TokenKind::kNumber);
  };
  while (!stuck_ && at_place()) action.more.push_back(location(command_word(action.task)));
}

// START's way from one robot to the next.
void Parser::start_step(statement::UnitAction& action) {
  const bool follows = at(TokenKind::kNumber) || at_misread_number() || at(TokenKind::kTime);
  if (stuck_ || !follows) return;
  const Number x = number("the x offset");
  const bool is_alone = !at(TokenKind::kNumber) && !at(TokenKind::kTime) && !at_misread_number();
  if (!stuck_ && is_alone) {
    fail("one-offset", x.span,
         fmt::format("START takes two offsets or none, here is only {}", in_backticks(x.text)))
        .hints.push_back(fmt::format(
            "write `0 {}` for robots in a row to the north, `{} 0` for one to the east", x.text, x.text));
    return;
  }
  const Number y = number("the y offset");
  action.step = StartStep{x, y};
}

void Parser::clauses(statement::UnitAction& action) {
  while (!stuck_) {
    const text::Span first = token().span;
    std::optional<Clause> clause = parsed_clause(action.task);
    if (!clause) return;
    if (stuck_) return;
    clause->span = {first.begin, tokens_.tokens[next_ - 1].span.end};
    action.clauses.push_back(std::move(*clause));
  }
}

void Parser::refuse_clause(Task task, text::Span span, std::string_view said) {
  std::vector<std::string> allowed;
  for (const mission::ClauseInfo& clause : mission::kClauses) {
    if (mission::takes(task, clause.kind)) allowed.emplace_back(clause.word);
  }
  complain("clause-not-allowed", span,
           fmt::format("{} does not take {}", command_word(task), in_backticks(said)))
      .hints.push_back(allowed.empty() ? "it takes no clauses"
                                       : fmt::format("it takes {}", listed(allowed, " and ")));
}

// Nothing where no clause begins.
std::optional<Clause> Parser::parsed_clause(Task task) {
  const Token t = token();
  Clause out;
  const auto begin = [&](ClauseKind kind) {
    if (!mission::takes(task, kind)) refuse_clause(task, t.span, mission::info(kind).word);
    if (t.kind != TokenKind::kFormation && t.kind != TokenKind::kTechnique) advance();
  };
  if (t.kind == TokenKind::kFormation || at(Word::kFormation)) {
    begin(ClauseKind::kFormation);
    if (t.kind != TokenKind::kFormation) take(TokenKind::kEquals);
    if (!at(TokenKind::kFormation)) {
      std::vector<std::string> known;
      for (const percept::FormationInfo& one : percept::kFormations) known.emplace_back(one.name);
      fail_unknown("unknown-formation", "a formation", known);
    }
    out.what = clause::Formation{static_cast<percept::Formation>(token().value)};
    advance();
  } else if (t.kind == TokenKind::kTechnique || at(Word::kTechnique)) {
    begin(ClauseKind::kTechnique);
    if (t.kind != TokenKind::kTechnique) take(TokenKind::kEquals);
    if (!at(TokenKind::kTechnique)) fail_expected("TRAVELING, TRAVELING-OVERWATCH or BOUNDING-OVERWATCH");
    out.what = clause::Technique{static_cast<mission::Technique>(token().value)};
    advance();
  } else if (at(Word::kSpeed)) {
    begin(ClauseKind::kSpeed);
    take(TokenKind::kEquals);
    out.what = clause::Speed{number("a speed in metres per second")};
  } else if (t.kind == TokenKind::kName && equal_without_case(written(t), "HEADING")) {
    begin(ClauseKind::kHeading);
    take(TokenKind::kEquals);
    out.what = clause::Heading{number("a heading in degrees")};
  } else if (t.kind == TokenKind::kName && equal_without_case(written(t), "SWATH")) {
    begin(ClauseKind::kSwath);
    take(TokenKind::kEquals);
    out.what = clause::Swath{number("a width in metres")};
  } else if (at(Word::kPhaseLine)) {
    begin(ClauseKind::kPhaseLine);
    out.what = phase_line();
  } else if (at(Word::kOnCompletion)) {
    begin(ClauseKind::kOnCompletion);
    if (!take(Word::kMessage)) fail_expected("`MESSAGE` behind ON-COMPLETION");
    out.what = clause::OnCompletion{name("the message")};
  } else if (at(Word::kUntil)) {
    begin(ClauseKind::kUntil);
    out.what = clause::Until{until()};
  } else if (t.kind == TokenKind::kName && equal_without_case(written(t), "FREEZE")) {
    fail("freeze", t.span, "`FREEZE` is no clause of this language")
        .hints.emplace_back("a unit that has arrived holds its place with OCCUPY");
  } else if (at(Word::kWait)) {
    fail("wait-without-acknowledge", t.span,
         "`WAIT` needs an `ACKNOWLEDGE` before it, whose answer it waits for")
        .hints.emplace_back("write `PHASE-LINE name ACKNOWLEDGE \"text\" WAIT`");
  } else {
    return std::nullopt;
  }
  return out;
}

clause::PhaseLine Parser::phase_line() {
  clause::PhaseLine out;
  out.line = name("the phase line's name");
  out.moment = time_and_date();
  if (take(Word::kAcknowledge)) {
    out.acknowledge = name("the text to acknowledge");
    out.waits = take(Word::kWait);
  }
  return out;
}

// A time, a date and a time, a time and a date, or nothing.
std::optional<Moment> Parser::time_and_date() {
  if (stuck_ || (!at(TokenKind::kTime) && !at(TokenKind::kDate))) return std::nullopt;
  Moment out;
  out.span = token().span;
  const auto mark = [&] {
    Mark read{std::string(written(token())), token().span};
    out.span.end = token().span.end;
    advance();
    return read;
  };
  if (at(TokenKind::kTime)) {
    out.time = mark();
    if (at(TokenKind::kDate)) out.date = mark();
    return out;
  }
  out.date = mark();
  if (at(TokenKind::kTime)) {
    out.time = mark();
  } else {
    fail("date-without-time", out.date->span,
         fmt::format("the date {} needs a time of day", in_backticks(out.date->text)))
        .hints.push_back(fmt::format("write `12:00 {}`", out.date->text));
  }
  return out;
}

Moment Parser::until() {
  Moment out;
  if (stuck_) return out;
  if (at(Word::kTimeout)) {
    out.span = token().span;
    advance();
    out.is_timeout = true;
    if (at(TokenKind::kTime)) {
      out.time = Mark{std::string(written(token())), token().span};
      advance();
    } else {
      out.number = number("a number of seconds or a time");
    }
    if (!stuck_) out.span.end = tokens_.tokens[next_ - 1].span.end;
    return out;
  }
  if (std::optional<Moment> moment = time_and_date()) return *moment;
  if (!stuck_ && !at(TokenKind::kNumber)) fail_expected("`TIMEOUT`, a time, or a date and a time");
  out.span = token().span;
  out.number = number("minutes after midnight");
  return out;
}

}  // namespace mlab::mdl
