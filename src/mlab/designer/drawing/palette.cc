#include <algorithm>
#include <array>
#include <set>

#include <fmt/core.h>

#include "mlab/designer/drawing/shapes.h"
#include "mlab/lang/cdl/types/arithmetic.h"

namespace mlab::designer {
namespace {

struct Operator {
  const char* name;
  const char* title;
  const char* group;
  Node::Shape shape;
  const char* icon;
  const char* help;
  const char* type;
};
constexpr std::array<Operator, 11> kOperators = {{
    {"cooperate", "Cooperate", "Operators", Node::COOPERATION, "cooperate",
     "All members at once: their movements are added up, each with its gain.", "Vector"},
    {"compete by priority", "Compete by priority", "Operators", Node::COMPETITION, "compete",
     "The first member that wants anything moves the robot.", "Vector"},
    {"compete by strength", "Compete by strength", "Operators", Node::COMPETITION, "compete",
     "The member with the strongest activation moves the robot.", "Vector"},
    {"sequence", "Sequence", "Operators", Node::SEQUENCE, "sequence",
     "One state at a time; triggers make the transitions. Double-click enters its states.", "Vector"},
    {"select", "Select", "Operators", Node::SELECTION, "select",
     "Does what its selector says: a number, a truth value or a choice.", "Vector"},
    {"delay", "Delay", "Operators", Node::DELAY, "delay",
     "The value of the cycle before. A loop of wires needs one.", ""},
    {"formula", "Formula", "Numbers", Node::FORMULA, "formula",
     "Computes with numbers, vectors and units: `2 * near + 1 m`, `distance(here, home) < 3 m`.", ""},
    {kComparison, "Comparison", "Numbers", Node::FORMULA, "formula",
     "Compares two numbers of one unit: `length(way) < 3 m`, `count >= 2`.", "bool"},
    {"not", "Not", "Logic", Node::LOGIC, "logic", "True where its input is false.", "bool"},
    {"and", "And", "Logic", Node::LOGIC, "logic", "True where all its inputs are.", "bool"},
    {"or", "Or", "Logic", Node::LOGIC, "logic", "True where one of its inputs is.", "bool"},
}};

// `AvoidStaticObstacles`: `Avoid static obstacles`; `sense_obstacles`: `Sense obstacles`.
std::string title_of(std::string_view name) {
  std::string out;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    const bool is_upper = c >= 'A' && c <= 'Z';
    const bool after_lower =
        i > 0 && ((name[i - 1] >= 'a' && name[i - 1] <= 'z') || (name[i - 1] >= '0' && name[i - 1] <= '9'));
    if (c == '_') {
      out += ' ';
    } else if (is_upper && after_lower) {
      const bool is_word = i + 1 < name.size() && name[i + 1] >= 'a' && name[i + 1] <= 'z';
      out += ' ';
      out += is_word ? static_cast<char>(c + 32) : c;
    } else {
      out += c;
    }
  }
  if (!out.empty() && out.front() >= 'a' && out.front() <= 'z')
    out.front() = static_cast<char>(out.front() - 32);
  return out;
}

std::string first_paragraph(std::string_view help) {
  return std::string(help.substr(0, help.find("\n\n")));
}

void add_port(const Socket& socket, Component& out) {
  Port& port = *out.add_inputs();
  port.set_name(socket.name);
  port.set_label(socket.name);
  port.set_type(socket.type.name());
  port.set_unit(socket.type.unit);
  port.set_help(socket.help);
  port.set_is_required(socket.is_required);
  port.set_is_list(socket.is_list);
  port.set_initial(socket.initial);
  if (socket.min) port.set_min(*socket.min);
  if (socket.max) port.set_max(*socket.max);
  for (const std::string& choice : choices_of(socket.type)) port.add_choices(choice);
}

text::SourcePtr source_of(const Callable& component) {
  if (component.assemblage != nullptr) return component.assemblage->name.place.source;
  if (component.binding != nullptr) return component.binding->name.place.source;
  return nullptr;
}

void split_words(std::string_view words, Component& out) {
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    if (end > 0) out.add_aliases(std::string(words.substr(0, end)));
    words.remove_prefix(std::min(end + 1, words.size()));
  }
}

}  // namespace

Component palette_entry(const Callable& component, const Model& model, const DrawingContext& context) {
  Component out;
  out.set_name(component.name);
  out.set_title(title_of(component.name));
  out.set_shape(shape_of(component));
  out.set_help(first_paragraph(component.help));
  out.set_type(component.output.name());
  out.set_unit(component.output.unit);
  out.set_icon(icon_of(component));
  for (const Socket& socket : component.inputs) add_port(socket, out);
  split_words(component.historic_names, out);
  out.set_group(group_of(component));
  if (const text::SourcePtr source = source_of(component)) {
    const bool is_own = source == model.source();
    const std::string document = is_own ? context.document : context.document_of(source->name());
    out.set_source(document);
    out.set_is_own(is_own || !document.starts_with("library:"));
    if (is_own && component.assemblage != nullptr) out.set_group("This file");
    if (!is_own && out.is_own() && component.assemblage != nullptr) out.set_group("This project");
  }
  return out;
}

Palette palette_of(const Model& model, const DrawingContext& context) {
  Palette out;
  out.set_document(context.document);
  const Components& components = model.components();
  for (const Operator& op : kOperators) {
    Component& one = *out.add_components();
    one.set_name(op.name);
    one.set_title(op.title);
    one.set_group(op.group);
    one.set_shape(op.shape);
    one.set_icon(op.icon);
    one.set_help(op.help);
    one.set_type(op.type);
  }
  for (const auto& [name, op] : model.configuration().operators) out.add_coordinators(name);
  std::set<std::string, std::less<>> names;
  for (const auto& [name, assemblage] : model.configuration().assemblages) {
    *out.add_components() = palette_entry(components.of(*assemblage), model, context);
    names.insert(name);
  }
  for (const auto& [name, binding] : model.configuration().bindings) {
    if (binding->result_type.text.empty() || !names.insert(name).second) continue;
    *out.add_components() = palette_entry(components.of(*binding), model, context);
  }
  for (const cdl::Function& function : cdl::functions()) {
    const bool is_shown = components.types().function({std::string(function.name), {}}) != nullptr;
    if (is_shown && function.name != cdl::kPlaceFunction)
      *out.add_components() = palette_entry(components.of(function), model, context);
  }
  for (const flow::Behavior* behavior : model.library().behaviors()) {
    const bool is_shown = !names.contains(behavior->name) && !cdl::is_said_by_signs(behavior->name);
    if (!is_shown) continue;
    const Callable component = components.of(flow::Library::Entry{behavior, nullptr});
    *out.add_components() = palette_entry(component, model, context);  // actuators for classes and robots
    if (!is_operator(component)) continue;
    Component& op = *out.add_components();
    op = palette_entry(component, model, context);
    op.set_name("coordinate by " + component.name);
    op.set_title("Coordinate by " + title_of(component.name));
  }
  return out;
}

}  // namespace mlab::designer
