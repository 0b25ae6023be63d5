// What the names of a configuration stand for.

#include <algorithm>
#include <array>
#include <cctype>

#include "mlab/assist/cdl_world.h"

namespace mlab::assist {
namespace {

void found_at(Name& out, const CdlWorld::FoundDeclaration& found) {
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

/// What the part of a drawing shows that a name of a layout stands on: the inside of the state or node that
/// the path before it ends at (`Keep` of `layout Go.Keep { ... }`), or all of its owner.
class LayoutPage {
 public:
  /// A state, or a node with a name.
  struct Part {
    std::string_view name;
    text::Span name_span;
    text::Span whole;
    bool is_state = false;

    bool has(text::Span other) const {
      return whole.begin <= other.begin && other.end <= whole.end && other.begin != name_span.begin;
    }
  };

  LayoutPage(const CdlDeclaration& owner, const CdlScan& scan, const CdlName& name) {
    for (const CdlState& one : owner.states) parts_.push_back({one.name, one.span, one.whole, true});
    for (const CdlNode& one : owner.nodes)
      parts_.push_back({one.name, one.span, one.value->place.span, false});
    std::vector<const CdlName*> path;
    for (int at = name.before; at >= 0 && at != name.owner && path.size() < kLongestPath;) {
      path.push_back(&scan.names[static_cast<std::size_t>(at)]);
      at = path.back()->before;
    }
    for (auto one = path.rbegin(); one != path.rend(); ++one) {
      if (const auto part = find((*one)->text)) inside_ = part;
    }
  }

  /// On the page itself, not inside of something else there.
  std::optional<Part> find(std::string_view name) const {
    for (const Part& one : parts_) {
      if (one.name != name || !is_on_page(one)) continue;
      const bool is_deeper = std::ranges::any_of(
          parts_, [&](const Part& other) { return is_on_page(other) && other.has(one.name_span); });
      if (!is_deeper) return one;
    }
    return std::nullopt;
  }

  /// Also where the path does not lead to.
  std::optional<Part> find_anywhere(std::string_view name) const {
    const auto found = std::ranges::find(parts_, name, &Part::name);
    return found == parts_.end() ? std::nullopt : std::optional(*found);
  }

 private:
  static constexpr std::size_t kLongestPath = 16;

  bool is_on_page(const Part& one) const { return !inside_ || inside_->has(one.name_span); }

  std::vector<Part> parts_;
  std::optional<Part> inside_;
};

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
    const FoundDeclaration found = find(kind, called->name);
    if (!found) continue;
    for (const CdlParameter& parameter : found.declaration->parameters) {
      if (parameter.input.name == name.text) out.target = {found.scan->source, parameter.span};
    }
    return;
  }
  if (const ComponentInput* const input = find_input(*called, name.text)) out.target = input->declaration;
}

void CdlWorld::resolve_value(const CdlName& name, Name& out) const {
  const CdlDeclaration* const in = around(name);
  const Variable found = in == nullptr ? Variable{} : variable(*in, name.text);
  if (!found || (found.let != nullptr && found.let->is_subject)) return;
  out.kind = found.let != nullptr ? NameKind::kLet : NameKind::kParameter;
  out.target = {own().source, found.span()};
}

// Of a test: in what it tests.
void CdlWorld::resolve_tested_state(const CdlName& name, Name& out) const {
  const FoundDeclaration tested =
      find(NameKind::kAssemblage, own().names[static_cast<std::size_t>(name.owner)].text);
  if (!tested) return;
  for (const CdlState& state : tested.declaration->states) {
    if (state.name != name.text) continue;
    out.target = {tested.scan->source, state.span};
    out.is_library = tested.is_library;
    return;
  }
}

// A binding point, or a device of the robot's class that is driven by its own name.
void CdlWorld::resolve_binding(const CdlName& name, Name& out) const {
  const CdlDeclaration* const in = around(name);
  if (in != nullptr && in->kind == NameKind::kRobot) {
    if (const FoundDeclaration of = find(NameKind::kClass, in->class_name)) {
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
    FoundDeclaration owner = find(NameKind::kAssemblage, name.text);
    if (!owner) owner = find_member(name.text);
    found_at(out, owner);
    return;
  }
  const std::string& owner_name = own().names[static_cast<std::size_t>(name.owner)].text;
  FoundDeclaration owner = find(NameKind::kAssemblage, owner_name);
  if (!owner) owner = find_member(owner_name);
  if (!owner) return;
  const CdlDeclaration& in = *owner.declaration;
  const LayoutPage page(in, own(), name);
  const std::array<std::string_view, 2> tried = {
      name.text, std::string_view(name.text).substr(0, without_number(name.text))};
  for (const std::string_view text : tried) {
    out.span.end = out.span.begin + static_cast<std::uint32_t>(text.size());
    out.text = text;
    const auto take = [&](const LayoutPage::Part& part) {
      if (part.is_state) out.kind = NameKind::kState;
      out.target = {owner.scan->source, part.name_span};
    };
    if (const auto part = page.find(text)) {
      take(*part);
      return;
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
    if (const auto part = page.find_anywhere(text)) {
      take(*part);
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
      if (name.owner >= 0) {
        resolve_tested_state(name, out);
      } else if (const CdlDeclaration* in = around(name)) {
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

}  // namespace mlab::assist
