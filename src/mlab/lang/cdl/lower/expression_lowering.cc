#include "mlab/lang/cdl/lower/expression_lowering.h"

#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/base/overloaded.h"
#include "mlab/flow/port_types.h"
#include "mlab/flow/type_words.h"
#include "mlab/lang/cdl/lower/naming.h"
#include "mlab/lang/cdl/types/units.h"

namespace mlab::cdl {

Value ExpressionLowering::value_of(const Expression& expression, Scope& scope) {
  if (depth_ > kDeepestExpression) {
    findings_.error("nested-too-deep", expression.place,
                    fmt::format("calls stand more than {} deep in each other", kDeepestExpression));
    return {};
  }
  ++depth_;
  const NodeNames::Paths& paths = scope.paths_of(expression);
  Value out = expression.active ? active(expression, scope, paths) : passive(expression, scope, paths.inside);
  --depth_;
  return out;
}

Value ExpressionLowering::passive(const Expression& expression, Scope& scope, const std::string& inside) {
  const text::Place& place = expression.place;
  const std::string path = scope.path_of(inside);
  return std::visit(
      base::Overloaded{
          [](const Hole&) { return Value{}; },
          [&](const Number& number) { return this->number(number, place); },
          [&](const Text& text) {
            Value out;
            out.kind = Value::Kind::kText;
            out.text = text.value;
            out.place = place;
            return out;
          },
          [&](const Name& name) { return this->name(name, scope, place); },
          [&](const List& list) { return this->list(list, scope, place); },
          [&](const Call& call) { return this->call(expression, call, scope, path); },
          [&](const Logic& logic) { return this->logic(logic, scope, path, place); },
          [&](const Arithmetic& what) { return arithmetic_.operations(expression, what, scope, path); },
          [&](const Cooperate& what) { return operators_.cooperate(what, scope, path, place); },
          [&](const Compete& what) { return operators_.compete(what, scope, path, place); },
          [&](const Coordinate& what) {
            return operators_.generic(what.by, what.members, scope, path, place);
          },
          [&](const Fuse& what) { return operators_.generic(what.by, what.members, scope, path, place); },
          [&](const Sequence& what) { return operators_.sequence(what, scope, path, place); },
          [&](const Select& what) { return operators_.select(what, scope, path, place); },
          [&](const Delay& what) { return this->delay(what, scope, path, place); },
      },
      expression.what);
}

Value ExpressionLowering::number(const Number& number, const text::Place& place) {
  Value out;
  if (!number.unit.text.empty() && !unit_named(number.unit.text)) {
    text::Diagnostic& d = findings_.error("unknown-unit", number.unit.place,
                                          fmt::format("unknown unit `{}`", number.unit.text));
    Findings::hint_nearest(d, number.unit.text, unit_names());
    if (d.hints.empty()) d.hints.push_back(fmt::format("there are {}", fmt::join(unit_names(), ", ")));
    return out;
  }
  out.kind = Value::Kind::kNumber;
  out.number = number.value;
  out.unit = number.unit.text;
  out.place = place;
  return out;
}

Value ExpressionLowering::call(const Expression& expression, const Call& call, Scope& scope,
                               const std::string& path) {
  if (const Function* function = types_.function(call.callee))
    return arithmetic_.function(expression, call, *function, scope, path);
  return calls_.call(call, scope, {path, &scope.nodes->below(expression)}, expression.place);
}

Value ExpressionLowering::name(const Name& name, Scope& scope, const text::Place& place) {
  const auto known = scope.names.find(name.name.text);
  if (known == scope.names.end()) {
    Value out;
    out.kind = Value::Kind::kWord;
    out.text = name.name.text;
    out.place = place;
    out.scope = &scope;
    return out;
  }
  Value out = known->second.let == nullptr ? known->second.value : value_of(known->second, scope);
  out.named = name.name.text;
  out.declared = known->second.let == nullptr ? out.place : known->second.let->name.place;
  return out;
}

// A name that is asked for while it is being read closes a loop. Its node will have this path; whether a
// delay breaks the loop, the program builder tells.
Value ExpressionLowering::value_of(Scope::Named& named, Scope& scope) {
  using Progress = Scope::Named::State;
  const Let& let = *named.let;
  if (named.state == Progress::kReady) return named.value;
  if (named.state == Progress::kOpen) {
    named.was_promised = true;
    return wire(scope.path_of(scope.nodes->of(let)), types_.of(*let.value, types_in(scope)), let.name.place);
  }
  named.state = Progress::kOpen;
  const std::string path = scope.path_of(scope.nodes->of(let));
  Value value = value_of(*let.value, scope);
  named.state = Progress::kReady;
  // What comes round to its own name has made no node of it, unless it is one.
  const bool is_other = value.text != path || std::holds_alternative<Name>(let.value->what);
  if (named.was_promised && value.kind != Value::Kind::kNone && is_other) {
    findings_.error("dataflow-loop", let.name.place, fmt::format("`{}` is defined by itself", let.name.text));
    value = {};
  }
  named.value = std::move(value);
  return named.value;
}

Value ExpressionLowering::list(const List& list, Scope& scope, const text::Place& place) {
  Value out;
  out.kind = Value::Kind::kList;
  out.place = place;
  for (const ExpressionPtr& item : list.items) {
    Value value = value_of(*item, scope);
    value.place = item->place;
    out.items.push_back(std::move(value));
  }
  return out;
}

Value ExpressionLowering::logic(const Logic& logic, Scope& scope, const std::string& path,
                                const text::Place& place) {
  const PortType type{&flow::type_info<bool>(), ""};
  const char* callee = logic.connective == Connective::kNot   ? "Not"
                       : logic.connective == Connective::kAnd ? "And"
                                                              : "Or";
  std::vector<flow::Source> operands;
  for (const ExpressionPtr& operand : logic.operands) {
    const Value value = value_of(*operand, scope);
    const auto source = binder_.bind(value, type, nullptr, callee, operand->place);
    if (source) operands.push_back(*source);
  }
  if (operands.size() < logic.operands.size() || operands.empty()) return {};
  // `a and b and c` is (a and b) and c.
  flow::Source left = operands.front();
  for (std::size_t i = logic.connective == Connective::kNot ? 0 : 1; i < operands.size(); ++i) {
    flow::Node node;
    const bool is_last = i + 1 == operands.size();
    node.name = is_last ? path : scope.path_behind(*logic.operands[i]);
    node.behavior = callee;
    node.place = node.behavior_place = place;
    node.links.push_back({"a", left, left.place});
    if (logic.connective != Connective::kNot) node.links.push_back({"b", operands[i], operands[i].place});
    left = {flow::Source::Kind::kName, node.name, place};
    network_.nodes.push_back(std::move(node));
  }
  return wire(path, type, place);
}

Value ExpressionLowering::delay(const Delay& delay, Scope& scope, const std::string& path,
                                const text::Place& place) {
  const Value value = value_of(*delay.value, scope);
  const Value initial = delay.initial ? value_of(*delay.initial, scope) : Value{};
  PortType type = value.type.type != nullptr ? value.type : initial.type;
  if (value.kind == Value::Kind::kNone || (delay.initial && initial.kind == Value::Kind::kNone)) return {};
  if (type.type == nullptr) {
    findings_.error("unknown-type", place, "what type this has can't be told").hints = {
        "a delay takes the value of a call or of a name"};
    return {};
  }
  type.unit.clear();
  flow::Node node;
  node.kind = flow::Node::Kind::kDelay;
  node.name = path;
  node.behavior = std::string(type.type->name);
  node.place = node.behavior_place = place;
  const auto source = binder_.bind(value, type, nullptr, "value", delay.value->place);
  if (!source) return {};
  node.links.push_back({"value", *source, delay.value->place});
  if (delay.initial) {
    const auto first = binder_.bind(initial, type, nullptr, "initial", delay.initial->place);
    if (!first) return {};
    node.links.push_back({"initial", *first, delay.initial->place});
  }
  network_.nodes.push_back(std::move(node));
  return wire(path, type, place);
}

// The active part has to run whenever the value is wanted, and only then: it selects the only case there is.
Value ExpressionLowering::active(const Expression& expression, Scope& scope, const NodeNames::Paths& paths) {
  const std::string path = scope.path_of(paths.path);
  const Value value = passive(expression, scope, paths.inside);
  Value part = value_of(*expression.active, scope);
  if (value.kind == Value::Kind::kNone || part.kind == Value::Kind::kNone) return {};
  if (value.kind != Value::Kind::kWire || value.type.type == nullptr) {
    findings_.error("wrong-type", expression.place, "only a behavior or a percept has an active part");
    return {};
  }
  if (part.kind != Value::Kind::kWire || part.type.type == nullptr) {
    findings_.error("wrong-type", expression.active->place, "an active part is a call that moves a sensor");
    return {};
  }
  if (part.type.type->kind == flow::TypeKind::kVector) {
    flow::Node node;
    node.name = scope.path_behind(*expression.active);
    node.behavior = "IsZero";
    node.place = node.behavior_place = expression.active->place;
    node.links.push_back({"v", {flow::Source::Kind::kName, part.text, part.place}, expression.active->place});
    part = wire(node.name, {&flow::type_info<bool>(), ""}, part.place);
    network_.nodes.push_back(std::move(node));
  }
  if (part.type.type->kind != flow::TypeKind::kBool && part.type.type->kind != flow::TypeKind::kInteger) {
    findings_
        .error("wrong-type", expression.active->place,
               fmt::format("an active part gives a truth value or a Vector; this is {}",
                           flow::value_of(*part.type.type)))
        .hints = {"`LookAt(...)` and `LookAround(...)` turn a camera"};
    return {};
  }
  flow::Node node;
  node.kind = flow::Node::Kind::kSelect;
  node.name = path;
  node.behavior = std::string(value.type.type->name);
  node.place = node.behavior_place = expression.place;
  node.selector = {flow::Source::Kind::kName, part.text, expression.active->place};
  node.cases.push_back({{}, {flow::Source::Kind::kName, value.text, expression.place}, expression.place});
  network_.nodes.push_back(std::move(node));
  return wire(path, value.type, expression.place);
}

// What the names of a scope stand for, without making anything of them: for what is not there yet.
Types::Names ExpressionLowering::types_in(const Scope& scope) const {
  return [&, this](const std::string& name, Types::Question& question) -> PortType {
    const auto known = scope.names.find(name);
    if (known == scope.names.end()) return {};
    const Scope::Named& named = known->second;
    if (named.let != nullptr && named.state != Scope::Named::State::kReady)
      return types_.of(*named.let, types_in(scope), question);
    return named.value.type;
  };
}

}  // namespace mlab::cdl
