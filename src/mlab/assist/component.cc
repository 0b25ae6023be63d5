#include "mlab/assist/component.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstring>

#include <fmt/core.h>

#include "mlab/flow/frame.h"
#include "mlab/flow/limit.h"
#include "mlab/lang/cdl/types/port_type.h"
#include "mlab/lang/cdl/types/types.h"
#include "mlab/lang/cdl/types/units.h"
#include "mlab/percept/formation.h"
#include "mlab/robot/program/robot_program.h"

namespace mlab::assist {
namespace {

std::string bound(double value) {
  return flow::is_limit(value) ? fmt::format("{}", value) : "";
}

std::string range_text(const ComponentInput& input) {
  if (input.low.empty() && input.high.empty()) return "";
  if (input.low.empty()) return fmt::format("at most {}", input.high);
  if (input.high.empty()) return fmt::format("at least {}", input.low);
  return fmt::format("{} .. {}", input.low, input.high);
}

std::string shown_output(const Component& component) {
  if (component.is_sink) return "";
  if (component.output.type.empty()) return "";
  return fmt::format(" -> {}{}", component.output.type, bracketed(component.output.unit));
}

// A cell of a table stands on one line, without `|`.
std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '|') out += '\\';
    out += c == '\n' ? ' ' : c;
  }
  return out;
}

// Words with `-` in them are written with `_` where `-` is none of a name.
std::string as_name(std::string word) {
  std::ranges::replace(word, '-', '_');
  return word;
}

std::string constant_text(const flow::Source& source) {
  return source.text;
}

}  // namespace

Component component_of(const flow::Behavior& behavior) {
  Component out;
  out.name = behavior.name;
  out.kind = "procedure";
  out.help = behavior.help;
  out.source = behavior.source;
  out.file = behavior.file;
  out.is_sink = behavior.output == nullptr;
  if (!out.is_sink) out.output = {std::string(behavior.output->name), std::string(behavior.output_unit)};
  for (const flow::Input& input : behavior.inputs) {
    ComponentInput one;
    one.name = input.name;
    one.type = input.type->name;
    one.unit = input.unit;
    one.value = {one.type, one.unit};
    one.initial = input.default_text;
    one.low = bound(input.min);
    one.high = bound(input.max);
    one.help = input.help;
    one.is_list = input.is_list;
    out.inputs.push_back(std::move(one));
  }
  return out;
}

Component component_of(const cdl::Function& function, const flow::Library& library) {
  Component out;
  out.name = function.name;
  out.kind = "function";
  out.help = function.help;
  for (const cdl::InputView& view : cdl::inputs_of(function, library)) {
    ComponentInput one;
    one.name = view.name;
    one.type = one.value.type = view.type.name();
    if (view.input != nullptr) one.help = view.input->help;
    out.inputs.push_back(std::move(one));
  }
  return out;
}

Component component_of(const cnl::Procedure& procedure) {
  Component out;
  out.name = procedure.name.text;
  out.kind = "procedure";
  out.help = procedure.help;
  out.source = procedure.source;
  out.is_own = true;
  out.is_sink = procedure.is_sink();
  out.declaration = procedure.name.place;
  if (!out.is_sink) out.output = value_type(procedure.output_type.text, procedure.output_unit.text);
  for (const cnl::InputDecl& input : procedure.inputs) {
    ComponentInput one;
    one.name = input.name.text;
    one.type = input.type.text;
    one.unit = input.unit.text;
    one.value = value_type(one.type, one.unit);
    if (input.initial) one.initial = constant_text(*input.initial);
    if (input.low) one.low = bound(*input.low);
    if (input.high) one.high = bound(*input.high);
    one.help = input.help;
    one.is_list = input.is_list;
    one.declaration = input.name.place;
    out.inputs.push_back(std::move(one));
  }
  return out;
}

const ComponentInput* find_input(const Component& component, std::string_view name) {
  const auto found = std::ranges::find(component.inputs, name, &ComponentInput::name);
  return found == component.inputs.end() ? nullptr : &*found;
}

std::string first_sentence(std::string_view help) {
  const std::size_t end = help.find(". ");
  const std::size_t line = help.find('\n');
  return std::string(help.substr(0, std::min(end == std::string_view::npos ? help.size() : end + 1, line)));
}

std::string bracketed(std::string_view unit) {
  return unit.empty() ? "" : fmt::format(" [{}]", unit);
}

std::string shown_type(const ValueType& type) {
  return type.type + bracketed(type.unit);
}

std::string shown_input(const ComponentInput& input) {
  std::string out = fmt::format("{}: {}{}{}", input.name, input.is_list ? "list of " : "", input.type,
                                bracketed(input.unit));
  if (!input.initial.empty()) out += fmt::format(" = {}", input.initial);
  if (!input.low.empty() && !input.high.empty()) out += fmt::format(" in {} .. {}", input.low, input.high);
  return out;
}

std::string shown_signature(const Component& component) {
  std::string out = component.name + "(";
  for (std::size_t i = 0; i < component.inputs.size(); ++i)
    out += (i == 0 ? "" : ", ") + shown_input(component.inputs[i]);
  return out + ")" + shown_output(component);
}

std::string markdown_of(const ComponentInput& input) {
  std::string out = fmt::format("```cdl\n{}\n```\n", shown_input(input));
  if (!input.help.empty()) out += fmt::format("\n{}\n", input.help);
  out += input.initial.empty() ? "\nhas to be given" : fmt::format("\ndefault `{}`", input.initial);
  if (!input.value.unit.empty()) out += fmt::format(", unit {}", input.value.unit);
  if (const std::string range = range_text(input); !range.empty()) out += fmt::format(", range {}", range);
  return out + "\n";
}

std::string markdown_of(const Component& component) {
  std::string out = fmt::format("```cdl\n{} {}(", component.kind, component.name);
  for (std::size_t i = 0; i < component.inputs.size(); ++i)
    out += fmt::format("{}\n  {}", i == 0 ? "" : ",", shown_input(component.inputs[i]));
  out += fmt::format("{}){}\n```\n", component.inputs.empty() ? "" : "\n", shown_output(component));
  if (!component.help.empty()) out += fmt::format("\n{}\n", component.help);
  const bool has_help = std::ranges::any_of(component.inputs, [](const ComponentInput& input) {
    return !input.help.empty() || !range_text(input).empty();
  });
  if (has_help) {
    out += "\n| input | unit | default | range | meaning |\n|---|---|---|---|---|\n";
    for (const ComponentInput& input : component.inputs) {
      out += fmt::format("| `{}` | {} | {} | {} | {} |\n", input.name, input.value.unit, cell(input.initial),
                         range_text(input), cell(input.help));
    }
  }
  if (!component.source.empty()) out += fmt::format("\nSource: {}\n", component.source);
  if (!component.is_own && !component.file.empty())
    out += fmt::format("\nComponent library, {}\n", component.file);
  return out;
}

ValueType value_type(std::string_view type, std::string_view unit) {
  if (const flow::QuantityInfo* quantity = flow::quantity_named(type))
    return {std::string(flow::info(quantity->type).name), std::string(unit.empty() ? quantity->unit : unit)};
  const flow::TypeInfo* const known = robot::component_library().find_type(type);
  return {std::string(known == nullptr ? type : known->name), std::string(unit)};
}

ValueType value_type(const cdl::PortType& type) {
  return {type.name(), type.unit};
}

bool fits(const ValueType& have, const ValueType& want) {
  if (have.type.empty() || want.type.empty()) return true;
  const auto known = [](const ValueType& one) {
    return cdl::PortType{robot::component_library().find_type(one.type), one.unit};
  };
  const cdl::PortType of = known(have);
  const cdl::PortType to = known(want);
  // Types of procedures that are brought along are known here by their names only.
  if (of.type == nullptr || to.type == nullptr) return have.type == want.type;
  return cdl::misfit(of, to) == cdl::Misfit::kNone;
}

std::vector<std::string> words_of(std::string_view type) {
  std::vector<std::string> out;
  const flow::TypeInfo* const known = robot::component_library().find_type(type);
  if (known == nullptr) return out;
  for (const std::string_view word : known->words) out.push_back(as_name(std::string(word)));
  if (known->kind == flow::TypeKind::kBool) std::ranges::reverse(out);
  return out;
}

std::vector<std::string> units_like(std::string_view unit) {
  std::vector<std::string> out;
  const auto wanted = cdl::unit_named(unit);
  if (unit.empty() || !wanted) return out;
  out.emplace_back(unit);
  for (const std::string& name : cdl::unit_names()) {
    const auto one = cdl::unit_named(name);
    if (one && one->same_dimension(*wanted) && name != unit) out.push_back(name);
  }
  return out;
}

}  // namespace mlab::assist
