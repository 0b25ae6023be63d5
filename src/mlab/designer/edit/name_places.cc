#include "mlab/designer/edit/name_places.h"

#include "mlab/designer/drawing/serving.h"
#include "mlab/designer/edit/find/declared.h"

namespace mlab::designer {
namespace {

using MaybePlace = std::optional<std::uint32_t>;

MaybePlace begin_of(const cdl::Word& word) {
  return word.text.empty() || !word.place.source ? MaybePlace() : word.place.span.begin;
}

MaybePlace component_of(const cdl::Expression* expression) {
  const auto* call = expression == nullptr ? nullptr : std::get_if<cdl::Call>(&expression->what);
  return call == nullptr ? MaybePlace() : begin_of(call->callee);
}

MaybePlace declaration_place(const Model& model, std::string_view name) {
  MaybePlace out;
  visit_declaration(model.tree(), name, [&](const auto& one) { out = begin_of(one.name); });
  return out;
}

MaybePlace member_place(const cdl::SocietyMember& member, std::string_view name) {
  if (member.name.text == name) return begin_of(member.name);
  for (const cdl::SocietyMember& one : member.members) {
    if (const MaybePlace found = member_place(one, name)) return found;
  }
  return std::nullopt;
}

MaybePlace parameter_place(const std::vector<cdl::Parameter>& parameters, std::string_view name) {
  for (const cdl::Parameter& parameter : parameters) {
    if (parameter.name.text == name) return begin_of(parameter.name);
  }
  return std::nullopt;
}

// What an operator serves is called by its binding point.
MaybePlace device_place(const Equipped& owner, std::string_view name, bool of_component) {
  const cdl::Device* device = owner.device(name);
  if (device != nullptr && of_component) return begin_of(device->by.callee);
  if (owner.robot_class == nullptr) return std::nullopt;
  return device != nullptr ? begin_of(device->name) : parameter_place(owner.robot_class->parameters, name);
}

MaybePlace node_place(const GraphNode& node, bool of_component) {
  if (of_component) return component_of(node.expression);
  if (node.parameter != nullptr) return begin_of(node.parameter->name);
  if (node.let != nullptr) return begin_of(node.let->name);
  if (node.drive != nullptr) return begin_of(node.drive->binding);
  return node.expression == nullptr ? MaybePlace() : begin_of(node.expression->as);
}

}  // namespace

std::optional<std::uint32_t> name_place(const Model& model, const NameAt& at) {
  if (at.page().empty()) return declaration_place(model, at.node());
  if (const cdl::Society* society = model.society(at.page()); society != nullptr && !at.node().empty())
    return member_place(society->what, at.node());
  if (at.node().empty()) return declaration_place(model, owner_of(at.page()));
  if (const Equipped owner = equipped(model, at.page()))
    return device_place(owner, at.node(), at.of_component());
  if (const cdl::Binding* binding = model.binding(at.page()); binding != nullptr)
    return parameter_place(binding->parameters, at.node());
  const Model::FoundPage found = model.page(at.page());
  if (found.graph == nullptr || found.page < 0) return std::nullopt;
  const GraphPage& page = found.graph->pages[static_cast<std::size_t>(found.page)];
  if (page.sequence != nullptr) {
    for (const cdl::State& state : page.sequence->states) {
      if (state.name.text == at.node())
        return at.of_component() ? component_of(state.member.get()) : begin_of(state.name);
    }
  }
  if (const int node = page.find(at.node()); node >= 0)
    return node_place(page.nodes[static_cast<std::size_t>(node)], at.of_component());
  return parameter_place(found.graph->parameters(), at.node());
}

}  // namespace mlab::designer
