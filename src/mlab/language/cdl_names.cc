// What the names of a configuration stand for.

#include <algorithm>
#include <array>
#include <cctype>

#include "mlab/language/cdl_world.h"

namespace mlab::language {
namespace {

void found_at(Name& out, const CdlWorld::Found& found) {
  if (!found) return;
  out.kind = found.declaration->kind;
  out.target = found.place();
  out.is_library = found.is_library;
}

/// What the designer calls a node: the second `Noise` is `Noise_2`.
std::size_t without_number(std::string_view name) {
  const std::size_t bar = name.rfind('_');
  if (bar == std::string_view::npos || bar == 0 || bar + 1 == name.size()) return name.size();
  const bool is_number =
      std::ranges::all_of(name.substr(bar + 1), [](unsigned char c) { return std::isdigit(c) != 0; });
  return is_number ? bar : name.size();
}

}  // namespace

const CdlDeclaration* CdlWorld::around(const CdlName& name) const {
  if (name.declaration < 0) return nullptr;
  return &own().declarations[static_cast<std::size_t>(name.declaration)];
}

void CdlWorld::resolve_argument(const CdlName& name, Name& out) const {
  if (name.wanted.call < 0) return;
  const Component* const called = component(own().names[static_cast<std::size_t>(name.wanted.call)].text);
  if (called == nullptr) return;
  out.is_library = !called->is_own;
  for (const NameKind kind : {NameKind::kBinding, NameKind::kAssemblage}) {
    const Found found = find(kind, called->name);
    if (!found) continue;
    for (const CdlParameter& parameter : found.declaration->parameters) {
      if (parameter.input.name == name.text) out.target = {found.scan->source, parameter.span};
    }
    return;
  }
}

void CdlWorld::resolve_value(const CdlName& name, Name& out) const {
  const CdlDeclaration* const in = around(name);
  const Variable found = in == nullptr ? Variable{} : variable(*in, name.text);
  if (!found) return;
  out.kind = found.let != nullptr ? NameKind::kLet : NameKind::kParameter;
  out.target = {own().source, found.span()};
}

// A binding point, or a device of the robot's class that is driven by its own name.
void CdlWorld::resolve_binding(const CdlName& name, Name& out) const {
  const CdlDeclaration* const in = around(name);
  if (in != nullptr && in->kind == NameKind::kRobot) {
    if (const Found of = find(NameKind::kClass, in->class_name)) {
      for (const CdlDevice& device : of.declaration->devices) {
        if (device.name != name.text) continue;
        out.kind = NameKind::kDevice;
        out.target = {of.scan->source, device.span};
        out.is_library = of.is_library;
        return;
      }
    }
  }
  if (name.kind == NameKind::kBinding) found_at(out, find(NameKind::kBinding, name.text));
}

// Of a layout: its owner, or what stands in it.
void CdlWorld::resolve_node(const CdlName& name, Name& out) const {
  if (name.owner < 0) {
    Found owner = find(NameKind::kAssemblage, name.text);
    if (!owner) owner = find_member(name.text);
    found_at(out, owner);
    return;
  }
  const std::string& owner_name = own().names[static_cast<std::size_t>(name.owner)].text;
  Found owner = find(NameKind::kAssemblage, owner_name);
  if (!owner) owner = find_member(owner_name);
  if (!owner) return;
  const CdlDeclaration& in = *owner.declaration;
  const std::array<std::string_view, 2> tried = {
      name.text, std::string_view(name.text).substr(0, without_number(name.text))};
  for (const std::string_view text : tried) {
    out.span.end = out.span.begin + static_cast<std::uint32_t>(text.size());
    out.text = text;
    for (const CdlState& state : in.states) {
      if (state.name == text) {
        out.kind = NameKind::kState;
        out.target = {owner.scan->source, state.span};
        return;
      }
    }
    for (const CdlNode& node : in.nodes) {
      if (node.name == text) {
        out.target = {owner.scan->source, node.span};
        return;
      }
    }
    if (const Variable found = variable(in, text)) {
      out.kind = found.let != nullptr ? NameKind::kLet : NameKind::kParameter;
      out.target = {owner.scan->source, found.span()};
      return;
    }
    if (const Component* called = component(text)) {
      out.kind = called->kind == "assemblage" ? NameKind::kAssemblage : NameKind::kProcedure;
      out.target = called->declaration;
      out.is_library = !called->is_own;
      return;
    }
  }
  out.span = name.span;
  out.text = name.text;
}

Name CdlWorld::resolve(const CdlName& name) const {
  Name out{name.span, name.kind, name.is_declaration, name.text, {}, false};
  if (name.is_declaration) {
    out.target = {own().source, name.span};
    return out;
  }
  switch (name.kind) {
    case NameKind::kProcedure:
      if (const Component* called = component(name.text)) {
        out.kind = called->kind == "assemblage" ? NameKind::kAssemblage
                   : called->kind == "binding"  ? NameKind::kBinding
                                                : NameKind::kProcedure;
        out.target = called->declaration;
        out.is_library = !called->is_own;
      }
      break;
    case NameKind::kArgument:
      resolve_argument(name, out);
      break;
    case NameKind::kWord:
      resolve_value(name, out);
      break;
    case NameKind::kState:
      if (const CdlDeclaration* in = around(name)) {
        for (const CdlState& state : in->states) {
          if (state.name == name.text && state.sequence == name.sequence)
            out.target = {own().source, state.span};
        }
      }
      break;
    case NameKind::kClass:
    case NameKind::kOperator:
      found_at(out, find(name.kind, name.text));
      break;
    case NameKind::kRobot:
      found_at(out, find_member(name.text));
      break;
    case NameKind::kBinding:
    case NameKind::kDevice:
      resolve_binding(name, out);
      break;
    case NameKind::kNode:
      resolve_node(name, out);
      break;
    default:
      break;
  }
  return out;
}

std::vector<Name> CdlWorld::names() const {
  std::vector<Name> out;
  out.reserve(own().names.size());
  for (const CdlName& name : own().names) out.push_back(resolve(name));
  for (const CdlName& use : own().uses) {
    Name file{use.span, NameKind::kFile, false, use.text, {}, false};
    for (const CdlScan& scan : scans_) {
      if (&scan != &own() && scan.source->name().ends_with(use.text)) file.target = {scan.source, {0, 0}};
    }
    out.push_back(std::move(file));
  }
  std::ranges::sort(out, {}, [](const Name& name) { return name.span.begin; });
  return out;
}

}  // namespace mlab::language
