#include "mlab/lang/cdl_historic/robots.h"

#include <algorithm>
#include <optional>

#include <fmt/core.h>

#include "mlab/lang/cdl_historic/constants.h"
#include "mlab/lang/cdl_historic/library_names.h"
#include "mlab/text/shown.h"

namespace mlab::cdl_historic {
namespace {

constexpr int kMaxGroups = 50;  // in each other, around robots

bool is_output_point(std::string_view binding) {
  return binding == "movement" || binding == "pantilt" || binding == "pantiltzoom" ||
         binding == "motivations";
}

// What a device or a binding point is driven by, past its constants.
const Setting* driven_input(const Expr& expr) {
  const Setting* first = nullptr;
  for (const Setting& setting : expr.settings) {
    if (setting.is_pushed || setting.name.text == "bound_to" || setting.value.kind != Value::Kind::kExpr)
      continue;
    if (setting.name.text == "v" || setting.name.text == "look_loc") return &setting;
    if (first == nullptr && !setting.name.text.empty()) first = &setting;
  }
  return first;
}

bool has_actuator(const cdl::RobotClass& robot_class, const cdl::Drive& drive) {
  return std::ranges::any_of(robot_class.devices, [&](const cdl::Device& device) {
    return device.is_actuator && device.binds.text == drive.binding.text;
  });
}

bool lacks(const cdl::RobotClass& robot_class, const cdl::Robot& robot) {
  return !std::ranges::all_of(robot.drives,
                              [&](const cdl::Drive& drive) { return has_actuator(robot_class, drive); });
}

}  // namespace

const Expr* Robots::resolved(const Expr& expr) const {
  if (expr.kind != Expr::Kind::kReference) return &expr;
  const Symbol* symbol = converter_.symbols().find(expr.name);
  return symbol == nullptr ? nullptr : symbol->expr;
}

// A robot is given its binding points as they are, without the name of a parameter.
bool Robots::is_robot(const Expr& expr) const {
  if (expr.kind != Expr::Kind::kInstance) return false;
  if (!robot_class_named(expr.name.text).empty()) return true;
  for (const Definition& definition : converter_.tree().definitions) {
    if (definition.kind == Definition::Kind::kRobot && definition.name.text == expr.name.text) return true;
  }
  return std::ranges::any_of(expr.settings,
                             [](const Setting& s) { return s.name.text.empty() && s.value.expr != nullptr; });
}

void Robots::add_configuration(const Expr& root) {
  nodes_.clear();
  cdl::SocietyMember what = members(root, root.spot, 0);
  if (robots_.empty()) return;
  const bool is_society = what.kind == cdl::SocietyMember::Kind::kCaste && what.members.size() > 1;
  if (!is_society) return;
  cdl::Society society;
  const bool is_named = !root.inline_names.empty() && root.inline_names[0].text != "NoName" &&
                        root.inline_names[0].text != "UNTITLED";
  society.name.text = converter_.free_name(is_named ? root.inline_names[0].text : file_stem_);
  society.what = std::move(what);
  converter_.drawings().push_back({society.name.text, std::move(nodes_)});
  societies_.push_back(std::move(society));
}

// Groups around robots become castes; a group of one is that one.
cdl::SocietyMember Robots::members(const Expr& expr, const Spot& spot, int depth) {
  cdl::SocietyMember caste;
  caste.kind = cdl::SocietyMember::Kind::kCaste;
  if (depth > kMaxGroups) return caste;
  const Expr* what = resolved(expr);
  if (what == nullptr) {
    others_.push_back(&expr);
    return caste;
  }
  if (what->kind == Expr::Kind::kGroup) {
    for (const Setting& setting : what->settings) {
      if (setting.value.expr == nullptr || !setting.name.text.empty()) continue;
      cdl::SocietyMember member = members(*setting.value.expr, setting.value.expr->spot, depth + 1);
      const bool is_empty = member.kind == cdl::SocietyMember::Kind::kCaste && member.members.empty();
      if (!is_empty) caste.members.push_back(std::move(member));
    }
    if (caste.members.size() == 1) return std::move(caste.members[0]);
    return caste;
  }
  const Symbol* symbol = converter_.symbols().find(expr.name);
  const Spot& at = symbol != nullptr && symbol->expr == what ? symbol->spot : spot;
  const Expr* device = converter_.bound_device(*what);
  const Expr* robot = device != nullptr && is_robot(*device) ? device : what;
  if (!is_robot(*robot) && !is_output_point(what->name.text)) {
    others_.push_back(&expr);
    return caste;
  }
  cdl::SocietyMember out;
  converter_.mark_used(what);
  out.name.text = add_robot(*robot, at);
  return out;
}

void Robots::add(const Expr& expr, const Spot& spot) {
  const Expr* device = converter_.bound_device(expr);
  converter_.mark_used(&expr);
  add_robot(device != nullptr && is_robot(*device) ? *device : expr, spot);
}

// The binding points that a robot is given, through groups and references.
void Robots::collect_driven(const Expr& expr, std::vector<Driven>& into, int depth) {
  const Expr* what = resolved(expr);
  if (what == nullptr || depth > kMaxGroups) return;
  converter_.mark_used(what);
  if (what->kind == Expr::Kind::kGroup || is_robot(*what)) {
    for (const Setting& setting : what->settings) {
      if (setting.value.expr != nullptr && setting.name.text.empty())
        collect_driven(*setting.value.expr, into, depth + 1);
    }
    return;
  }
  Driven driven{what->name.text, what, converter_.bound_device(*what)};
  if (driven.device != nullptr) converter_.mark_used(driven.device);
  into.push_back(std::move(driven));
}

std::string Robots::add_robot(const Expr& expr, const Spot& spot) {
  cdl::Robot robot;
  std::string wanted = expr.inline_names.empty() ? std::string{} : expr.inline_names[0].text;
  if (wanted.empty() || wanted.starts_with('$'))
    wanted = fmt::format("{}Robot{}", file_stem_, robots_.size() + 1);
  robot.name = {converter_.free_name(wanted), expr.place};
  std::vector<Driven> driven;
  collect_driven(expr, driven, 0);
  Unit unit;
  unit.name = robot.name.text;
  converter_.start(unit);
  for (const Driven& d : driven) drive(d, robot);
  converter_.finish(unit);
  robot.lets = std::move(unit.lets);
  choose_class(expr, driven, robot);
  if (!spot.label.text.empty() && spot.label.text != "Individual Robot" && spot.label.text != "The robot")
    robot.help = help_text(spot.label.text);
  if (spot.has_position) nodes_.push_back({robot.name.text, spot.x, spot.y});
  robots_.push_back(std::move(robot));
  return robots_.back().name.text;
}

void Robots::drive(const Driven& driven, cdl::Robot& robot) {
  const Level* outer = converter_.level(nullptr, driven.point->settings);
  const Expr& taker = driven.device == nullptr ? *driven.point : *driven.device;
  const Setting* input = driven_input(taker);
  const Level* own = driven.device == nullptr ? outer : converter_.level(outer, driven.device->settings);
  if (!is_output_point(driven.binding) && input == nullptr) {
    converter_.sink().warning(
        "not-an-actuator", driven.point->place,
        fmt::format("`{}` drives nothing; it is left out", text::shown(driven.binding)));
    return;
  }
  Port port;
  port.type = "Vector";
  converter_.suggest(robot.name.text + "_" + driven.binding);
  TypedDraft value = input == nullptr ? TypedDraft{} : converter_.make_value(*input, own, port, "");
  if (value.expr == nullptr) value = converter_.nothing("Vector", taker.place);
  cdl::Drive drive;
  drive.binding = {driven.binding, driven.point->place};
  drive.value = value.expr;
  const bool is_there_twice = std::ranges::any_of(
      robot.drives, [&](const cdl::Drive& d) { return d.binding.text == driven.binding; });
  if (is_there_twice) {
    converter_.sink().warning(
        "driven-twice", driven.point->place,
        fmt::format("the robot has a `{}` already; this one is left out", text::shown(driven.binding)));
    return;
  }
  robot.drives.push_back(std::move(drive));
}

// Our class; what the historic file sets of its actuators becomes parameters of the robot, which stand before
// those of the class. An actuator that our class lacks is left out.
void Robots::choose_class(const Expr& robot, const std::vector<Driven>& driven, cdl::Robot& into) {
  const std::string& historic = robot.name.text;
  const std::string_view ours =
      robot_class_named(is_output_point(historic) ? std::string_view{} : std::string_view(historic));
  const cdl::RobotClass* known =
      converter_.vocabulary().robot_class(ours.empty() ? std::string_view("Scout") : ours);
  if (const cdl::RobotClass* scout = converter_.vocabulary().robot_class("Scout");
      known != nullptr && scout != nullptr) {
    if (lacks(*known, into) && !lacks(*scout, into)) known = scout;  // with a camera that turns, say
  }
  if (known == nullptr) {
    converter_.warn_once(
        "no-robot-class", historic, robot.name.place,
        fmt::format("no class of robots here answers to `{}`; the robot has none", text::shown(historic)));
    into.drives.clear();
    return;
  }
  if (ours.empty() && !is_output_point(historic)) {
    converter_.warn_once("unknown-robot-class", historic, robot.name.place,
                         fmt::format("no class of robots is called `{}`; `{}` is taken",
                                     text::shown(historic), known->name.text));
  }
  into.class_name.text = known->name.text;
  std::erase_if(into.drives, [&](const cdl::Drive& drive) {
    const bool is_there = has_actuator(*known, drive);
    if (!is_there) {
      converter_.warn_once("no-actuator", into.name.text + drive.binding.text, drive.binding.place,
                           fmt::format("`{}` has no `{}`; what drove it is left as an assemblage",
                                       known->name.text, text::shown(drive.binding.text)));
    }
    return !is_there;
  });
  for (const Driven& d : driven) {
    if (d.device != nullptr) set_parameters(*d.device, *known, into);
  }
}

void Robots::set_parameters(const Expr& device, const cdl::RobotClass& known, cdl::Robot& into) {
  const HistoricSignature* historic = converter_.vocabulary().find_historic(device.name.text);
  if (historic == nullptr) return;
  for (const Setting& setting : device.settings) {
    const auto port = historic->ports.find(setting.name.text);
    if (setting.is_pushed || setting.value.kind != Value::Kind::kConstant || port == historic->ports.end())
      continue;
    if (port->second.port == nullptr) continue;
    const std::string& name = port->second.port->name;
    const auto declared =
        std::ranges::find_if(known.parameters, [&](const cdl::Parameter& p) { return p.name.text == name; });
    if (declared == known.parameters.end()) {
      const std::string& said = setting.value.constant.text;
      if (name == "cautious_mode" && (said == "false" || said == "FALSE" || said == "0")) continue;
      converter_.warn_once("lost-parameter", into.name.text + name, setting.name.place,
                           fmt::format("`{}` takes no `{}`; it is left out", known.name.text, name));
      continue;
    }
    const bool is_set =
        std::ranges::any_of(into.parameters, [&](const cdl::Parameter& p) { return p.name.text == name; });
    const Draft value = constant(converter_.with_names(setting.value.constant), port->second.port->type,
                                 port->second.port->unit);
    if (is_set || value == nullptr) continue;
    cdl::Parameter parameter = *declared;
    parameter.name.place = setting.name.place;
    parameter.initial = value;
    into.parameters.push_back(std::move(parameter));
  }
}

}  // namespace mlab::cdl_historic
