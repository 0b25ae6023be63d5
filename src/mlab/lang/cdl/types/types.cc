#include "mlab/lang/cdl/types/types.h"

#include <algorithm>
#include <variant>

#include "mlab/base/overloaded.h"
#include "mlab/flow/port_types.h"

namespace mlab::cdl {
namespace {

constexpr int kMaxDepth = 64;  // names and calls may go round in circles

// The first of several that has a type, without a unit. Numbers become what the others are.
template <class List, class Part>
PortType first_of(const List& list, Part part) {
  PortType number;
  for (const auto& one : list) {
    PortType type = part(one.member);
    type.unit.clear();
    const bool is_number = one.member && std::holds_alternative<Number>(one.member->what);
    if (type.type != nullptr && !is_number) return type;
    if (is_number) number = type;
  }
  return number;
}

}  // namespace

std::vector<InputView> inputs_of(const flow::Library::Entry& entry) {
  std::vector<InputView> out;
  if (entry.behavior == nullptr) return out;
  const auto& inputs = entry.behavior->inputs;
  out.reserve(inputs.size());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const bool is_renamed = entry.alias != nullptr && i < entry.alias->inputs.size();
    const std::string_view name = is_renamed ? entry.alias->inputs[i].name : inputs[i].name;
    const std::string_view unit =
        is_renamed && !entry.alias->inputs[i].unit.empty() ? entry.alias->inputs[i].unit : inputs[i].unit;
    if (name.empty()) continue;
    out.push_back(
        {std::string(name.substr(0, name.find('|'))), {inputs[i].type, std::string(unit)}, &inputs[i]});
  }
  return out;
}

std::vector<InputView> inputs_of(const Function& function, const flow::Library& library) {
  std::vector<InputView> out;
  const flow::Behavior* behavior = library.find(function.behavior).behavior;
  for (std::size_t i = 0; i < function.inputs.size(); ++i) {
    const bool is_explained = behavior != nullptr && i < behavior->inputs.size();
    InputView view{
        std::string(function.inputs[i]), {}, is_explained ? &behavior->inputs[i] : nullptr, nullptr};
    if (is_explained && function.name != "distance") view.type.type = behavior->inputs[i].type;
    if (function.name == kPlaceFunction) view.type.type = library.find_type("Text");
    out.push_back(std::move(view));
  }
  return out;
}

void settle_lists(std::vector<PortType>& operands, const std::vector<bool>& is_list) {
  const bool are_points = std::ranges::any_of(operands, [](const PortType& type) {
    return type.type != nullptr && type.type->kind == flow::TypeKind::kPoint;
  });
  const flow::TypeInfo& type = are_points ? flow::type_info<geom::Point>() : flow::type_info<geom::Vector>();
  for (std::size_t i = 0; i < operands.size(); ++i) {
    if (is_list[i] && operands[i].type == nullptr) operands[i] = {&type, ""};
  }
}

std::vector<std::string> type_names() {
  std::vector<std::string> names;
  for (const flow::ValueTypeInfo& type : flow::kValueTypes) names.emplace_back(type.name);
  for (const flow::QuantityInfo& quantity : flow::kQuantities) names.emplace_back(quantity.name);
  return names;
}

PortType Types::named(std::string_view type) const {
  if (const flow::QuantityInfo* quantity = flow::quantity_named(type))
    return {library_.find_type(flow::info(quantity->type).name), std::string(quantity->unit)};
  return {library_.find_type(type), ""};
}

PortType Types::of(const Parameter& parameter) const {
  PortType out = named(parameter.type.text);
  if (!parameter.unit.text.empty()) out.unit = parameter.unit.text;
  return out;
}

PortType Types::of_call(const flow::Library::Entry& entry) const {
  if (entry.behavior == nullptr) return {};
  const bool has_own_unit = entry.alias != nullptr && !entry.alias->output_unit.empty();
  return {entry.behavior->output,
          std::string(has_own_unit ? entry.alias->output_unit : entry.behavior->output_unit)};
}

PortType Types::of_call(const Word& callee) const {
  Question question;
  return of_call(callee, question);
}

PortType Types::of_call(const Word& callee, Question& question) const {
  if (const auto binding = configuration_.bindings.find(callee.text);
      binding != configuration_.bindings.end())
    return named(binding->second->result_type.text);
  if (const Assemblage* assemblage = configuration_.assemblage_named(callee))
    return result_of(*assemblage, question);
  return of_call(library_.find(callee.text));
}

const Function* Types::function(const Word& callee) const {
  const Function* out = function_named(callee.text);
  if (out == nullptr) return nullptr;
  const bool is_hidden = configuration_.bindings.contains(callee.text) ||
                         configuration_.assemblage_named(callee) != nullptr ||
                         library_.find(callee.text).behavior != nullptr;
  return is_hidden ? nullptr : out;
}

bool Types::is_sink(const Word& callee) const {
  const flow::Behavior* behavior = library_.find(callee.text).behavior;
  return behavior != nullptr && behavior->output == nullptr;
}

std::vector<InputView> Types::inputs_of(const Word& callee) const {
  const auto of_parameters = [this](const std::vector<Parameter>& parameters) {
    std::vector<InputView> out;
    for (const Parameter& parameter : parameters)
      out.push_back({parameter.name.text, of(parameter), nullptr, &parameter});
    return out;
  };
  if (const auto binding = configuration_.bindings.find(callee.text);
      binding != configuration_.bindings.end())
    return of_parameters(binding->second->parameters);
  if (const Assemblage* assemblage = configuration_.assemblage_named(callee))
    return of_parameters(assemblage->parameters);
  if (const Function* known = function(callee)) return cdl::inputs_of(*known, library_);
  return cdl::inputs_of(library_.find(callee.text));
}

PortType Types::result_of(const Assemblage& assemblage) const {
  Question question;
  return result_of(assemblage, question);
}

PortType Types::result_of(const Assemblage& assemblage, Question& question) const {
  if (!assemblage.result_type.text.empty()) return named(assemblage.result_type.text);
  if (!assemblage.body) return named("Vector");
  const auto [at, is_new] = question.known.try_emplace(&assemblage);
  if (!is_new) return at->second;
  const PortType type = of(*assemblage.body, names_of(assemblage.parameters, assemblage.lets), question);
  return question.known[&assemblage] = type;
}

Types::Names Types::names_of(const std::vector<Parameter>& parameters, const std::vector<Let>& lets) const {
  return [&, this](const std::string& name, Question& question) -> PortType {
    for (const Let& let : lets) {
      if (let.name.text == name && let.value) return of(let, names_of(parameters, lets), question);
    }
    for (const Parameter& parameter : parameters) {
      if (parameter.name.text == name) return of(parameter);
    }
    return {};
  };
}

PortType Types::of(const Let& let, const Names& names, Question& question) const {
  const auto [at, is_new] = question.known.try_emplace(&let);
  if (!is_new) return at->second;
  const PortType type = of(*let.value, names, question);
  return question.known[&let] = type;
}

PortType Types::of_operand(const Expression& operand, const Names& names, Question& question) const {
  PortType out = of(operand, names, question);
  if (const auto* number = std::get_if<Number>(&operand.what)) out.unit = number->unit.text;
  return out;
}

PortType Types::of_arithmetic(const Arithmetic& arithmetic, const Names& names, Question& question) const {
  std::vector<PortType> operands;
  std::vector<bool> is_list;
  for (const ExpressionPtr& operand : arithmetic.operands) {
    operands.push_back(of_operand(*operand, names, question));
    is_list.push_back(std::holds_alternative<List>(operand->what));
  }
  settle_lists(operands, is_list);
  if (operands.empty() || arithmetic.operations.empty()) return {};
  if (arithmetic.operations.front() == Operation::kNegate)
    return computation(Operation::kNegate, std::span(operands).first(1)).type;
  PortType left = operands.front();
  for (std::size_t i = 1; i < operands.size(); ++i)
    left = computation(arithmetic.operations[i - 1], std::vector{left, operands[i]}).type;
  return left;
}

PortType Types::of_function(const Function& function, const Call& call, const Names& names,
                            Question& question) const {
  std::vector<PortType> operands;
  std::vector<bool> is_list;
  for (const Argument& argument : call.arguments) {
    operands.push_back(argument.value ? of_operand(*argument.value, names, question) : PortType{});
    is_list.push_back(argument.value && std::holds_alternative<List>(argument.value->what));
  }
  settle_lists(operands, is_list);
  return computation(function, operands).type;
}

PortType Types::of(const Expression& expression, const Names& names) const {
  Question question;
  return of(expression, names, question);
}

PortType Types::of(const Expression& expression, const Names& names, Question& question) const {
  if (question.depth > kMaxDepth) return {};
  ++question.depth;
  const auto part = [&](const ExpressionPtr& one) { return one ? of(*one, names, question) : PortType{}; };
  PortType out = std::visit(base::Overloaded{
                                [](const Hole&) { return PortType{}; },
                                [&](const Number&) { return named("double"); },
                                [](const Text&) { return PortType{}; },
                                [](const List&) { return PortType{}; },
                                [&](const Name& name) { return names(name.name.text, question); },
                                [&](const Call& call) {
                                  const Function* known = function(call.callee);
                                  return known == nullptr ? of_call(call.callee, question)
                                                          : of_function(*known, call, names, question);
                                },
                                [&](const Logic&) { return named("bool"); },
                                [&](const Arithmetic& what) { return of_arithmetic(what, names, question); },
                                [&](const Cooperate&) { return named("Vector"); },
                                [&](const Compete&) { return named("Vector"); },
                                [&](const Coordinate& what) { return of_call(what.by.callee, question); },
                                [&](const Fuse& what) { return of_call(what.by.callee, question); },
                                [&](const Sequence& what) { return first_of(what.states, part); },
                                [&](const Select& what) { return first_of(what.cases, part); },
                                [&](const Delay& what) {
                                  PortType type = part(what.value);
                                  if (type.type == nullptr) type = part(what.initial);
                                  type.unit.clear();
                                  return type;
                                },
                            },
                            expression.what);
  --question.depth;
  return out;
}

}  // namespace mlab::cdl
