#include "mlab/lang/cdl/lower/trigger_logic.h"

#include <algorithm>

#include "mlab/lang/cdl/print/print.h"

namespace mlab::cdl {
namespace {

using Constant = TriggerLogic::Constant;

constexpr int kMaxNameDepth = 20;      // names in names that are followed
constexpr std::size_t kMaxFacts = 10;  // of one state: all combinations are tried

Constant opposite(Constant value) {
  if (value == Constant::kTrue) return Constant::kFalse;
  return value == Constant::kFalse ? Constant::kTrue : value;
}

}  // namespace

bool TriggerLogic::is_literal(const Expression& expression, const Scope& scope) const {
  if (std::holds_alternative<Number>(expression.what) || std::holds_alternative<Text>(expression.what))
    return true;
  if (const auto* list = std::get_if<List>(&expression.what)) {
    return std::ranges::all_of(list->items,
                               [&](const ExpressionPtr& item) { return is_literal(*item, scope); });
  }
  if (const auto* arithmetic = std::get_if<Arithmetic>(&expression.what)) {
    return std::ranges::all_of(arithmetic->operands,
                               [&](const ExpressionPtr& operand) { return is_literal(*operand, scope); });
  }
  const auto* name = std::get_if<Name>(&expression.what);
  if (name == nullptr) return false;
  const auto is_it = [&](const auto& declared) { return declared.name.text == name->name.text; };
  return std::ranges::none_of(*scope.parameters, is_it) && std::ranges::none_of(*scope.lets, is_it);
}

// A call without memory, of constants alone; or an assemblage without parameters that is constant itself.
Constant TriggerLogic::constant_call(const Call& call, const Scope& scope) const {
  if (configuration_.bindings.contains(call.callee.text)) return Constant::kNo;
  if (const Assemblage* found = configuration_.assemblage_named(call.callee)) {
    const Assemblage& called = *found;
    if (!called.body || scope.depth >= kMaxNameDepth) return Constant::kNo;
    return constant(*called.body, {&called.parameters, &called.lets, scope.depth + 1});
  }
  const flow::Behavior* behavior = library_.find(call.callee.text).behavior;
  const bool can_be = behavior != nullptr && behavior->is_pure;
  if (!can_be ||
      !std::ranges::all_of(call.arguments, [&](const Argument& a) { return is_literal(*a.value, scope); }))
    return Constant::kNo;
  if (behavior->name != "Constant") return Constant::kSome;
  return call.arguments.empty() ? Constant::kTrue : constant(*call.arguments.front().value, scope);
}

Constant TriggerLogic::constant_name(const std::string& name, const Scope& scope) const {
  const auto let = std::ranges::find_if(*scope.lets, [&](const Let& one) { return one.name.text == name; });
  if (let != scope.lets->end()) {
    return scope.depth >= kMaxNameDepth
               ? Constant::kNo
               : constant(*let->value, {scope.parameters, scope.lets, scope.depth + 1});
  }
  if (name == "true") return Constant::kTrue;
  return name == "false" ? Constant::kFalse : Constant::kNo;
}

Constant TriggerLogic::constant_logic(const Logic& logic, const Scope& scope) const {
  if (logic.connective == Connective::kNot) return opposite(constant(*logic.operands.front(), scope));
  // What decides: one `false` of an `and`, one `true` of an `or`.
  const bool is_or = logic.connective == Connective::kOr;
  bool has_variable = false;
  bool has_some = false;
  for (const ExpressionPtr& operand : logic.operands) {
    const Constant value = constant(*operand, scope);
    if (value == (is_or ? Constant::kTrue : Constant::kFalse)) return value;
    has_variable |= value == Constant::kNo;
    has_some |= value == Constant::kSome;
  }
  if (has_variable) return Constant::kNo;
  if (has_some) return Constant::kSome;
  return is_or ? Constant::kFalse : Constant::kTrue;
}

Constant TriggerLogic::constant(const Expression& expression, const Scope& scope) const {
  if (const auto* call = std::get_if<Call>(&expression.what)) return constant_call(*call, scope);
  if (const auto* name = std::get_if<Name>(&expression.what)) {
    const bool is_parameter = std::ranges::any_of(
        *scope.parameters, [&](const Parameter& p) { return p.name.text == name->name.text; });
    return is_parameter ? Constant::kNo : constant_name(name->name.text, scope);
  }
  if (std::holds_alternative<Arithmetic>(expression.what))
    return is_literal(expression, scope) ? Constant::kSome : Constant::kNo;
  const auto* logic = std::get_if<Logic>(&expression.what);
  return logic == nullptr || logic->operands.empty() ? Constant::kNo : constant_logic(*logic, scope);
}

void TriggerLogic::collect_facts(const Expression& expression, const Scope& scope) {
  if (const auto* logic = std::get_if<Logic>(&expression.what)) {
    for (const ExpressionPtr& operand : logic->operands) collect_facts(*operand, scope);
    return;
  }
  const Constant value = constant(expression, scope);
  Leaf& leaf = leaves_[&expression];
  leaf.is_true = value == Constant::kTrue;
  if (value == Constant::kTrue || value == Constant::kFalse) return;
  leaf.fact = facts_.try_emplace(print(expression), static_cast<unsigned>(facts_.size())).first->second;
}

bool TriggerLogic::is_true(const Expression& expression, unsigned facts) const {
  if (const auto* logic = std::get_if<Logic>(&expression.what)) {
    const auto holds = [&](const ExpressionPtr& operand) { return is_true(*operand, facts); };
    switch (logic->connective) {
      case Connective::kNot:
        return !holds(logic->operands.front());
      case Connective::kAnd:
        return std::ranges::all_of(logic->operands, holds);
      case Connective::kOr:
        return std::ranges::any_of(logic->operands, holds);
    }
  }
  const Leaf& leaf = leaves_.at(&expression);
  return leaf.fact ? (facts >> *leaf.fact & 1U) != 0 : leaf.is_true;
}

TriggerLogic::Verdict TriggerLogic::verdict(const State& state, std::size_t index, const Scope& scope) const {
  const Expression& trigger = *state.transitions[index].trigger;
  Verdict out{constant(trigger, scope), false, false, {}};
  const unsigned combinations = 1U << facts_.size();
  unsigned true_in = 0;
  bool is_hidden = true;
  std::vector<bool> suffices(index, true);
  std::vector<bool> is_same(index, true);
  for (unsigned facts = 0; facts < combinations; ++facts) {
    const bool now = is_true(trigger, facts);
    true_in += now ? 1 : 0;
    bool is_any = false;
    for (std::size_t above = 0; above < index; ++above) {
      const bool before = is_true(*state.transitions[above].trigger, facts);
      is_any = is_any || before;
      if (now && !before) suffices[above] = false;
      if (now != before) is_same[above] = false;
    }
    is_hidden = is_hidden && (!now || is_any);
  }
  if (out.constant == Constant::kNo && true_in == 0) out.constant = Constant::kFalse;
  if (out.constant == Constant::kNo && true_in == combinations) out.constant = Constant::kTrue;
  out.is_hidden = is_hidden && true_in > 0;
  if (!out.is_hidden) return out;
  for (std::size_t above = 0; above < index; ++above) {
    if (!suffices[above]) continue;
    if (!out.hidden_by) out.hidden_by = above;
    out.is_same = out.is_same || is_same[above];
  }
  return out;
}

std::vector<TriggerLogic::Verdict> TriggerLogic::judge(const State& state,
                                                       const std::vector<Parameter>& parameters,
                                                       const std::vector<Let>& lets) {
  const Scope scope{&parameters, &lets, 0};
  facts_.clear();
  leaves_.clear();
  for (const Transition& transition : state.transitions) {
    if (transition.trigger && facts_.size() <= kMaxFacts) collect_facts(*transition.trigger, scope);
  }
  std::vector<Verdict> out(state.transitions.size());
  if (std::ranges::any_of(state.transitions, [](const Transition& one) { return one.trigger == nullptr; }))
    return out;
  const bool knows_all = facts_.size() <= kMaxFacts;
  std::map<std::string, std::size_t> written;  // the first that is written so
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (knows_all) {
      out[i] = verdict(state, i, scope);
      continue;
    }
    const Expression& trigger = *state.transitions[i].trigger;
    out[i].constant = constant(trigger, scope);
    const auto [first, is_new] = written.try_emplace(print(trigger), i);
    if (!is_new) out[i] = {out[i].constant, true, true, first->second};
  }
  return out;
}

}  // namespace mlab::cdl
