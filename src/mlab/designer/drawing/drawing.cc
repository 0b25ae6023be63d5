#include "mlab/designer/drawing/drawing.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/drawing/shapes.h"
#include "mlab/lang/cdl/print/print.h"
#include "mlab/lang/cdl/syntax/walk.h"

namespace mlab::designer {
namespace {

using Kind = GraphNode::Kind;

/// Draws the pages of one owner.
class Drawer {
 public:
  Drawer(const Model& model, const DrawingContext& context, Model::FoundPage found, Drawing& out)
      : model_(model),
        context_(context),
        graph_(*found.graph),
        page_(found.graph->pages[static_cast<std::size_t>(found.page)]),
        uses_(names_used(graph_)),
        out_(out) {
    const cdl::Layout* layout = model.layout(page_.path);
    if (layout == nullptr) return;
    for (const cdl::LayoutEntry& entry : layout->entries) {
      const bool is_actuator = entry.node.text.starts_with("actuator.");
      places_.try_emplace(is_actuator ? "$" + entry.node.text.substr(9) : entry.node.text, &entry);
    }
  }

  void run() {
    const bool is_owner = page_.parent < 0;
    out_.set_kind(page_.sequence != nullptr                     ? Drawing::STATES
                  : graph_.robot != nullptr && page_.parent < 0 ? Drawing::ROBOT
                                                                : Drawing::DATAFLOW);
    for (const GraphNode& node : page_.nodes) add_node(node);
    if (page_.sequence != nullptr) add_states(*page_.sequence);
    for (const cdl::Parameter& parameter : graph_.parameters()) add_parameter(parameter, model_, out_);
    if (page_.result >= 0) out_.set_result_node(node_at(page_.result).name);
    if (page_.root != nullptr) out_.set_result_type(graph_.type_of(*page_.root).name());
    if (is_owner && graph_.assemblage != nullptr && !graph_.assemblage->result_type.text.empty())
      out_.set_result_type(graph_.assemblage->result_type.text);
    if (is_owner) out_.set_help(graph_.assemblage != nullptr ? graph_.assemblage->help : graph_.robot->help);
    if (page_.state != nullptr) out_.set_help(page_.state->help);
    if (page_.result >= 0) {
      Wire& wire = *out_.add_wires();
      wire.set_from(node_at(page_.result).name);
      wire.set_to("$result");
      wire.set_type(out_.result_type());
      wire.set_live(live_of(node_at(page_.result)));
    }
  }

 private:
  const GraphNode& node_at(int at) const { return page_.nodes[static_cast<std::size_t>(at)]; }

  // Of its output, below the page's own path.
  std::string live_of(const GraphNode& node) const {
    if (node.kind == Kind::kParameter) return graph_.robot != nullptr ? node.name : "";
    if (node.kind == Kind::kOuter || node.kind == Kind::kActuator || node.kind == Kind::kValue) return "";
    if (node.path == page_.base) return ".";
    return page_.base.empty() ? node.path : node.path.substr(page_.base.size() + 1);
  }

  void add_node(const GraphNode& node) {
    Node& out = *out_.add_nodes();
    out.set_name(node.name);
    const cdl::PortType type = graph_.type_of(node);
    out.set_type(type.name());
    out.set_unit(type.unit);
    out.set_live(live_of(node));
    describe(node, out);
    const text::Span span = span_of(node);
    out.set_begin(span.begin);
    out.set_end(span.end);
    if (node.inner >= 0)
      set_page(*out.mutable_inner(), graph_.pages[static_cast<std::size_t>(node.inner)].path);
    const bool is_let = node.let != nullptr && node.kind != Kind::kOuter;
    out.set_is_loose(is_let && !uses_.contains(node.let->name.text));
    place(out);
    add_inputs(node, out);
  }

  text::Span span_of(const GraphNode& node) const {
    if (node.parameter != nullptr) return node.parameter->name.place.span;
    if (node.drive != nullptr) return node.drive->binding.place.span;
    if (node.let != nullptr) return {node.let->name.place.span.begin, node.let->value->place.span.end};
    return node.expression == nullptr ? text::Span{} : node.expression->place.span;
  }

  void describe(const GraphNode& node, Node& out) const {
    const std::string given = node.let != nullptr          ? node.let->name.text
                              : node.expression != nullptr ? node.expression->as.text
                                                           : "";
    if (node.let != nullptr) out.set_help(node.let->help);
    switch (node.kind) {
      case Kind::kParameter:
        out.set_shape(Node::PARAMETER);
        out.set_title(node.name);
        out.set_component("parameter");
        out.set_help(node.parameter->help);
        out.set_icon("parameter");
        return;
      case Kind::kOuter:
        out.set_shape(Node::PARAMETER);
        out.set_title(node.name);
        out.set_component("let");
        out.set_icon("parameter");
        return;
      case Kind::kValue:
        out.set_shape(Node::PARAMETER);
        out.set_title(node.name);
        out.set_component("value");
        out.set_icon("value");
        return;
      case Kind::kActuator:
        out.set_shape(Node::ACTUATOR);
        out.set_title(node.drive->binding.text);
        out.set_component(node.drive->binding.text);
        out.set_icon("actuator");
        if (const auto binding = model_.configuration().bindings.find(node.drive->binding.text);
            binding != model_.configuration().bindings.end())
          out.set_help(binding->second->help);
        return;
      default:
        break;
    }
    if (node.expression == nullptr) return;
    describe_expression(*node.expression, out);
    const bool is_auto = given.empty() || given == default_name(*node.expression);
    out.set_title(is_auto ? out.component() : given);
  }

  void describe_expression(const cdl::Expression& expression, Node& out) const {
    const auto operator_shape = operator_of(expression);
    if (operator_shape) {
      out.set_shape(operator_shape->shape);
      out.set_component(operator_shape->component);
      out.set_icon(operator_shape->icon);
      if (out.help().empty()) out.set_help(operator_shape->help);
      return;
    }
    const std::string callee = default_name(expression);
    out.set_component(callee);
    const std::optional<Callable>& component = model_.components().find(callee);
    if (!component) {
      out.set_shape(Node::UNKNOWN);
      out.set_icon("unknown");
      return;
    }
    out.set_shape(shape_of(*component));
    out.set_icon(icon_of(*component));
    if (out.help().empty()) out.set_help(component->help);
    if (component->assemblage != nullptr) set_inner(*component->assemblage, out);
  }

  void set_inner(const cdl::Assemblage& assemblage, Node& out) const {
    const text::SourcePtr& source = assemblage.name.place.source;
    if (!source) return;
    const std::string document =
        source == model_.source() ? context_.document : context_.document_of(source->name());
    if (document.empty()) return;
    out.mutable_inner()->set_document(document);
    out.mutable_inner()->set_path(assemblage.name.text);
  }

  void set_page(Page& page, const std::string& path) const {
    page.set_document(context_.document);
    page.set_path(path);
  }

  void place(Node& out) const {
    const auto there = places_.find(out.name());
    if (there == places_.end()) return;
    out.set_x(there->second->x);
    out.set_y(there->second->y);
  }

  // ---- inputs

  const Socket* socket_of(const std::vector<Socket>& sockets, const GraphInput& input) const {
    const auto found = std::ranges::find(sockets, input.port, &Socket::name);
    return found == sockets.end() ? nullptr : &*found;
  }

  // What the inputs of a node are, by their names.
  std::vector<Socket> sockets_of(const GraphNode& node) const {
    return sockets(node, model_.components(), graph_);
  }

  void add_inputs(const GraphNode& node, Node& out) {
    const std::vector<Socket> sockets = sockets_of(node);
    for (std::size_t i = 0; i < node.inputs.size(); ++i) {
      const GraphInput& input = node.inputs[i];
      if (input.from >= 0) add_wire(node, input, sockets);
      if (input.role == Role::kWeight || input.role == Role::kActive) continue;
      Port& port = *out.add_inputs();
      port.set_name(input.port);
      if (input.index) port.set_index(*input.index);
      port.set_is_list(input.is_open);
      fill_port(port, input, socket_of(sockets, input));
      port.set_label(label_of(node, input));
      if (input.role != Role::kMember || input.is_open) continue;
      port.set_is_member(true);
      if (i + 1 < node.inputs.size()) fill_weight(port, node.inputs[i + 1]);
    }
  }

  static std::string label_of(const GraphNode& node, const GraphInput& input) {
    if (input.role == Role::kCase) {
      const auto& cases = std::get<cdl::Select>(node.expression->what).cases;
      std::string out;
      for (const cdl::Word& word : cases[static_cast<std::size_t>(input.at)].values)
        out += (out.empty() ? "" : ", ") + word.text;
      return out.empty() ? "otherwise" : out;
    }
    if (input.role == Role::kMember) return input.is_open ? "add" : "";
    std::string out = input.port;
    std::ranges::replace(out, '_', ' ');
    return input.index && !input.is_open ? fmt::format("{} {}", out, *input.index + 1) : out;
  }

  void fill_port(Port& port, const GraphInput& input, const Socket* socket) const {
    if (socket != nullptr) {
      port.set_type(socket->type.name());
      port.set_unit(socket->type.unit);
      port.set_help(socket->help);
      port.set_initial(socket->initial);
      port.set_is_required(socket->is_required);
      if (socket->min) port.set_min(*socket->min);
      if (socket->max) port.set_max(*socket->max);
      for (const std::string& choice : choices_of(socket->type)) port.add_choices(choice);
    }
    if (!input.written) return;
    port.set_begin(input.written->place.span.begin);
    port.set_end(input.written->place.span.end);
    if (input.from >= 0) return;
    port.set_value(written(*input.written));
    port.set_is_exposed(names_parameter(*input.written));
  }

  bool names_parameter(const cdl::Expression& expression) const {
    const auto* name = std::get_if<cdl::Name>(&expression.what);
    return name != nullptr && std::ranges::any_of(graph_.parameters(), [&](const cdl::Parameter& parameter) {
             return parameter.name.text == name->name.text;
           });
  }

  void fill_weight(Port& port, const GraphInput& weight) const {
    if (weight.role != Role::kWeight || !weight.written) return;
    if (weight.from >= 0)
      port.set_weight_wire(node_at(weight.from).name);
    else
      port.set_weight(written(*weight.written));
  }

  void add_wire(const GraphNode& node, const GraphInput& input, const std::vector<Socket>&) {
    Wire& wire = *out_.add_wires();
    const GraphNode& from = node_at(input.from);
    wire.set_from(from.name);
    wire.set_to(node.name);
    wire.set_port(input.port);
    if (input.index) wire.set_index(*input.index);
    const cdl::PortType type = graph_.type_of(from);
    wire.set_type(type.name());
    wire.set_unit(type.unit);
    wire.set_live(live_of(from));
    wire.set_is_active(input.role == Role::kActive);
  }

  // ---- states

  void add_states(const cdl::Sequence& sequence) {
    for (std::size_t i = 0; i < sequence.states.size(); ++i) {
      const cdl::State& state = sequence.states[i];
      const GraphPage& inner = graph_.pages[static_cast<std::size_t>(page_.states[i])];
      State& out = *out_.add_states();
      out.set_name(state.name.text);
      out.set_is_start(state.is_start);
      out.set_is_final(state.is_final);
      if (state.member) {
        out.set_member(written(*state.member));
        out.set_title(title_of(*state.member));
        if (const auto* call = std::get_if<cdl::Call>(&state.member->what)) set_calls(*call, out);
      }
      out.set_help(state.help);
      set_page(*out.mutable_inner(), inner.path);
      out.set_begin(state.place.span.begin);
      out.set_end(state.member ? state.member->place.span.end : state.place.span.end);
      out.set_live(state.name.text);
      place_state(out);
      for (std::size_t k = 0; k < state.transitions.size(); ++k) add_transition(state, k);
    }
  }

  void set_calls(const cdl::Call& call, State& out) const {
    const auto found = model_.configuration().assemblages.find(call.callee.text);
    if (found == model_.configuration().assemblages.end()) return;
    Node node;
    set_inner(*found->second, node);
    if (node.has_inner()) *out.mutable_calls() = node.inner();
  }

  void place_state(State& out) const {
    const auto there = places_.find(out.name());
    if (there == places_.end()) return;
    out.set_x(there->second->x);
    out.set_y(there->second->y);
  }

  // What a state does, in a few words.
  static std::string title_of(const cdl::Expression& expression) {
    if (const auto* name = std::get_if<cdl::Name>(&expression.what)) return name->name.text;
    const auto shape = operator_of(expression);
    return shape ? shape->component : default_name(expression);
  }

  // A `let` has its value where it stands, all else where lowering puts it.
  std::string live_of_hidden(const cdl::Expression& expression) const {
    if (const auto* name = std::get_if<cdl::Name>(&expression.what)) {
      const bool is_let = page_.base.empty() && std::ranges::any_of(graph_.lets(), [&](const cdl::Let& let) {
                            return let.name.text == name->name.text;
                          });
      return is_let ? name->name.text : "";
    }
    const auto found = graph_.hidden.find(&expression);
    if (found == graph_.hidden.end()) return "";
    return page_.base.empty() ? found->second : found->second.substr(page_.base.size() + 1);
  }

  void add_conditions(const cdl::Expression& trigger, Transition& out) const {
    const cdl::Expression& condition = condition_of(trigger);
    if (const std::string live = live_of_hidden(condition); !live.empty()) {
      Transition::Condition& told = *out.add_conditions();
      told.set_text(written(trigger));
      told.set_live(live);
      told.set_is_negated(&condition != &trigger);
    }
    const auto* logic = std::get_if<cdl::Logic>(&condition.what);
    if (logic == nullptr) return;
    for (const cdl::ExpressionPtr& operand : logic->operands) add_part(*operand, out);
  }

  void add_part(const cdl::Expression& part, Transition& out) const {
    if (const std::string live = live_of_hidden(part); !live.empty()) {
      Transition::Condition& told = *out.add_conditions();
      told.set_text(written(part));
      told.set_live(live);
    }
    const auto* logic = std::get_if<cdl::Logic>(&part.what);
    if (logic == nullptr) return;
    for (const cdl::ExpressionPtr& operand : logic->operands) add_part(*operand, out);
  }

  void add_transition(const cdl::State& state, std::size_t index) {
    const cdl::Transition& transition = state.transitions[index];
    Transition& out = *out_.add_transitions();
    out.set_from(state.name.text);
    out.set_index(static_cast<std::uint32_t>(index));
    out.set_to(transition.target.text);
    if (transition.trigger) {
      out.set_trigger(written(*transition.trigger));
      add_conditions(*transition.trigger, out);
    }
    out.set_restarts(transition.restarts);
    out.set_help(transition.help);
    out.set_begin(transition.place.span.begin);
    out.set_end(transition.place.span.end);
  }

  const Model& model_;
  const DrawingContext& context_;
  const OwnerGraph& graph_;
  const GraphPage& page_;
  std::set<std::string, std::less<>> uses_;  // names that something reads
  std::map<std::string, const cdl::LayoutEntry*, std::less<>> places_;
  Drawing& out_;
};

void add_way(const Model& model, const std::string& path, const DrawingContext& context, Drawing& out) {
  const auto add = [&](const std::string& page, const std::string& title) {
    Page& step = *out.add_way();
    step.set_document(context.document);
    step.set_path(page);
    out.add_way_titles(title);
  };
  const std::size_t slash = context.document.rfind('/');
  const bool is_new = context.document.starts_with("new:");
  add("", is_new ? "New configuration" : context.document.substr(slash == std::string::npos ? 0 : slash + 1));
  if (path.empty()) return;
  add(std::string(owner_of(path)), std::string(owner_of(path)));
  const Model::FoundPage found = model.page(path);
  if (found.graph == nullptr) return;
  std::vector<const GraphPage*> pages;
  for (int at = found.page; at > 0;) {
    const GraphPage& page = found.graph->pages[static_cast<std::size_t>(at)];
    pages.push_back(&page);
    at = page.parent;
  }
  std::ranges::reverse(pages);
  std::size_t done = std::string(owner_of(path)).size();
  for (const GraphPage* page : pages) {
    add(page->path, page->path.substr(std::min(done + 1, page->path.size())));
    done = page->path.size();
  }
}

void add_notes(const Model& model, const std::string& page, Drawing& out) {
  const cdl::Layout* layout = model.layout(page);
  if (layout == nullptr) return;
  for (std::size_t i = 0; i < layout->notes.size(); ++i) {
    const cdl::LayoutNote& note = layout->notes[i];
    Note& added = *out.add_notes();
    added.set_id(fmt::format("{}", i + 1));
    std::string text;
    for (const std::string& line : note.lines) text += (text.empty() ? "" : "\n") + line;
    added.set_text(text);
    added.set_x(note.x);
    added.set_y(note.y);
    added.set_width(note.width);
    added.set_height(note.height);
    added.set_is_frame(note.is_frame);
  }
}

}  // namespace

std::string written(const cdl::Expression& expression) {
  if (!expression.place.source) return cdl::print(expression);
  return std::string(expression.place.source->text(expression.place.span));
}

void add_parameter(const cdl::Parameter& parameter, const Model& model, Drawing& drawing) {
  const Socket socket = model.components().socket(parameter);
  Parameter& out = *drawing.add_parameters();
  out.set_name(socket.name);
  out.set_type(parameter.type.text);
  out.set_unit(socket.type.unit);
  out.set_initial(parameter.initial ? written(*parameter.initial) : "");
  if (socket.min) out.set_min(*socket.min);
  if (socket.max) out.set_max(*socket.max);
  out.set_help(socket.help);
  for (const std::string& choice : choices_of(socket.type)) out.add_choices(choice);
}

Drawing draw(const Model& model, const std::string& page, const DrawingContext& context) {
  Drawing out;
  out.mutable_page()->set_document(context.document);
  out.mutable_page()->set_path(page);
  out.set_revision(context.revision);
  out.set_is_read_only(context.is_read_only);
  if (page.empty()) {
    draw_file(model, context, out);
  } else if (const Model::FoundPage found = model.page(page); found.graph != nullptr) {
    Drawer(model, context, found, out).run();
    if (out.kind() == Drawing::ROBOT) add_robot(model, *found.graph->robot, context, out);
  } else if (const cdl::Society* society = model.society(page)) {
    draw_society(model, *society, context, out);
  } else if (!draw_equipment(model, page, context, out)) {
    return out;
  }
  add_way(model, page, context, out);
  add_notes(model, page, out);
  return out;
}

}  // namespace mlab::designer
