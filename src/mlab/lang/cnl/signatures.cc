#include "mlab/lang/cnl/signatures.h"

#include <algorithm>
#include <charconv>

#include <fmt/core.h>

#include "mlab/lang/cnl/alias_signature.h"
#include "mlab/lang/cnl/cpp_writer.h"
#include "mlab/lang/cnl/lexer.h"
#include "mlab/lang/cnl/types.h"

namespace mlab::cnl {
namespace {

flow::Need need_of(const Procedure& procedure, const NeedDecl& decl) {
  flow::Need need;
  if (const percept::SensorInfo* sensor = percept::sensor_named(decl.sensor.text))
    need.sensor = sensor->sensor;
  const auto input =
      std::ranges::find(procedure.inputs, decl.range.text, [](const InputDecl& i) { return i.name.text; });
  if (input != procedure.inputs.end()) {
    need.range_input = static_cast<int>(input - procedure.inputs.begin());
  } else {
    std::from_chars(decl.range.text.data(), decl.range.text.data() + decl.range.text.size(), need.range);
  }
  return need;
}

}  // namespace

Signatures::Signatures(const Tree& tree,
                       const std::function<const flow::TypeInfo*(std::string_view)>& find_type)
    : find_type_(find_type) {
  for (const TypeDecl* decl : items_of<TypeDecl>(tree)) {
    if (find_port_type(decl->name.text)) continue;
    flow::TypeInfo& own = own_types_.emplace_back();
    own.name = keep(decl->name.text);
    own.size = 1;
  }
  for (const Procedure* procedure : items_of<Procedure>(tree)) {
    if (!procedure->is_external) add(*procedure);
  }
}

const flow::TypeInfo* Signatures::type(const Word& name) {
  const auto own = std::ranges::find(own_types_, name.text, &flow::TypeInfo::name);
  if (own != own_types_.end()) return &*own;
  const flow::ValueTypeInfo* known = find_port_type(name.text);
  return find_type_(known ? known->name : std::string_view(name.text));
}

void Signatures::set_state(std::string_view procedure, std::uint32_t size, std::uint32_t alignment,
                           bool has_header) {
  for (Parts& parts : parts_) {
    if (parts.behavior.name != procedure) continue;
    parts.behavior.state_size = size;
    parts.behavior.state_alignment = alignment;
    parts.behavior.has_header = has_header;
  }
}

void Signatures::set_type(std::string_view type, std::uint32_t size, std::uint32_t alignment) {
  const auto own = std::ranges::find(own_types_, type, &flow::TypeInfo::name);
  if (own == own_types_.end()) return;
  own->size = size;
  own->alignment = alignment;
}

void Signatures::add(const Procedure& procedure) {
  Parts& parts = parts_.emplace_back();
  for (const InputDecl& decl : procedure.inputs) {
    flow::Input& input = parts.inputs.emplace_back();
    input.name = keep(decl.name.text);
    input.type = type(decl.type);
    input.unit = keep(decl.unit.text);
    input.help = keep(decl.help);
    input.is_list = decl.is_list;
    if (decl.initial) input.default_text = keep(decl.initial->text);
    if (decl.low) input.min = *decl.low;
    if (decl.high) input.max = *decl.high;
  }
  for (const AliasDecl& alias : procedure.aliases) add_alias(procedure, alias, parts);
  for (const NeedDecl& decl : procedure.needs) parts.needs.push_back(need_of(procedure, decl));
  flow::Behavior& behavior = parts.behavior;
  behavior.name = keep(procedure.name.text);
  behavior.help = keep(procedure.help);
  behavior.source = keep(procedure.source);
  const text::Place& place = procedure.name.place;
  behavior.file = keep(fmt::format("{}:{}", base_name(place.source->name()),
                                   place.source->line_column(place.span.begin).line));
  if (!procedure.is_sink()) behavior.output = type(procedure.output_type);
  behavior.output_unit = keep(procedure.output_unit.text);
  behavior.inputs = parts.inputs;
  behavior.aliases = parts.aliases;
  behavior.needs = parts.needs;
  behavior.is_pure = procedure.is_pure;
  behavior.latency_cycles = procedure.latency.value_or(0);
  behavior.fire = [](flow::Call&) {};
  pointers_.push_back(&behavior);
}

void Signatures::add_alias(const Procedure& procedure, const AliasDecl& alias, Parts& parts) {
  const AliasSignature as = signature_of(procedure, alias);
  auto& ports = parts.ports.emplace_back();
  auto& ignored = parts.ignored.emplace_back();
  for (const auto& [name, unit] : as.inputs) ports.push_back({keep(name), keep(unit)});
  for (const std::string& name : as.ignored) ignored.push_back(keep(name));
  parts.aliases.push_back({keep(alias.name.text), ports, ignored, keep(as.output_unit)});
}

}  // namespace mlab::cnl
