#include "mlab/lang/cdl/types.h"

#include <variant>

#include "mlab/base/overloaded.h"
#include "mlab/lang/cdl/quantities.h"

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

PortType Types::named(std::string_view type) const {
  if (const Quantity* quantity = quantity_named(type))
    return {library_.find_type(quantity->type), std::string(quantity->unit)};
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
                                [&](const Call& call) { return of_call(call.callee, question); },
                                [&](const Logic&) { return named("bool"); },
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
