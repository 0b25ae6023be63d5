#include "mlab/designer/drawing/components.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/flow/frame.h"
#include "mlab/flow/limit.h"
#include "mlab/flow/type_words.h"
#include "mlab/lang/cdl/print/print.h"
#include "mlab/lang/cdl/syntax/lexer.h"
#include "mlab/lang/cdl/types/units.h"
#include "mlab/percept/formation.h"

namespace mlab::designer {
namespace {

using flow::TypeKind;

// A constant of CNL as CDL writes it: `{1, 2}` is `[1, 2]`, `Flag|Basket` stands in quotes.
std::string as_cdl(std::string_view text, const flow::TypeInfo* type) {
  std::string out(text);
  const TypeKind kind = type == nullptr ? TypeKind::kOther : type->kind;
  if (kind == TypeKind::kVector || kind == TypeKind::kPoint) {
    std::ranges::replace(out, '{', '[');
    std::ranges::replace(out, '}', ']');
    return out;
  }
  const bool is_word = cdl::is_name(out) && kind != TypeKind::kText;
  const bool is_number =
      !out.empty() && (std::isdigit(static_cast<unsigned char>(out.front())) != 0 || out.front() == '-');
  if (is_word || is_number || out.empty() || out.front() == '"') return out;
  return '"' + out + '"';
}

Socket socket_of(const cdl::InputView& view) {
  const flow::Input& input = *view.input;
  Socket out;
  out.name = view.name;
  out.type = view.type;
  out.help = std::string(input.help);
  out.initial = as_cdl(input.default_text, input.type);
  if (flow::is_limit(input.min)) out.min = input.min;
  if (flow::is_limit(input.max)) out.max = input.max;
  out.is_list = input.is_list;
  out.is_required = input.default_text.empty() && !input.is_list;
  return out;
}

double in_unit(const cdl::Number& number, const std::string& unit) {
  const auto to = cdl::unit_named(unit);
  const auto from = number.unit.text.empty() ? to : cdl::unit_named(number.unit.text);
  return from && to ? cdl::converted(number.value, *from, *to).value_or(number.value) : number.value;
}

}  // namespace

Socket Components::socket(const cdl::Parameter& parameter) const {
  Socket out;
  out.name = parameter.name.text;
  out.type = types().of(parameter);
  out.help = parameter.help;
  if (parameter.initial) out.initial = cdl::print(*parameter.initial);
  if (parameter.low) out.min = in_unit(*parameter.low, out.type.unit);
  if (parameter.high) out.max = in_unit(*parameter.high, out.type.unit);
  out.is_required = parameter.initial == nullptr;
  return out;
}

const std::optional<Callable>& Components::find(std::string_view name) const {
  const auto known = found_.find(name);
  if (known != found_.end()) return known->second;
  return found_.emplace(name, made(name)).first->second;
}

std::optional<Callable> Components::made(std::string_view name) const {
  if (const auto binding = configuration_.bindings.find(name); binding != configuration_.bindings.end())
    return of(*binding->second);
  if (const auto found = configuration_.assemblages.find(name); found != configuration_.assemblages.end())
    return of(*found->second);
  const flow::Library::Entry entry = library_.find(name);
  if (entry.behavior != nullptr) return of(entry);
  const cdl::Function* function = cdl::function_named(name);
  return function == nullptr ? std::nullopt : std::optional(of(*function));
}

// What it gives depends on what it is given.
Callable Components::of(const cdl::Function& function) const {
  Callable out;
  out.kind = Callable::Kind::kFunction;
  out.name = function.name;
  out.help = function.help;
  out.behavior = library_.find(function.behavior).behavior;
  for (const cdl::InputView& view : cdl::inputs_of(function, library_)) {
    out.inputs.push_back(view.input == nullptr ? Socket{} : socket_of(view));
    out.inputs.back().name = view.name;
    out.inputs.back().type = view.type;
    out.inputs.back().is_required = true;
  }
  return out;
}

Callable Components::of(const cdl::Assemblage& assemblage) const {
  Callable out;
  out.kind = Callable::Kind::kAssemblage;
  out.name = assemblage.name.text;
  out.help = assemblage.help;
  out.assemblage = &assemblage;
  for (const cdl::Word& word : assemblage.historic_names) out.historic_names += word.text + " ";
  out.output = types().result_of(assemblage);
  for (const cdl::Parameter& parameter : assemblage.parameters) out.inputs.push_back(socket(parameter));
  return out;
}

Callable Components::of(const cdl::Binding& binding) const {
  Callable out;
  out.kind = Callable::Kind::kBinding;
  out.name = binding.name.text;
  out.help = binding.help;
  out.binding = &binding;
  out.output = types().named(binding.result_type.text);
  out.gives_nothing = binding.result_type.text.empty();
  for (const cdl::Parameter& parameter : binding.parameters) out.inputs.push_back(socket(parameter));
  return out;
}

Callable Components::of(const flow::Library::Entry& entry) const {
  const flow::Behavior& behavior = *entry.behavior;
  Callable out;
  out.kind = Callable::Kind::kProcedure;
  out.name = std::string(entry.alias == nullptr ? behavior.name : entry.alias->name);
  out.help = std::string(behavior.help);
  out.behavior = &behavior;
  out.gives_nothing = behavior.output == nullptr;
  out.output = types().of_call(entry);
  for (const flow::Alias& alias : behavior.aliases) out.historic_names += std::string(alias.name) + " ";
  for (const cdl::InputView& view : cdl::inputs_of(entry)) out.inputs.push_back(socket_of(view));
  return out;
}

std::string why_not(const cdl::PortType& have, const cdl::PortType& want) {
  if (cdl::misfit(have, want) == cdl::Misfit::kNone) return "";
  return fmt::format("it takes {}, and this is {}", flow::value_of(*want.type, want.unit),
                     flow::value_of(*have.type, have.unit));
}

std::vector<std::string> choices_of(const cdl::PortType& type) {
  std::vector<std::string> out;
  if (type.type == nullptr) return out;
  for (const std::string_view word : type.type->words) out.push_back(as_cdl(std::string(word), type.type));
  // Who chooses looks for what is there first.
  if (type.type->kind == TypeKind::kBool) std::ranges::reverse(out);
  return out;
}

}  // namespace mlab::designer
