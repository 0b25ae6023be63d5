// Robots, their classes, and societies of them.

#include <cmath>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/syntax/cursor.h"
#include "mlab/text/shown.h"

namespace mlab::cdl {
namespace {

// `sensor sonars: SonarObstacles(...) binds sense_obstacles;`
bool parse_device(Cursor& cursor, std::vector<Device>& into) {
  Device device;
  const std::uint32_t begin = cursor.begin();
  device.help = cursor.help_above();
  device.is_actuator = cursor.is("actuator");
  cursor.advance_word();
  if (!cursor.read_name(device.name, "the name of the device")) return false;
  const bool is_read = cursor.expect(":", "and what serves the device") &&
                       parse_call(cursor, "what serves the device", device.by) &&
                       cursor.expect("binds", "and the binding point that the device serves") &&
                       cursor.read_name(device.binds, "the binding point that the device serves");
  const bool is_whole = is_read && cursor.expect_semicolon("behind the device");
  device.whole = cursor.span_since(begin);
  if (cursor.keeps(is_read)) into.push_back(std::move(device));
  return is_whole;
}

bool parse_body_setting(Cursor& cursor, std::vector<BodySetting>& into) {
  BodySetting setting;
  const bool is_read = cursor.read_name(setting.name, "a number of the body") &&
                       cursor.expect("=", "and its value") && parse_expression(cursor, setting.value);
  if (cursor.keeps(is_read)) into.push_back(std::move(setting));
  return is_read && cursor.expect_semicolon("behind the value");
}

bool parse_robot_body(Cursor& cursor, RobotClass& into) {
  cursor.advance_word();
  if (!cursor.open("`body`")) return false;
  while (!cursor.at_close() && !(cursor.is_any({"sensor", "actuator"}) && cursor.is_before_name())) {
    if (!parse_body_setting(cursor, into.body)) cursor.skip_statement();
  }
  cursor.close();
  return true;
}

// `use sonars for sense_obstacles;`
bool parse_choice(Cursor& cursor, std::vector<Choice>& into) {
  Choice choice;
  cursor.advance_word();
  const bool is_read = cursor.read_name(choice.device, "the name of a device") &&
                       cursor.expect("for", "and the binding point that the device serves") &&
                       cursor.read_name(choice.binding, "the binding point that the device serves");
  if (cursor.keeps(is_read)) into.push_back(std::move(choice));
  return is_read && cursor.expect_semicolon("behind the choice");
}

// `movement = Forage();`
bool parse_drive(Cursor& cursor, std::vector<Drive>& into) {
  Drive drive;
  const bool is_read = cursor.read_name(drive.binding, "an actuator, `=` and what drives it") &&
                       cursor.expect("=", "and what drives the actuator") &&
                       parse_expression(cursor, drive.value);
  if (cursor.keeps(is_read)) into.push_back(std::move(drive));
  return is_read && cursor.expect_semicolon("behind what drives the actuator");
}

bool parse_society_member(Cursor& cursor, SocietyMember& into);

bool parse_caste(Cursor& cursor, SocietyMember& into) {
  into.kind = SocietyMember::Kind::kCaste;
  cursor.advance_word();
  if (!cursor.open("`caste`")) return false;
  while (!cursor.at_close()) {
    SocietyMember member;
    const bool is_read = parse_society_member(cursor, member);
    const bool is_whole = is_read && cursor.expect_semicolon("behind the member of the caste");
    if (cursor.keeps(is_read)) into.members.push_back(std::move(member));
    if (!is_whole) cursor.skip_statement();
  }
  cursor.close();
  return true;
}

// `team of 3 Forager`
bool parse_team(Cursor& cursor, SocietyMember& into) {
  into.kind = SocietyMember::Kind::kTeam;
  cursor.advance_word();
  if (!cursor.expect("of", "and how many of which robot")) return false;
  const text::Place at = cursor.here();
  const std::optional<double> count = cursor.read_number();
  if (!count) return false;
  if (*count < 1 || *count > kMostRobotsOfASociety || *count != std::floor(*count)) {
    cursor.error("bad-count", at,
                 fmt::format("a team has a whole number of robots, 1 .. {}", kMostRobotsOfASociety));
  } else {
    into.count = static_cast<int>(*count);
  }
  return cursor.read_name(into.name, "the robot that the team consists of");
}

bool parse_society_member(Cursor& cursor, SocietyMember& into) {
  if (!cursor.enter()) return false;
  const std::uint32_t begin = cursor.begin();
  bool is_read = cursor.could_be({"team"}) && !cursor.is_before(";") ? parse_team(cursor, into)
                 : cursor.could_be({"caste"}) && !cursor.is_before(";")
                     ? parse_caste(cursor, into)
                     : cursor.read_name(into.name, "`team of`, `caste` or the name of a robot");
  cursor.leave();
  if (is_read && cursor.take("by"))
    is_read = cursor.read_name(into.by, "the operator that coordinates the society");
  into.place = cursor.since(begin);
  return is_read;
}

// `sensor`, `actuator` or `body` of a class.
bool parse_class_part(Cursor& cursor, RobotClass& into) {
  if (cursor.could_be({"body"})) return parse_robot_body(cursor, into);
  if (cursor.could_be({"sensor", "actuator"})) return parse_device(cursor, into.devices);
  cursor.expected("`sensor`, `actuator` or `body`");
  return false;
}

bool parse_class_body(Cursor& cursor, RobotClass& into) {
  if (!cursor.open("the class")) return false;
  while (!cursor.at_close()) {
    if (!parse_class_part(cursor, into)) cursor.skip_statement();
  }
  cursor.close();
  return true;
}

bool parse_robot_head(Cursor& cursor, Robot& into) {
  if (!cursor.read_name(into.name, "the name of the robot")) return false;
  into.has_parentheses = cursor.is("(");
  if (into.has_parentheses && !parse_parameters(cursor, into.parameters) && !cursor.skip_to({"is", "{"}))
    return false;
  if (cursor.is("{")) return true;
  if (!cursor.expect("is", "and the class of the robot")) return false;
  cursor.read_name(into.class_name, "the class of the robot");
  return true;
}

bool parse_robot_part(Cursor& cursor, Robot& into) {
  if (cursor.could_be({"let"}) && !cursor.is_before("=")) return parse_let(cursor, into.lets);
  if (cursor.could_be({"use"}) && !cursor.is_before("=")) return parse_choice(cursor, into.choices);
  return parse_drive(cursor, into.drives);
}

// `choose_target = ClaimClosest(...);`
bool parse_service(Cursor& cursor, std::vector<Device>& into) {
  Device device;
  const std::uint32_t begin = cursor.begin();
  device.help = cursor.help_above();
  const bool is_read = cursor.read_name(device.binds, "a binding point, `=` and what serves it") &&
                       cursor.expect("=", "and what serves the binding point") &&
                       parse_call(cursor, "what serves the binding point", device.by);
  const bool is_whole = is_read && cursor.expect_semicolon("behind what serves the binding point");
  device.name = device.binds;
  device.whole = cursor.span_since(begin);
  if (cursor.keeps(is_read)) into.push_back(std::move(device));
  return is_whole;
}

}  // namespace

bool parse_class(Cursor& cursor, Tree& tree, const std::string& help) {
  RobotClass out;
  const std::uint32_t begin = cursor.begin();
  out.help = help;
  cursor.advance_word();
  const bool has_name = cursor.read_name(out.name, "the name of the class of robots");
  out.has_parentheses = cursor.is("(");
  const bool is_whole =
      has_name &&
      (!out.has_parentheses || parse_parameters(cursor, out.parameters) || cursor.skip_to({"{"})) &&
      parse_class_body(cursor, out);
  return put(cursor, begin, std::move(out), is_whole, tree);
}

bool parse_robot(Cursor& cursor, Tree& tree, const std::string& help) {
  Robot out;
  const std::uint32_t begin = cursor.begin();
  out.help = help;
  cursor.advance_word();
  const bool is_whole = parse_robot_head(cursor, out) && cursor.open("the robot");
  if (is_whole) {
    while (!cursor.at_close()) {
      if (!parse_robot_part(cursor, out)) cursor.skip_statement();
    }
    cursor.close();
  }
  return put(cursor, begin, std::move(out), is_whole, tree);
}

bool parse_society(Cursor& cursor, Tree& tree, const std::string& help) {
  Society out;
  const std::uint32_t begin = cursor.begin();
  out.help = help;
  cursor.advance_word();
  const bool is_read = cursor.read_name(out.name, "the name of the society") &&
                       cursor.expect(":", "and who belongs to the society") &&
                       parse_society_member(cursor, out.what);
  const bool is_whole = is_read && cursor.expect_semicolon("behind the society");
  put(cursor, begin, std::move(out), is_read, tree);
  return is_whole;
}

// `operator DistinctTargets { choose_target = ClaimClosest(...); }`
bool parse_society_operator(Cursor& cursor, Tree& tree, const std::string& help) {
  SocietyOperator out;
  const std::uint32_t begin = cursor.begin();
  out.help = help;
  cursor.advance_word();
  const bool is_whole = cursor.read_name(out.name, "the name of the operator") && cursor.open("the operator");
  if (is_whole) {
    while (!cursor.at_close()) {
      if (!parse_service(cursor, out.devices)) cursor.skip_statement();
    }
    cursor.close();
  }
  return put(cursor, begin, std::move(out), is_whole, tree);
}

}  // namespace mlab::cdl
