#include "mlab/lang/cdl_historic/vocabulary.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "mlab/flow/value_types.h"
#include "mlab/lang/cdl/syntax/walk.h"
#include "mlab/lang/cdl/types/units.h"

namespace mlab::cdl_historic {
namespace {

// A bound of a parameter, counted as constants of it are.
double in_unit(const cdl::Number& bound, const std::string& unit) {
  const auto from = cdl::unit_named(bound.unit.text);
  const auto to = cdl::unit_named(unit);
  if (bound.unit.text.empty() || !from || !to) return bound.value;
  return cdl::converted(bound.value, *from, *to).value_or(bound.value);
}

constexpr int kMaxBodyDepth = 50;  // of calls in calls, when the type of a body is looked for

template <class Map>
auto found(const Map& map, std::string_view name) -> const typename Map::mapped_type* {
  const auto it = map.find(name);
  return it == map.end() ? nullptr : &it->second;
}

template <class T>
const T* found_pointer(const std::map<std::string, const T*, std::less<>>& map, std::string_view name) {
  const auto it = map.find(name);
  return it == map.end() ? nullptr : it->second;
}

// `a|b`: both names mean the port.
void add_names(HistoricSignature& into, std::string_view names,
               const HistoricSignature::PortMapping& renamed) {
  while (!names.empty()) {
    const std::size_t bar = names.find('|');
    into.ports.emplace(names.substr(0, bar), renamed);
    names = bar == std::string_view::npos ? std::string_view{} : names.substr(bar + 1);
  }
}

HistoricSignature historic_signature(const Signature& signature, const flow::Alias* alias) {
  HistoricSignature out{&signature, {}};
  for (std::size_t i = 0; i < signature.ports.size(); ++i) {
    const Port& port = signature.ports[i];
    if (alias != nullptr && i < alias->inputs.size()) {
      add_names(out, alias->inputs[i].name, {&port, std::string(alias->inputs[i].unit)});
    } else {
      add_names(out, port.name, {&port, {}});
    }
  }
  if (alias != nullptr) {
    for (const std::string_view ignored : alias->ignored_inputs)
      out.ports.emplace(ignored, HistoricSignature::PortMapping{});
  }
  return out;
}

}  // namespace

const Port* Signature::find(std::string_view port) const {
  const auto it = std::ranges::find(ports, port, &Port::name);
  return it == ports.end() ? nullptr : &*it;
}

Vocabulary::Vocabulary(const flow::Library& procedures,
                       std::span<const std::shared_ptr<const cdl::Tree>> library)
    : procedures_(procedures) {
  for (const std::shared_ptr<const cdl::Tree>& tree : library) {
    for (const cdl::Item& item : tree->items) {
      if (const auto* a = std::get_if<cdl::Assemblage>(&item)) assemblages_.emplace(a->name.text, a);
      if (const auto* c = std::get_if<cdl::RobotClass>(&item)) classes_.emplace(c->name.text, c);
      if (const auto* b = std::get_if<cdl::Binding>(&item)) bindings_.emplace(b->name.text, b);
    }
  }
  add_procedures();
  for (const auto& [name, assemblage] : assemblages_) add(*assemblage);
  for (int i = 0; i < kMaxBodyDepth && narrow_all(); ++i) {
  }
  for (const auto& [name, assemblage] : assemblages_) {
    for (const cdl::Word& historic : assemblage->historic_names) {
      aliased_.emplace(historic.text, &signatures_.at(name));
      historic_.emplace(historic.text, historic_signature(signatures_.at(name), nullptr));
    }
  }
}

// A parameter that is handed on takes what those take that it is handed to. True where something changed.
bool Vocabulary::narrow_all() {
  bool has_changed = false;
  for (const auto& [name, assemblage] : assemblages_) {
    Signature& signature = signatures_.at(name);
    const auto narrow = [&](const cdl::Expression& expression) {
      cdl::for_each_expression(expression, [&](const cdl::Expression& part) {
        if (const auto* call = std::get_if<cdl::Call>(&part.what)) has_changed |= narrowed(signature, *call);
      });
    };
    if (assemblage->body != nullptr) narrow(*assemblage->body);
    for (const cdl::Let& let : assemblage->lets) {
      if (let.value != nullptr) narrow(*let.value);
    }
  }
  return has_changed;
}

bool Vocabulary::narrowed(Signature& outer, const cdl::Call& call) const {
  const Signature* callee = find(call.callee.text);
  if (callee == nullptr) return false;
  bool has_changed = false;
  for (std::size_t i = 0; i < call.arguments.size(); ++i) {
    const cdl::Argument& argument = call.arguments[i];
    const auto* said = argument.value == nullptr ? nullptr : std::get_if<cdl::Name>(&argument.value->what);
    const Port* into = !argument.name.text.empty() ? callee->find(argument.name.text)
                       : i < callee->ports.size()  ? &callee->ports[i]
                                                   : nullptr;
    if (said == nullptr || into == nullptr) continue;
    for (Port& port : outer.ports) {
      if (port.name != said->name.text || (into->min <= port.min && into->max >= port.max)) continue;
      port.min = std::max(port.min, into->min);
      port.max = std::min(port.max, into->max);
      has_changed = true;
    }
  }
  return has_changed;
}

void Vocabulary::add_procedures() {
  for (const flow::Behavior* behavior : procedures_.behaviors()) {
    Signature signature{std::string(behavior->name),
                        {},
                        behavior->output == nullptr ? "" : std::string(behavior->output->name)};
    for (const flow::Input& input : behavior->inputs) {
      signature.ports.push_back(
          {std::string(input.name), std::string(input.type->name), std::string(input.unit), input.is_list,
           input.default_text.empty() && !input.is_list, nullptr, input.min, input.max});
    }
    signatures_[signature.name] = std::move(signature);
  }
  for (const std::string& alias : procedures_.names()) {
    const flow::Library::Entry entry = procedures_.find(alias);
    if (entry.behavior == nullptr) continue;
    historic_.emplace(alias,
                      historic_signature(signatures_.at(std::string(entry.behavior->name)), entry.alias));
  }
}

void Vocabulary::add(const cdl::Assemblage& assemblage) {
  Signature signature{assemblage.name.text, {}, type(assemblage.result_type.text)};
  if (assemblage.result_type.text.empty() && assemblage.body != nullptr) {
    signature.result = result_of(*assemblage.body, 0);
  }
  for (const cdl::Parameter& p : assemblage.parameters) {
    const std::string unit = p.unit.text.empty() && p.type.text == "angle" ? "rad" : p.unit.text;
    Port port{p.name.text, type(p.type.text), unit, false, p.initial == nullptr, p.initial};
    if (p.low) port.min = in_unit(*p.low, unit);
    if (p.high) port.max = in_unit(*p.high, unit);
    signature.ports.push_back(std::move(port));
  }
  signatures_[signature.name] = std::move(signature);
}

// What a body gives, as far as the importer needs it: it only has to tell movements, triggers and percepts
// apart.
std::string Vocabulary::result_of(const cdl::Expression& body, int depth) const {
  if (depth > kMaxBodyDepth) return {};
  if (std::holds_alternative<cdl::Logic>(body.what)) return "bool";
  if (std::holds_alternative<cdl::Cooperate>(body.what) || std::holds_alternative<cdl::Compete>(body.what))
    return "Vector";
  if (const auto* sequence = std::get_if<cdl::Sequence>(&body.what)) {
    return sequence->states.empty() || sequence->states[0].member == nullptr
               ? "Vector"
               : result_of(*sequence->states[0].member, depth + 1);
  }
  if (const auto* select = std::get_if<cdl::Select>(&body.what)) {
    return select->cases.empty() || select->cases[0].member == nullptr
               ? ""
               : result_of(*select->cases[0].member, depth + 1);
  }
  if (const auto* called = std::get_if<cdl::Call>(&body.what)) {
    if (const Signature* known = find(called->callee.text); known != nullptr && !known->result.empty())
      return known->result;
    const cdl::Assemblage* other = found_pointer(assemblages_, called->callee.text);
    if (other == nullptr) return {};
    if (!other->result_type.text.empty()) return type(other->result_type.text);
    return other->body == nullptr ? std::string{} : result_of(*other->body, depth + 1);
  }
  return {};
}

const Signature* Vocabulary::find(std::string_view name) const {
  return found(signatures_, name);
}
const HistoricSignature* Vocabulary::find_historic(std::string_view name) const {
  return found(historic_, name);
}
const Signature* Vocabulary::find_assemblage(std::string_view historic) const {
  return found_pointer(aliased_, historic);
}
const cdl::RobotClass* Vocabulary::robot_class(std::string_view name) const {
  return found_pointer(classes_, name);
}
const cdl::Binding* Vocabulary::binding(std::string_view name) const {
  return found_pointer(bindings_, name);
}

bool Vocabulary::is_taken(std::string_view name) const {
  return signatures_.contains(name) || historic_.contains(name) || classes_.contains(name) ||
         bindings_.contains(name);
}

std::string Vocabulary::type(std::string_view name) const {
  if (const flow::QuantityInfo* quantity = flow::quantity_named(name))
    return std::string(flow::info(quantity->type).name);
  static const std::map<std::string_view, std::string_view> kHistoric = {
      {"string", "Text"},         {"direction", "double"}, {"location", "Pose"},
      {"displacement", "Vector"}, {"UTM", "Point"},        {"Map_Location", "Point"}};
  if (const auto it = kHistoric.find(name); it != kHistoric.end()) return std::string(it->second);
  const flow::TypeInfo* info = procedures_.find_type(name);
  return info == nullptr ? std::string{} : std::string(info->name);
}

}  // namespace mlab::cdl_historic
