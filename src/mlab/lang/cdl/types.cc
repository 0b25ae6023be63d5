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

PortType Types::of_call(const Word& callee, int depth) const {
  if (const auto binding = configuration_.bindings.find(callee.text);
      binding != configuration_.bindings.end())
    return named(binding->second->result_type.text);
  if (const Assemblage* assemblage = configuration_.assemblage_named(callee))
    return result_of(*assemblage, depth);
  return of_call(library_.find(callee.text));
}

PortType Types::result_of(const Assemblage& assemblage, int depth) const {
  if (!assemblage.result_type.text.empty()) return named(assemblage.result_type.text);
  if (!assemblage.body) return named("Vector");
  return of(*assemblage.body, names_of(assemblage.parameters, assemblage.lets), depth + 1);
}

Types::Names Types::names_of(const std::vector<Parameter>& parameters, const std::vector<Let>& lets) const {
  return [&, this](const std::string& name, int depth) -> PortType {
    for (const Let& let : lets) {
      if (let.name.text == name && let.value) return of(*let.value, names_of(parameters, lets), depth + 1);
    }
    for (const Parameter& parameter : parameters) {
      if (parameter.name.text == name) return of(parameter);
    }
    return {};
  };
}

PortType Types::of(const Expression& expression, const Names& names, int depth) const {
  if (depth > kMaxDepth) return {};
  const auto part = [&](const ExpressionPtr& one) { return one ? of(*one, names, depth + 1) : PortType{}; };
  return std::visit(base::Overloaded{
                        [](const Hole&) { return PortType{}; },
                        [&](const Number&) { return named("double"); },
                        [](const Text&) { return PortType{}; },
                        [](const List&) { return PortType{}; },
                        [&](const Name& name) { return names(name.name.text, depth + 1); },
                        [&](const Call& call) { return of_call(call.callee, depth + 1); },
                        [&](const Logic&) { return named("bool"); },
                        [&](const Cooperate&) { return named("Vector"); },
                        [&](const Compete&) { return named("Vector"); },
                        [&](const Coordinate& what) { return of_call(what.by.callee, depth + 1); },
                        [&](const Fuse& what) { return of_call(what.by.callee, depth + 1); },
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
}

}  // namespace mlab::cdl
