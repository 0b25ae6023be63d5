#include "mlab/lang/cdl/formula/formula_parts.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/formula/formula.h"
#include "mlab/lang/cdl/formula/formula_term.h"
#include "mlab/lang/cdl/print/print.h"
#include "mlab/lang/cdl/syntax/signs.h"

namespace mlab::cdl {
namespace {

constexpr std::size_t kMaxParts = 1'000'000;

bool is_instance_of(std::string_view name, std::initializer_list<Symbol> symbols) {
  return std::ranges::any_of(symbols,
                             [&](Symbol symbol) { return instance_number(symbol, name).has_value(); });
}

}  // namespace

Part& Parts::make(Part::Kind kind, bool moves, std::string what, const Scope& scope) {
  Part& part = parts_.emplace_back();
  part.kind = kind;
  part.moves = moves;
  part.what = std::move(what);
  part.owner = scope.owner;
  return part;
}

std::vector<const Part*> Parts::robot(const Robot& robot) {
  Scope& scope = scopes_.emplace_back();
  scope.owner = robot.name.text;
  for (const Let& let : robot.lets) scope.names[let.name.text] = {&let, {}, false};
  std::vector<const Part*> out;
  for (const Drive& drive : robot.drives) {
    if (!drive.value) continue;
    const Values driven = values(*drive.value, scope);
    if (!driven.empty()) out.push_back(driven.front());
  }
  return failed_ ? std::vector<const Part*>{} : out;
}

void Parts::add(const ExpressionPtr& expression, Scope& scope, Values& into) {
  if (!expression) return;
  for (const Part* part : values(*expression, scope)) {
    if (std::ranges::find(into, part) == into.end()) into.push_back(part);
  }
}

Parts::Values Parts::values(const Expression& expression, Scope& scope) {
  if (failed_) return {};
  if (++depth_ > 2 * kMaxFormulaDepth || parts_.size() > kMaxParts) {
    failed_ = true;
    if (depth_ > 2 * kMaxFormulaDepth)
      sink_.error("nested-too-deep", expression.place, "too deep for a sentence");
    else
      sink_.error("formula-too-long", expression.place,
                  fmt::format("a sentence of more than {} instances", kMaxParts));
    return {};
  }
  Values out = values_of(expression, scope);
  if (expression.active && !out.empty()) {
    const Values active = values(*expression.active, scope);
    // The value may have other readers, who don't move the sensor.
    const Part* plain = out.front();
    Part& part = parts_.emplace_back(*plain);
    part.origin = plain->origin == nullptr ? plain : plain->origin;
    if (!active.empty()) part.active = active.front();
    out = {&part};
  }
  --depth_;
  return out;
}

Parts::Values Parts::values_of(const Expression& expression, Scope& scope) {
  const std::string& name = expression.as.text;
  const auto named_as = [&](Values values) {
    // Only an operator that was made right here: what a name stands for keeps its own.
    if (values.size() == 1 && !name.empty()) parts_.back().name = name;
    return values;
  };
  struct Visitor {
    Parts& parts;
    Scope& scope;
    const Expression& expression;
    Values operator()(const Hole&) const { return {}; }
    Values operator()(const Number&) const { return {}; }
    Values operator()(const Text&) const { return {}; }
    Values operator()(const Name& one) const { return parts.named(one.name.text, scope); }
    Values operator()(const List& list) const {
      Values out;
      for (const ExpressionPtr& item : list.items) parts.add(item, scope, out);
      return out;
    }
    Values operator()(const Call& call) const { return parts.call(call, scope, expression.place); }
    Values operator()(const Logic& logic) const { return parts.logic(logic, scope); }
    Values operator()(const Arithmetic& what) const {
      return parts.fused(std::string(sign_of(what.operations.front())), what.operands, scope);
    }
    Values operator()(const Cooperate& what) const {
      return parts.group(Part::Kind::kCooperation, true, "cooperate", what.members, scope);
    }
    Values operator()(const Compete& what) const {
      const bool by_priority = what.rule == CompetitionRule::kPriority;
      return parts.group(Part::Kind::kCompetition, true,
                         by_priority ? "compete by priority" : "compete by strength", what.members, scope);
    }
    Values operator()(const Coordinate& what) const {
      return parts.group(Part::Kind::kCoordination, true, "coordinate by " + what.by.callee.text,
                         what.members, scope);
    }
    Values operator()(const Fuse& what) const {
      return parts.group(Part::Kind::kFusion, false, "fuse by " + what.by.callee.text, what.members, scope);
    }
    Values operator()(const Sequence& what) const { return parts.sequence(what, scope, expression.as.text); }
    Values operator()(const Select& what) const { return parts.select(what, scope); }
    Values operator()(const Delay& what) const {
      Values out;
      parts.add(what.value, scope, out);
      return out;
    }
  };
  const bool makes = std::holds_alternative<Cooperate>(expression.what) ||
                     std::holds_alternative<Compete>(expression.what) ||
                     std::holds_alternative<Coordinate>(expression.what) ||
                     std::holds_alternative<Fuse>(expression.what) ||
                     std::holds_alternative<Select>(expression.what);
  Values out = std::visit(Visitor{*this, scope, expression}, expression.what);
  return makes ? named_as(std::move(out)) : out;
}

Parts::Values Parts::named(std::string_view name, Scope& scope) {
  const auto found = scope.names.find(name);
  if (found == scope.names.end()) return {};
  Scope::Entry& entry = found->second;
  if (entry.is_ready) return entry.values;
  entry.is_ready = true;  // a loop, which only a delay closes, ends here
  if (entry.let != nullptr && entry.let->value) entry.values = values(*entry.let->value, scope);
  return entry.values;
}

// All that a call is given, in its order; the same may stand there twice.
Parts::Values Parts::given(const Call& call, Scope& scope) {
  Values out;
  for (const Argument& argument : call.arguments) {
    if (!argument.value) continue;
    const Values one = values(*argument.value, scope);
    out.insert(out.end(), one.begin(), one.end());
  }
  return out;
}

Parts::Values Parts::group(Part::Kind kind, bool moves, std::string what, const std::vector<Member>& members,
                           Scope& scope) {
  Values inside;
  for (const Member& member : members) {
    if (!member.value) continue;
    const Values one = values(*member.value, scope);
    inside.insert(inside.end(), one.begin(), one.end());
  }
  if (inside.empty()) return {};
  Part& part = make(kind, moves, std::move(what), scope);
  part.members = std::move(inside);
  return {&part};
}

Parts::Values Parts::fused(std::string what, const std::vector<ExpressionPtr>& operands, Scope& scope) {
  Values inside;
  for (const ExpressionPtr& operand : operands) add(operand, scope, inside);
  if (inside.empty()) return {};
  Part& part = make(Part::Kind::kFusion, false, std::move(what), scope);
  part.members = std::move(inside);
  return {&part};
}

Parts::Values Parts::logic(const Logic& logic, Scope& scope) {
  const char* what = logic.connective == Connective::kNot   ? "not"
                     : logic.connective == Connective::kAnd ? "and"
                                                            : "or";
  return fused(what, logic.operands, scope);
}

Parts::Values Parts::sequence(const Sequence& sequence, Scope& scope, const std::string& name) {
  Values inside;
  std::string what = "sequence of";
  for (const State& state : sequence.states) {
    what += fmt::format("{}{}", inside.empty() && what.ends_with("of") ? " " : ", ", state.name.text);
    if (!state.member) continue;
    const Values member = values(*state.member, scope);
    inside.insert(inside.end(), member.begin(), member.end());
  }
  if (inside.empty()) return {};
  // A sentence may sequence behaviors that only perceive; then its name tells.
  const bool moves = inside.front()->moves || is_instance_of(name, {Symbol::kSequencing});
  Part& part = make(Part::Kind::kSequencing, moves, std::move(what), scope);
  part.members = std::move(inside);
  part.name = name;
  return {&part};
}

Parts::Values Parts::select(const Select& select, Scope& scope) {
  Values inside;
  for (const Case& one : select.cases) {
    if (!one.member) continue;
    const Values member = values(*one.member, scope);
    inside.insert(inside.end(), member.begin(), member.end());
  }
  if (inside.empty()) return {};
  const bool moves = inside.front()->moves;
  // Perception that is chosen among is sequenced; of movements G only has the general operator.
  Part& part = make(moves ? Part::Kind::kCoordination : Part::Kind::kSequencing, moves,
                    "select by " + (select.by ? print(*select.by) : std::string()), scope);
  std::ranges::replace(part.what, '\n', ' ');
  part.members = std::move(inside);
  return {&part};
}

bool Parts::gives_movement(std::string_view callee) const {
  const flow::Library::Entry entry = library_.find(callee);
  if (entry.behavior == nullptr || entry.behavior->output == nullptr) return false;
  return entry.behavior->output->name == "Vector" && entry.behavior->output_unit.empty();
}

Parts::Values Parts::call(const Call& call, Scope& scope, const text::Place& place) {
  if (const Assemblage* found = configuration_.assemblage_named(call.callee))
    return assemblage(*found, call, scope, place);
  const bool is_binding = configuration_.bindings.contains(call.callee.text);
  return process(call.callee.text, !is_binding && gives_movement(call.callee.text), call, scope);
}

Parts::Values Parts::process(std::string_view name, bool moves, const Call& call, Scope& scope) {
  Values inputs;
  for (const Argument& argument : call.arguments) add(argument.value, scope, inputs);
  Part& part = make(Part::Kind::kProcess, moves, std::string(name), scope);
  part.name = name;
  part.members = std::move(inputs);
  return {&part};
}

Parts::Values Parts::assemblage(const Assemblage& assemblage, const Call& call, Scope& scope,
                                const text::Place& place) {
  const std::string& name = assemblage.name.text;
  if (!assemblage.body) {
    const bool is_fusion = is_instance_of(name, {Symbol::kFusion});
    if (is_fusion || is_instance_of(name, {Symbol::kCoordination})) {
      Values inside = given(call, scope);
      Part& part = make(is_fusion ? Part::Kind::kFusion : Part::Kind::kCoordination, !is_fusion, name, scope);
      part.name = name;
      part.members = std::move(inside);
      return {&part};
    }
    const bool is_percept = name == "p0" || is_instance_of(name, {Symbol::kPercept});
    const bool gives_vector = assemblage.result_type.text.empty() || assemblage.result_type.text == "Vector";
    return process(name, gives_vector && !is_percept, call, scope);
  }
  if (std::ranges::find(open_, &assemblage) != open_.end()) {
    failed_ = true;
    sink_.error("recursion", place, fmt::format("`{}` stands in itself", name));
    return {};
  }
  Scope& inner = scopes_.emplace_back();
  inner.owner = name;
  for (const Let& let : assemblage.lets) inner.names[let.name.text] = {&let, {}, false};
  std::size_t position = 0;
  for (const Argument& argument : call.arguments) {
    std::string parameter = argument.name.text;
    if (parameter.empty() && position < assemblage.parameters.size())
      parameter = assemblage.parameters[position++].name.text;
    Scope::Entry& entry = inner.names[parameter];
    entry.is_ready = true;
    entry.values.clear();
    if (argument.value) entry.values = values(*argument.value, scope);
  }
  for (const Parameter& parameter : assemblage.parameters) {
    if (inner.names.contains(parameter.name.text)) continue;
    Values initial;
    if (parameter.initial) initial = values(*parameter.initial, inner);
    inner.names[parameter.name.text] = {nullptr, std::move(initial), true};
  }
  open_.push_back(&assemblage);
  Values out = values(*assemblage.body, inner);
  open_.pop_back();
  return out;
}

}  // namespace mlab::cdl
