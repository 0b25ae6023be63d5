#include <algorithm>
#include <limits>

#include <fmt/core.h>

#include "mlab/designer/drawing/drawing.h"
#include "mlab/designer/drawing/serving.h"
#include "mlab/lang/cdl/types/body.h"

namespace mlab::designer {
namespace {

/// Looks for the smallest thing drawn that holds a byte.
class Finder {
 public:
  explicit Finder(std::uint32_t byte) : byte_(byte) {}

  const DrawnAt& found() const { return found_; }
  bool holds(const text::Span& span) const { return span.begin <= byte_ && byte_ < span.end; }

  void look(const text::Span& span, DrawnAt at) {
    if (!holds(span) || span.end - span.begin > best_) return;
    best_ = span.end - span.begin;
    found_ = std::move(at);
  }

  void look(const OwnerGraph& graph) {
    for (const GraphPage& page : graph.pages) {
      look_states(page);
      for (const GraphNode& node : page.nodes) look_node(page, node);
    }
    for (const cdl::Parameter& parameter : graph.parameters()) {
      text::Span span = parameter.name.place.span;
      if (parameter.initial) span.end = parameter.initial->place.span.end;
      look(span, {graph.name, "", parameter.name.text});
    }
  }

 private:
  void look_states(const GraphPage& page) {
    if (page.sequence == nullptr) return;
    for (const cdl::State& state : page.sequence->states) {
      text::Span span = state.place.span;
      if (state.member) span.end = state.member->place.span.end;
      look(span, {page.path, state.name.text, ""});
      for (std::size_t i = 0; i < state.transitions.size(); ++i)
        look(state.transitions[i].place.span, {page.path, fmt::format("{}/{}", state.name.text, i), ""});
    }
  }

  void look_node(const GraphPage& page, const GraphNode& node) {
    if (node.kind == GraphNode::Kind::kParameter || node.kind == GraphNode::Kind::kOuter) return;
    if (node.drive != nullptr) look(node.drive->binding.place.span, {page.path, node.name, ""});
    if (node.let != nullptr) {
      look({node.let->name.place.span.begin, node.let->value->place.span.end}, {page.path, node.name, ""});
    }
    if (node.expression != nullptr) look(node.expression->place.span, {page.path, node.name, ""});
    for (const GraphInput& input : node.inputs) {
      if (input.written && input.from < 0)
        look(input.written->place.span, {page.path, node.name, input.port});
    }
  }

  std::uint32_t byte_;
  std::uint32_t best_ = std::numeric_limits<std::uint32_t>::max();
  DrawnAt found_;
};

void look_body(const cdl::RobotClass& robot_class, Finder& finder) {
  for (const cdl::BodySetting& setting : robot_class.body) {
    const cdl::BodyProperty* property = cdl::body_property(setting.name.text);
    const std::string part(setting.name.text == "drive" ? "drive"
                           : property != nullptr        ? property->part
                                                        : "body");
    text::Span span = setting.name.place.span;
    if (setting.value) span.end = setting.value->place.span.end;
    finder.look(span, {robot_class.name.text, std::string(kBodyNode) + part, setting.name.text});
  }
}

// Where a robot is called the same nobody can look at them.
void look_devices(const Model& model, const std::string& owner, const std::vector<cdl::Device>& devices,
                  Finder& finder) {
  if (!equipped(model, owner)) return;
  for (const cdl::Device& device : devices) {
    finder.look(device.whole, {owner, device.name.text, ""});
    for (const cdl::Argument& argument : device.by.arguments) {
      if (argument.value)
        finder.look(argument.value->place.span, {owner, device.name.text, argument.name.text});
    }
  }
}

}  // namespace

DrawnAt drawn_at(const Model& model, std::uint32_t byte) {
  Finder finder(byte);
  for (const cdl::Item& item : model.tree().items) {
    std::string name;
    if (const auto* assemblage = std::get_if<cdl::Assemblage>(&item)) name = assemblage->name.text;
    if (const auto* robot = std::get_if<cdl::Robot>(&item)) name = robot->name.text;
    if (const auto* society = std::get_if<cdl::Society>(&item)) {
      finder.look(society->name.place.span, {"", society->name.text, ""});
      finder.look(society->what.place.span, {society->name.text, "", ""});
    }
    if (const auto* robot_class = std::get_if<cdl::RobotClass>(&item)) {
      finder.look(robot_class->name.place.span, {"", robot_class->name.text, ""});
      look_body(*robot_class, finder);
      look_devices(model, robot_class->name.text, robot_class->devices, finder);
    }
    if (const auto* op = std::get_if<cdl::SocietyOperator>(&item)) {
      finder.look(op->name.place.span, {"", op->name.text, ""});
      look_devices(model, op->name.text, op->devices, finder);
    }
    if (const auto* binding = std::get_if<cdl::Binding>(&item))
      finder.look(binding->whole, {"", binding->name.text, ""});
    const OwnerGraph* graph = name.empty() ? nullptr : model.graph(name);
    if (graph == nullptr) continue;
    const text::Place& place =
        graph->assemblage != nullptr ? graph->assemblage->name.place : graph->robot->name.place;
    finder.look(place.span, {"", name, ""});
    finder.look(*graph);
  }
  return finder.found();
}

Problem problem_of(const text::Diagnostic& diagnostic, const Model& model, const DrawingContext& context) {
  Problem out;
  console::Diagnostic& d = *out.mutable_diagnostic();
  d.set_is_warning(diagnostic.severity != text::Severity::kError);
  d.set_kind(diagnostic.kind);
  d.set_message(diagnostic.message);
  d.set_label(diagnostic.label);
  for (const std::string& hint : diagnostic.hints) d.add_hints(hint);
  const text::SourcePtr& source = diagnostic.place.source;
  if (!source) return out;
  const bool is_own = source == model.source();
  d.set_document(is_own ? context.document : context.document_of(source->name()));
  d.set_begin(diagnostic.place.span.begin);
  d.set_end(diagnostic.place.span.end);
  const text::LineColumn at = source->line_column(diagnostic.place.span.begin);
  d.set_line(at.line);
  d.set_column(at.column);
  if (!is_own) return out;
  const DrawnAt drawn = drawn_at(model, diagnostic.place.span.begin);
  out.set_page(drawn.page);
  out.set_node(drawn.node);
  out.set_port(drawn.port);
  return out;
}

}  // namespace mlab::designer
