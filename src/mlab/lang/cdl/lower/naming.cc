#include "mlab/lang/cdl/lower/naming.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/syntax/signs.h"

namespace mlab::cdl {
namespace {

constexpr int kMaxNameDepth = 64;  // names and calls may go round in circles

}  // namespace

std::vector<bool> given_parameters(const Call& call, const std::vector<Parameter>& parameters) {
  std::vector<bool> out(parameters.size(), false);
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    const std::string& name = call.arguments[i].name.text;
    const auto at =
        name.empty()
            ? i
            : static_cast<std::size_t>(
                  std::ranges::find_if(parameters, [&](const Parameter& p) { return p.name.text == name; }) -
                  parameters.begin());
    if (at < out.size()) out[at] = true;
  }
  return out;
}

// ---- names

void Naming::take(const NamesBelow& taken) {
  for (const std::string& name : taken) levels_[""].emplace(name, 1);
}

std::string Naming::claim(const std::string& prefix, const std::string& name) {
  Level& level = levels_[prefix];
  int& count = level[name];
  if (count++ == 0) return joined_path(prefix, name);
  for (;; ++count) {
    std::string numbered = fmt::format("{}_{}", name, count);
    if (level.try_emplace(numbered, 1).second) return joined_path(prefix, numbered);
  }
}

std::string Naming::claim(const Slot& slot, std::string_view fallback) {
  if (slot.is_claimed) return slot.prefix;
  return claim(slot.prefix, slot.name.empty() ? std::string(fallback) : slot.name);
}

NamesBelow Naming::names_below(const std::string& path) const {
  NamesBelow out;
  if (const auto level = levels_.find(path); level != levels_.end()) {
    for (const auto& [name, count] : level->second) out.insert(name);
  }
  return out;
}

void Naming::record(const Expression& expression, NodeNames::Paths paths) {
  const auto [at, is_new] = out_.paths_.try_emplace(&expression, std::move(paths));
  if (!is_new) out_.again_[&expression].push_back(std::move(paths));
}

// Of the expression that was walked last, if it was so.
NodeNames::Paths& Naming::recorded(const Expression& expression) {
  const auto again = out_.again_.find(&expression);
  return again == out_.again_.end() ? out_.paths_[&expression] : again->second.back();
}

void Naming::record_behind(const Expression& expression, std::string path) {
  recorded(expression).behind = std::move(path);
}

// ---- expressions

void Naming::walk(const ExpressionPtr& expression, const Slot& slot) {
  if (!expression || depth_ > kDeepestExpression) return;
  ++depth_;
  Slot own = slot;
  if (!expression->as.text.empty()) {
    const bool has_name = slot.is_claimed || !slot.name.empty();
    own = {has_name ? claim(slot, "") : slot.prefix, expression->as.text, false};
  }
  if (expression->active) {
    const auto* call = std::get_if<Call>(&expression->what);
    const std::string path = claim(own, call == nullptr ? "active" : call->callee.text);
    walk_what(*expression, {path, "value", false}, &path);
    walk(expression->active, {path, "active", false});
    if (is_movement(*expression->active)) record_behind(*expression->active, claim(path, "is_idle"));
  } else {
    walk_what(*expression, own, nullptr);
  }
  --depth_;
}

void Naming::walk_what(const Expression& expression, const Slot& slot, const std::string* active) {
  if (const auto* name = std::get_if<Name>(&expression.what)) {
    walk_name(*name);
  } else if (const auto* list = std::get_if<List>(&expression.what)) {
    const bool is_below = slot.is_claimed || slot.name.empty();
    const std::string path = is_below ? slot.prefix : claim(slot, "");
    for (const ExpressionPtr& item : list->items) walk(item, {path, "", false});
  } else if (const std::string fallback = default_name(expression); !fallback.empty()) {
    const std::string path = claim(slot, fallback);
    record(expression, {active == nullptr ? path : *active, path, ""});
    walk_parts(expression, path);
    return;
  }
  if (active != nullptr) record(expression, {*active, "", ""});
}

void Naming::walk_parts(const Expression& expression, const std::string& path) {
  const auto& what = expression.what;
  if (const auto* call = std::get_if<Call>(&what)) {
    walk_call(expression, *call, path);
  } else if (const auto* cooperate = std::get_if<Cooperate>(&what)) {
    walk_members(cooperate->members, "gain", path);
  } else if (const auto* compete = std::get_if<Compete>(&what)) {
    walk_compete(*compete, path);
  } else if (const auto* coordinate = std::get_if<Coordinate>(&what)) {
    walk_members(coordinate->members, "weight", path);
    walk_arguments(coordinate->by, path);
  } else if (const auto* fuse = std::get_if<Fuse>(&what)) {
    walk_members(fuse->members, "weight", path);
    walk_arguments(fuse->by, path);
  } else if (const auto* sequence = std::get_if<Sequence>(&what)) {
    walk_states(*sequence, path);
  } else if (const auto* select = std::get_if<Select>(&what)) {
    walk_select(*select, path);
  } else if (const auto* logic = std::get_if<Logic>(&what)) {
    walk_logic(*logic, path);
  } else if (const auto* arithmetic = std::get_if<Arithmetic>(&what)) {
    walk_arithmetic(expression, *arithmetic, path);
  } else if (const auto* delay = std::get_if<Delay>(&what)) {
    walk(delay->value, {path, "value", false});
    walk(delay->initial, {path, "initial", false});
  }
}

void Naming::walk_arguments(const Call& call, const std::string& path) {
  for (const Argument& argument : call.arguments) walk(argument.value, {path, "", false});
}

void Naming::walk_call(const Expression& expression, const Call& call, const std::string& path) {
  if (types_.function(call.callee) != nullptr) {
    std::vector<ExpressionPtr> operands;
    for (const Argument& argument : call.arguments) operands.push_back(argument.value);
    walk_operands(operands, path);
    name_angles(expression, operands, path);
    return;
  }
  walk_arguments(call, path);
  const auto binding = configuration_.bindings.find(call.callee.text);
  const bool is_binding = binding != configuration_.bindings.end();
  if (is_binding) {
    // What nobody gives is evaluated by who asks, among the owner's own nodes.
    const std::vector<Parameter>& parameters = binding->second->parameters;
    const std::vector<bool> given = given_parameters(call, parameters);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (!given[i]) walk(parameters[i].initial, {"", parameters[i].name.text, false});
    }
  }
  if (!is_binding && configuration_.assemblage_named(call.callee) == nullptr) return;
  out_.hands_on_ |= path.empty();
  if (NamesBelow below = names_below(path); !below.empty()) out_.below_[&expression] = std::move(below);
}

void Naming::walk_members(const std::vector<Member>& members, const char* weight, const std::string& path) {
  for (const Member& member : members) {
    walk(member.value, {path, "", false});
    walk(member.weight, {path, weight, false});
  }
}

void Naming::walk_compete(const Compete& compete, const std::string& path) {
  const bool has_weights =
      std::ranges::any_of(compete.members, [](const Member& m) { return m.weight != nullptr; });
  const bool compares = has_weights && compete.rule == CompetitionRule::kStrength;
  for (const Member& member : compete.members) {
    walk(member.value, {path, "", false});
    walk(member.weight, {path, "activation", false});
    if (compares && !member.weight && member.value) record_behind(*member.value, claim(path, "Length"));
  }
}

void Naming::walk_logic(const Logic& logic, const std::string& path) {
  for (const ExpressionPtr& operand : logic.operands) walk(operand, {path, "", false});
  if (logic.connective == Connective::kNot) return;
  // `a and b and c` is (a and b) and c: the last has the node's own name.
  const char* const name = logic.connective == Connective::kAnd ? "And" : "Or";
  for (std::size_t i = 1; i + 1 < logic.operands.size(); ++i)
    record_behind(*logic.operands[i], claim(path, name));
}

// `a + b - c` is (a + b) - c: the last has the node's own name.
void Naming::walk_arithmetic(const Expression& expression, const Arithmetic& arithmetic,
                             const std::string& path) {
  walk_operands(arithmetic.operands, path);
  for (std::size_t i = 0; i + 1 < arithmetic.operations.size(); ++i)
    record_behind(*arithmetic.operands[i + 1], claim(path, std::string(sign(arithmetic.operations[i]).name)));
  name_angles(expression, arithmetic.operands, path);
}

void Naming::walk_operands(const std::vector<ExpressionPtr>& operands, const std::string& path) {
  for (const ExpressionPtr& operand : operands) walk(operand, {path, "", false});
}

// What comes in degrees is counted in radians first. Whether it does is only known of each instance: a
// parameter is given in either.
void Naming::name_angles(const Expression& expression, const std::vector<ExpressionPtr>& operands,
                         const std::string& path) {
  NodeNames::Paths& paths = recorded(expression);
  paths.angle = claim(path, "angle");
  for (const ExpressionPtr& operand : operands) {
    const bool is_literal = !operand || std::holds_alternative<Number>(operand->what) ||
                            std::holds_alternative<List>(operand->what) ||
                            std::holds_alternative<Text>(operand->what);
    paths.operand_angles.push_back(is_literal ? "" : claim(path, "angle"));
  }
}

void Naming::walk_states(const Sequence& sequence, const std::string& path) {
  for (const State& state : sequence.states) {
    const std::string own = claim(path, state.name.text);
    out_.states_[&state] = own;
    walk(state.member, {own, "", true});
    for (const Transition& transition : state.transitions) {
      if (!transition.trigger) continue;
      const Expression& condition = condition_of(*transition.trigger);
      const bool is_whole = &condition == transition.trigger.get();
      walk(is_whole ? transition.trigger : std::get<Logic>(transition.trigger->what).operands.front(),
           {own, "", false});
    }
  }
}

void Naming::walk_select(const Select& select, const std::string& path) {
  walk(select.by, {path, "by", false});
  for (const Case& one : select.cases) walk(one.member, {path, case_name(one), false});
}

void Naming::walk_name(const Name& name) {
  const auto let = let_named_.find(name.name.text);
  if (let != let_named_.end()) walk_let(*let->second);
}

void Naming::open_lets(const std::vector<Let>& lets) {
  lets_ = &lets;
  for (const Let& let : lets) let_named_.emplace(let.name.text, &let);
}

void Naming::walk_let(const Let& let) {
  if (depth_ > kDeepestExpression || !walked_.insert(&let).second) return;
  const std::string path = claim("", let.name.text);
  out_.lets_[&let] = path;
  walk(let.value, {path, "", true});
}

PortType Naming::type_of(const Expression& expression) const {
  static const std::vector<Parameter> kNoParameters;
  static const std::vector<Let> kNoLets;
  return types_.of(expression, types_.names_of(parameters_ == nullptr ? kNoParameters : *parameters_,
                                               lets_ == nullptr ? kNoLets : *lets_));
}

bool Naming::is_movement(const Expression& expression) const {
  const PortType type = type_of(expression);
  return type.type != nullptr && type.type->kind == flow::TypeKind::kVector;
}

// ---- owners

NodeNames Naming::of(const Assemblage& assemblage, const std::vector<const Parameter*>& defaults,
                     const NamesBelow& taken) {
  take(taken);
  parameters_ = &assemblage.parameters;
  for (const Parameter* parameter : defaults) walk(parameter->initial, {"", parameter->name.text, false});
  open_lets(assemblage.lets);
  walk(assemblage.body, {"", "", true});
  out_.top_ = names_below("");
  for (const Let& let : assemblage.lets) walk_let(let);
  return std::move(out_);
}

NodeNames Naming::of(const Device& device, const NamesBelow& taken) {
  take(taken);
  walk_arguments(device.by, "");
  out_.top_ = names_below("");
  return std::move(out_);
}

void Naming::walk_robot_parameter(const Parameter& parameter) {
  if (types_.of(parameter).type == nullptr || !parameter.initial) return;
  walk(parameter.initial, {"", parameter.name.text, false});
  claim("", parameter.name.text);
}

// The class's parameters are the robot's, too; where both have one of a name, the robot's holds.
void Naming::walk_class(const Robot& robot) {
  const auto found = configuration_.classes.find(robot.class_name.text);
  if (robot.class_name.text.empty() || found == configuration_.classes.end()) return;
  const auto has = [](const auto& list, const std::string& name) {
    return std::ranges::any_of(list, [&](const auto& one) { return one.name.text == name; });
  };
  parameters_ = &found->second->parameters;
  for (const Parameter& parameter : found->second->parameters) {
    const std::string& name = parameter.name.text;
    if (!has(robot.parameters, name) || has(robot.lets, name)) walk_robot_parameter(parameter);
  }
  for (const BodySetting& setting : found->second->body)
    walk(setting.value, {"body", setting.name.text, false});
}

bool Naming::gives_nothing(const Expression& expression, const std::vector<Let>& lets, int depth) const {
  if (depth > kMaxNameDepth) return false;
  if (const auto* name = std::get_if<Name>(&expression.what)) {
    const auto let =
        std::ranges::find_if(lets, [&](const Let& one) { return one.name.text == name->name.text; });
    return let != lets.end() && let->value && gives_nothing(*let->value, lets, depth + 1);
  }
  const auto* call = std::get_if<Call>(&expression.what);
  if (call == nullptr || configuration_.bindings.contains(call->callee.text)) return false;
  if (const Assemblage* called = configuration_.assemblage_named(call->callee))
    return called->body && gives_nothing(*called->body, called->lets, depth + 1);
  return types_.is_sink(call->callee);
}

NodeNames Naming::of(const Robot& robot, const std::vector<const Device*>& actuators) {
  parameters_ = &robot.parameters;
  for (const Parameter& parameter : robot.parameters) walk_robot_parameter(parameter);
  walk_class(robot);
  parameters_ = &robot.parameters;
  open_lets(robot.lets);
  for (std::size_t i = 0; i < robot.drives.size(); ++i) {
    const Drive& drive = robot.drives[i];
    walk(drive.value, {"", drive.binding.text, false});
    const bool acts_itself = drive.value && gives_nothing(*drive.value, robot.lets, 0);
    if (actuators[i] != nullptr && !acts_itself) out_.drives_[&drive] = claim("", actuators[i]->name.text);
  }
  out_.top_ = names_below("");
  for (const Let& let : robot.lets) walk_let(let);
  return std::move(out_);
}

}  // namespace mlab::cdl
