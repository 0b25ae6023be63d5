// Robots, their classes, and societies of them.

#include <cmath>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/cursor.h"
#include "mlab/text/shown.h"

namespace mlab::cdl {
namespace {

// `sensor sonars: SonarObstacles(...) binds sense_obstacles;`
bool parse_device(Cursor& cursor, std::vector<Device>& into) {
  Device device;
  device.help = cursor.help_above();
  device.is_actuator = cursor.is("actuator");
  cursor.advance();
  if (!cursor.read_name(device.name, "the name of the device")) return false;
  if (!cursor.expect(":", "and what serves the device")) return false;
  std::optional<Call> by = parse_call(cursor, "what serves the device");
  if (!by || !cursor.expect("binds", "and the binding point that the device serves")) return false;
  device.by = std::move(*by);
  if (!cursor.read_name(device.binds, "the binding point that the device serves")) return false;
  const bool is_whole = cursor.expect_semicolon("behind the device");
  into.push_back(std::move(device));
  return is_whole;
}

bool parse_body_setting(Cursor& cursor, std::vector<BodySetting>& into) {
  BodySetting setting;
  if (!cursor.read_name(setting.name, "a number of the body")) return false;
  if (!cursor.expect("=", "and its value")) return false;
  setting.value = parse_expression(cursor);
  if (!setting.value) return false;
  into.push_back(std::move(setting));
  return cursor.expect_semicolon("behind the value");
}

bool parse_robot_body(Cursor& cursor, RobotClass& into) {
  cursor.advance();
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
  cursor.advance();
  if (!cursor.read_name(choice.device, "the name of a device")) return false;
  if (!cursor.expect("for", "and the binding point that the device serves")) return false;
  if (!cursor.read_name(choice.binding, "the binding point that the device serves")) return false;
  into.push_back(std::move(choice));
  return cursor.expect_semicolon("behind the choice");
}

// `movement = Forage();`
bool parse_drive(Cursor& cursor, std::vector<Drive>& into) {
  Drive drive;
  if (!cursor.read_name(drive.binding, "an actuator, `=` and what drives it")) return false;
  if (!cursor.expect("=", "and what drives the actuator")) return false;
  drive.value = parse_expression(cursor);
  if (!drive.value) return false;
  into.push_back(std::move(drive));
  return cursor.expect_semicolon("behind what drives the actuator");
}

std::optional<SocietyMember> parse_society_member(Cursor& cursor);

bool parse_caste(Cursor& cursor, SocietyMember& into) {
  into.kind = SocietyMember::Kind::kCaste;
  cursor.advance();
  if (!cursor.open("`caste`")) return false;
  while (!cursor.at_close()) {
    std::optional<SocietyMember> member = parse_society_member(cursor);
    const bool is_whole = member && cursor.expect_semicolon("behind the member of the caste");
    if (member) into.members.push_back(std::move(*member));
    if (!is_whole) cursor.skip_statement();
  }
  cursor.close();
  return true;
}

// `team of 3 Forager`
bool parse_team(Cursor& cursor, SocietyMember& into) {
  constexpr double kMostRobots = 10000;
  into.kind = SocietyMember::Kind::kTeam;
  cursor.advance();
  if (!cursor.expect("of", "and how many of which robot")) return false;
  const text::Place at = cursor.here();
  const std::optional<double> count = cursor.read_number();
  if (!count) return false;
  if (*count < 1 || *count > kMostRobots || *count != std::floor(*count)) {
    cursor.error("bad-count", at, fmt::format("a team has a whole number of robots, 1 .. {}", kMostRobots));
  } else {
    into.count = static_cast<int>(*count);
  }
  return cursor.read_name(into.name, "the robot that the team consists of");
}

std::optional<SocietyMember> parse_society_member(Cursor& cursor) {
  if (!cursor.enter()) return std::nullopt;
  SocietyMember out;
  const std::uint32_t begin = cursor.begin();
  const bool is_read = cursor.is("team") && !cursor.is_before(";") ? parse_team(cursor, out)
                       : cursor.is("caste") && !cursor.is_before(";")
                           ? parse_caste(cursor, out)
                           : cursor.read_name(out.name, "`team of`, `caste` or the name of a robot");
  cursor.leave();
  if (!is_read) return std::nullopt;
  if (cursor.take("by") && !cursor.read_name(out.by, "the operator that coordinates the society"))
    return std::nullopt;
  out.place = cursor.since(begin);
  return out;
}

}  // namespace

bool parse_class(Cursor& cursor, Tree& tree, const std::string& help) {
  RobotClass out;
  out.help = help;
  cursor.advance();
  if (!cursor.read_name(out.name, "the name of the class of robots")) return false;
  if (cursor.is("(") && !parse_parameters(cursor, out.parameters)) return false;
  if (!cursor.open("the class")) return false;
  while (!cursor.at_close()) {
    bool is_read = false;
    if (cursor.is("body")) {
      is_read = parse_robot_body(cursor, out);
    } else if (cursor.is_any({"sensor", "actuator"})) {
      is_read = parse_device(cursor, out.devices);
    } else {
      cursor.expected("`sensor`, `actuator` or `body`");
    }
    if (!is_read) cursor.skip_statement();
  }
  cursor.close();
  tree.items.emplace_back(std::move(out));
  return true;
}

bool parse_robot(Cursor& cursor, Tree& tree, const std::string& help) {
  Robot out;
  out.help = help;
  cursor.advance();
  if (!cursor.read_name(out.name, "the name of the robot")) return false;
  if (cursor.is("(") && !parse_parameters(cursor, out.parameters)) return false;
  if (!cursor.is("{")) {
    if (!cursor.expect("is", "and the class of the robot")) return false;
    cursor.read_name(out.class_name, "the class of the robot");
  }
  if (!cursor.open("the robot")) return false;
  while (!cursor.at_close()) {
    const bool is_let = cursor.is("let") && !cursor.is_before("=");
    const bool is_use = cursor.is("use") && !cursor.is_before("=");
    const bool is_read = is_let   ? parse_let(cursor, out.lets)
                         : is_use ? parse_choice(cursor, out.choices)
                                  : parse_drive(cursor, out.drives);
    if (!is_read) cursor.skip_statement();
  }
  cursor.close();
  tree.items.emplace_back(std::move(out));
  return true;
}

bool parse_society(Cursor& cursor, Tree& tree, const std::string& help) {
  Society out;
  out.help = help;
  cursor.advance();
  if (!cursor.read_name(out.name, "the name of the society")) return false;
  if (!cursor.expect(":", "and who belongs to the society")) return false;
  std::optional<SocietyMember> what = parse_society_member(cursor);
  if (!what) return false;
  out.what = std::move(*what);
  const bool is_whole = cursor.expect_semicolon("behind the society");
  tree.items.emplace_back(std::move(out));
  return is_whole;
}

// `operator DistinctTargets { choose_target = ClaimClosest(...); }`
bool parse_society_operator(Cursor& cursor, Tree& tree, const std::string& help) {
  SocietyOperator out;
  out.help = help;
  cursor.advance();
  if (!cursor.read_name(out.name, "the name of the operator")) return false;
  if (!cursor.open("the operator")) return false;
  while (!cursor.at_close()) {
    Device device;
    device.help = cursor.help_above();
    bool is_read = cursor.read_name(device.binds, "a binding point, `=` and what serves it") &&
                   cursor.expect("=", "and what serves the binding point");
    std::optional<Call> by = is_read ? parse_call(cursor, "what serves the binding point") : std::nullopt;
    is_read = by && cursor.expect_semicolon("behind what serves the binding point");
    if (by) {
      device.by = std::move(*by);
      device.name = device.binds;
      out.devices.push_back(std::move(device));
    }
    if (!is_read) cursor.skip_statement();
  }
  cursor.close();
  tree.items.emplace_back(std::move(out));
  return true;
}

}  // namespace mlab::cdl
