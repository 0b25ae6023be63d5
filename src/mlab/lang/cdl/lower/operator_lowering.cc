#include "mlab/lang/cdl/lower/operator_lowering.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include <fmt/core.h>

#include "mlab/flow/frame.h"
#include "mlab/flow/port_types.h"
#include "mlab/flow/type_words.h"

namespace mlab::cdl {
namespace {

flow::Node node_of(std::string name, std::string behavior, const text::Place& place) {
  flow::Node node;
  node.name = std::move(name);
  node.behavior = std::move(behavior);
  node.place = node.behavior_place = place;
  return node;
}

flow::Source named(const std::string& name, const text::Place& place) {
  return {flow::Source::Kind::kName, name, place};
}

}  // namespace

bool OperatorLowering::check_members(const std::vector<Member>& members, const char* what,
                                     const text::Place& place) {
  if (!members.empty()) return true;
  findings_.error("no-members", place, fmt::format("`{}` has no members", what));
  return false;
}

Value OperatorLowering::cooperate(const Cooperate& what, Scope& scope, const std::string& path,
                                  const text::Place& place) {
  const PortType vector = types_.named("Vector");
  const PortType gain = types_.named("double");
  if (!check_members(what.members, "cooperate", place)) return wire(path, vector, place);
  flow::Node node = node_of(path, "WeightedSum", place);
  for (const Member& member : what.members) {
    const Value value = values_.value_of(*member.value, scope);
    auto source = binder_.bind(value, vector, nullptr, "cooperate", member.value->place);
    if (source) node.links.push_back({"members", std::move(*source), member.value->place});
    flow::Source weight{flow::Source::Kind::kConstant, "1", member.value->place};
    if (member.weight) {
      const Value given = values_.value_of(*member.weight, scope);
      const auto bound = binder_.bind(given, gain, nullptr, "gain", member.weight->place);
      if (bound) weight = *bound;
    }
    node.links.push_back({"gains", weight, member.weight ? member.weight->place : member.value->place});
  }
  network_.nodes.push_back(std::move(node));
  return wire(path, vector, place);
}

Value OperatorLowering::compete(const Compete& what, Scope& scope, const std::string& path,
                                const text::Place& place) {
  const PortType vector = types_.named("Vector");
  const bool by_strength = what.rule == CompetitionRule::kStrength;
  if (!check_members(what.members, "compete", place)) return wire(path, vector, place);
  const bool has_weights =
      std::ranges::any_of(what.members, [](const Member& m) { return m.weight != nullptr; });
  flow::Node node = node_of(path, by_strength ? "Arbiter" : "FirstActive", place);
  for (const Member& member : what.members) {
    const Value value = values_.value_of(*member.value, scope);
    auto source = binder_.bind(value, vector, nullptr, "compete", member.value->place);
    if (member.weight && !by_strength) {
      findings_
          .error("weight-without-meaning", member.weight->place,
                 "members that compete by priority have no weight")
          .hints = {"their order tells which comes first; `compete by strength` takes an activation here"};
    } else if (member.weight) {
      const Value given = values_.value_of(*member.weight, scope);
      auto bound = binder_.bind(given, types_.named("double"), nullptr, "activation", member.weight->place);
      if (bound) node.links.push_back({"activations", std::move(*bound), member.weight->place});
    } else if (has_weights && by_strength && source) {
      flow::Node length = node_of(scope.path_behind(*member.value), "Length", member.value->place);
      length.links.push_back({"v", *source, member.value->place});
      node.links.push_back({"activations", named(length.name, member.value->place), member.value->place});
      network_.nodes.push_back(std::move(length));
    }
    if (source) node.links.push_back({"members", std::move(*source), member.value->place});
  }
  network_.nodes.push_back(std::move(node));
  return wire(path, vector, place);
}

Value OperatorLowering::generic(const Call& by, const std::vector<Member>& members, Scope& scope,
                                const std::string& path, const text::Place& place) {
  const flow::Library::Entry entry = library_.find(by.callee.text);
  if (entry.behavior == nullptr) return calls_.unknown_callee(by.callee);
  std::vector<const flow::Input*> lists;
  for (const flow::Input& input : entry.behavior->inputs) {
    if (input.is_list) lists.push_back(&input);
  }
  if (lists.empty()) {
    findings_
        .error("not-an-operator", by.callee.place,
               fmt::format("`{}` takes no list of members", by.callee.text))
        .hints = {"an operator is a procedure with a list input"};
    return {};
  }
  std::vector<GivenArgument> given = given_by(by, scope);
  const auto add_list = [&](const flow::Input& input, std::vector<Value> items) {
    Value list;
    list.kind = Value::Kind::kList;
    list.items = std::move(items);
    list.place = place;
    given.push_back({{std::string(input.name), by.callee.place}, nullptr, nullptr, std::move(list), place});
  };
  std::vector<Value> values;
  std::vector<Value> weights;
  for (const Member& member : members) {
    values.push_back(values_.value_of(*member.value, scope));
    values.back().place = member.value->place;
    if (!member.weight) continue;
    weights.push_back(values_.value_of(*member.weight, scope));
    weights.back().place = member.weight->place;
    if (lists.size() > 1) continue;
    findings_.error("weight-without-meaning", member.weight->place,
                    fmt::format("members of `{}` have no weight", by.callee.text));
    return {};
  }
  if (!check_members(members, by.callee.text.c_str(), by.callee.place)) return {};
  if (!weights.empty() && weights.size() < members.size()) {
    const auto bare = std::ranges::find_if(members, [](const Member& m) { return m.weight == nullptr; });
    findings_.error("missing-weight", bare->value->place, "this member has no weight, and others have")
        .hints = {"either all members of an operator have one or none has"};
    return {};
  }
  add_list(*lists[0], std::move(values));
  if (!weights.empty()) add_list(*lists[1], std::move(weights));
  return calls_.procedure(by.callee, entry, given, path, place);
}

PortType OperatorLowering::common_type(const std::vector<Value>& members, const text::Place& place,
                                       const char* what) {
  // The one that most of them have: where one is different, it is that one which is wrong.
  std::ptrdiff_t most = 0;
  const flow::TypeInfo* usual = nullptr;
  for (const Value& member : members) {
    if (member.type.type == nullptr) continue;
    const auto is_alike = [&](const Value& other) {
      return other.type.type != nullptr && flow::same_type(*other.type.type, *member.type.type);
    };
    const std::ptrdiff_t alike = std::ranges::count_if(members, is_alike);
    const bool is_movement = member.type.type->kind == flow::TypeKind::kVector;
    if (alike > most || (alike == most && is_movement)) usual = member.type.type;
    most = std::max(most, alike);
  }
  if (usual != nullptr) return {usual, ""};
  const bool all_numbers = !members.empty() && std::ranges::all_of(members, [](const Value& member) {
    return member.kind == Value::Kind::kNumber;
  });
  if (all_numbers) return types_.named("double");
  const bool is_said =
      std::ranges::any_of(members, [](const Value& m) { return m.kind == Value::Kind::kNone; });
  if (!is_said)
    findings_.error("unknown-type", place, fmt::format("what type this {} has can't be told", what));
  return {};
}

flow::State OperatorLowering::state(const State& state, Scope& scope, Value& member) {
  flow::State out;
  out.name = state.name.text;
  out.place = state.name.place;
  out.is_start = state.is_start;
  out.is_final = state.is_final;
  if (state.member) member = values_.value_of(*state.member, scope);
  if (member.kind == Value::Kind::kSink) {
    findings_.error("sink-as-value", state.member->place, fmt::format("`{}` gives no value", member.text));
    member = {};
  }
  const PortType boolean = types_.named("bool");
  for (const Transition& transition : state.transitions) {
    flow::Transition code;
    code.target = transition.target.text;
    code.restarts = transition.restarts;
    code.place = transition.target.place;
    const Expression& condition = condition_of(*transition.trigger);
    code.is_negated = &condition != transition.trigger.get();
    const Value value = values_.value_of(condition, scope);
    if (auto source = binder_.bind(value, boolean, nullptr, "when", condition.place))
      code.trigger = std::move(*source);
    out.transitions.push_back(std::move(code));
  }
  return out;
}

Value OperatorLowering::sequence(const Sequence& what, Scope& scope, const std::string& path,
                                 const text::Place& place) {
  flow::Node node = node_of(path, "", place);
  node.kind = flow::Node::Kind::kSequence;
  if (what.states.empty()) {
    findings_.error("no-members", place, "`sequence` has no states");
    return {};
  }
  std::vector<Value> members(what.states.size());
  for (std::size_t i = 0; i < what.states.size(); ++i)
    node.states.push_back(state(what.states[i], scope, members[i]));
  const PortType type = common_type(members, place, "sequence");
  if (type.type == nullptr) return {};
  node.behavior = std::string(type.type->name);
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (!what.states[i].member) continue;
    auto source =
        binder_.bind(members[i], type, nullptr, what.states[i].name.text, what.states[i].member->place);
    if (source) node.states[i].member = std::move(*source);
  }
  network_.nodes.push_back(std::move(node));
  return wire(path, type, place);
}

std::optional<std::int64_t> OperatorLowering::case_value(const Word& word, const flow::TypeInfo& type) {
  alignas(flow::Frame::kAlignment) std::byte scratch[512] = {};
  const bool fits = type.parse != nullptr && type.size <= sizeof(std::int64_t);
  if (!fits || !type.parse(word.text, scratch)) {
    findings_.error("wrong-type", word.place, fmt::format("`{}` is no {}", word.text, flow::noun_of(type)))
        .label = fmt::format("the selector takes {}", flow::expected_of(type));
    return std::nullopt;
  }
  if (type.kind == flow::TypeKind::kInteger) {
    std::int32_t value = 0;
    std::memcpy(&value, scratch, sizeof value);
    return value;
  }
  std::uint64_t value = 0;  // little-endian, as the selector is read
  std::memcpy(&value, scratch, type.size);
  return static_cast<std::int64_t>(value);
}

Value OperatorLowering::select(const Select& what, Scope& scope, const std::string& path,
                               const text::Place& place) {
  using flow::TypeKind;
  const Value by = values_.value_of(*what.by, scope);
  flow::Node node = node_of(path, "", place);
  node.kind = flow::Node::Kind::kSelect;
  const bool is_known = by.kind == Value::Kind::kWire && by.type.type != nullptr;
  const TypeKind kind = is_known ? by.type.type->kind : TypeKind::kOther;
  const bool can_select = kind == TypeKind::kInteger || kind == TypeKind::kChoice ||
                          kind == TypeKind::kBool || kind == TypeKind::kMask;
  if (by.kind == Value::Kind::kWord) {
    binder_.bind(by, types_.named("int"), nullptr, "select", what.by->place);
  } else if (by.kind != Value::Kind::kNone && !can_select) {
    findings_
        .error("wrong-type", what.by->place,
               "a selector is the value of a call: a whole number, a truth value or a choice")
        .label = is_known ? "this is " + flow::value_of(*by.type.type) : "this is a constant";
  }
  node.selector = named(by.text, what.by->place);
  std::vector<Value> members;
  std::map<std::int64_t, text::Place> seen;
  std::optional<text::Place> otherwise;
  for (const Case& one : what.cases) {
    flow::Case code;
    code.place = one.place;
    if (one.values.empty() && otherwise)
      findings_.error("duplicate-case", one.place, "a second `otherwise`")
          .notes.push_back({"the first is here", *otherwise});
    if (one.values.empty()) otherwise = one.place;
    for (const Word& word : one.values) {
      if (!can_select) continue;
      const std::optional<std::int64_t> value = case_value(word, *by.type.type);
      if (!value) continue;
      code.values.push_back(*value);
      const auto [first, is_new] = seen.try_emplace(*value, word.place);
      if (!is_new)
        findings_.error("duplicate-case", word.place, fmt::format("a second case for `{}`", word.text))
            .notes.push_back({"the first is here", first->second});
    }
    members.push_back(values_.value_of(*one.member, scope));
    node.cases.push_back(std::move(code));
  }
  if (what.cases.empty()) {
    findings_.error("no-members", place, "`select` has no cases");
    return {};
  }
  const PortType type = common_type(members, place, "select");
  if (type.type == nullptr) return {};
  node.behavior = std::string(type.type->name);
  for (std::size_t i = 0; i < members.size(); ++i) {
    auto source = binder_.bind(members[i], type, nullptr, "select", what.cases[i].member->place);
    if (source) node.cases[i].member = std::move(*source);
  }
  network_.nodes.push_back(std::move(node));
  return wire(path, type, place);
}

}  // namespace mlab::cdl
