// Primitives: what stands at an input, and the `let`s of nodes that stand alone.

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/editor.h"
#include "mlab/designer/shapes.h"

namespace mlab::designer {
namespace {

bool is_logic(const cdl::Expression& expression) {
  return std::holds_alternative<cdl::Logic>(expression.what);
}

bool is_block(const cdl::Expression& expression) {
  const auto& what = expression.what;
  return std::holds_alternative<cdl::Cooperate>(what) || std::holds_alternative<cdl::Compete>(what) ||
         std::holds_alternative<cdl::Coordinate>(what) || std::holds_alternative<cdl::Fuse>(what) ||
         std::holds_alternative<cdl::Sequence>(what) || std::holds_alternative<cdl::Select>(what);
}

// Whether a node of this name would be called so by itself: `Noise`, `Noise_2`.
bool is_own_name(std::string_view name, std::string_view base) {
  if (!name.starts_with(base)) return false;
  name.remove_prefix(base.size());
  if (name.empty()) return true;
  if (!name.starts_with('_') || name.size() < 2) return false;
  return std::ranges::all_of(name.substr(1), [](char c) { return c >= '0' && c <= '9'; });
}

const cdl::Call* call_of(const cdl::Expression& expression) {
  if (const auto* call = std::get_if<cdl::Call>(&expression.what)) return call;
  if (const auto* by = std::get_if<cdl::Coordinate>(&expression.what)) return &by->by;
  if (const auto* by = std::get_if<cdl::Fuse>(&expression.what)) return &by->by;
  return nullptr;
}

const std::vector<cdl::Member>* members_of(const cdl::Expression& expression) {
  if (const auto* one = std::get_if<cdl::Cooperate>(&expression.what)) return &one->members;
  if (const auto* one = std::get_if<cdl::Compete>(&expression.what)) return &one->members;
  if (const auto* one = std::get_if<cdl::Coordinate>(&expression.what)) return &one->members;
  if (const auto* one = std::get_if<cdl::Fuse>(&expression.what)) return &one->members;
  return nullptr;
}

std::string help_lines(const std::string& help) {
  std::string out;
  std::string_view rest = help;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, end);
    out += line.empty() ? "///\n" : fmt::format("/// {}\n", line);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return out;
}

}  // namespace

// ---- words

// `Noise() as drift active LookAt()` without ` as drift`.
Fragment Editor::value(const cdl::Expression& expression) const {
  const text::Span span = expression.place.span;
  if (expression.as.text.empty()) return work_.moved(span);
  const text::Span name = expression.as.place.span;
  const TokenMap& tokens = work_.tokens();
  const std::uint32_t as = tokens.tokens()[tokens.at(name.begin) - 1].span.begin;
  std::uint32_t end = as;
  while (end > span.begin && (work_.text()[end - 1] == ' ' || work_.text()[end - 1] == '\n')) --end;
  Fragment out = work_.moved({span.begin, end});
  if (name.end < span.end) out.add(work_.moved({name.end, span.end}));
  return out;
}

Fragment Editor::value_as(const cdl::Expression& expression, const std::string& name) const {
  const std::string base = default_name(expression);
  const bool needs_name = !base.empty() && expression.as.text.empty() && !is_own_name(name, base);
  if (!needs_name) return work_.moved(expression.place.span);
  const text::Span span = expression.place.span;
  if (is_logic(expression) && !expression.active)
    return Fragment("(").add(work_.moved(span)).add(fmt::format(") as {}", name));
  if (!expression.active) return work_.moved(span).add(fmt::format(" as {}", name));
  const TokenMap& tokens = work_.tokens();
  std::size_t at = tokens.at(expression.active->place.span.begin);
  while (at > 0 && tokens.word(at) != "active") --at;
  const std::uint32_t active = tokens.tokens()[at].span.begin;
  return work_.moved({span.begin, active})
      .add(fmt::format("as {} ", name))
      .add(work_.moved({active, span.end}));
}

// Only for what stands in `not`, `and`, `or`, where parentheses group.
text::Span Editor::outer(const cdl::Expression& expression) const {
  const TokenMap& tokens = work_.tokens();
  text::Span out = expression.place.span;
  for (;;) {
    const std::optional<std::size_t> before = tokens.before(out.begin);
    const std::size_t after = tokens.at(out.end);
    if (!before || tokens.word(*before) != "(" || tokens.word(after) != ")") return out;
    out = {tokens.tokens()[*before].span.begin, tokens.tokens()[after].span.end};
  }
}

bool Editor::takes(const Spot& spot, const cdl::Expression& expression) const {
  const GraphInput* input = spot.at();
  const Role role = input == nullptr ? Role::kMember : input->role;
  const bool is_line =
      role == Role::kMember || role == Role::kDrive || role == Role::kCase || role == Role::kValue;
  if (is_block(expression)) return is_line;
  return role != Role::kWeight || std::holds_alternative<cdl::Call>(expression.what);
}

std::string Editor::neutral(const cdl::PortType& type) const {
  if (type.type == nullptr) return "0";
  switch (type.type->kind) {
    case flow::TypeKind::kBool:
      return "false";
    case flow::TypeKind::kVector:
      return "Stand()";
    case flow::TypeKind::kPoint:
      return "[0, 0]";
    default:
      return "0";
  }
}

// ---- lets

std::string Editor::add_let(const PageView& view, const std::string& name, const Fragment& value,
                            const std::string& help) {
  const Fragment statement = Fragment(help_lines(help) + fmt::format("let {} = ", name)).add(value).add(";");
  const std::vector<cdl::Let>& lets = view.graph->lets();
  if (!lets.empty()) {
    work_.insert_statement_behind(work_.tokens().statement_end(lets.back().value->place.span.end), statement);
    return name;
  }
  // Behind the `{` of the declaration, and what else stands first in it.
  const text::Place& owner =
      view.graph->assemblage != nullptr ? view.graph->assemblage->name.place : view.graph->robot->name.place;
  const TokenMap& tokens = work_.tokens();
  std::size_t open = tokens.at(owner.span.begin);
  int depth = 0;
  for (; open + 1 < tokens.tokens().size(); ++open) {
    const std::string_view here = tokens.word(open);
    if (here == "(" || here == "[") ++depth;
    if (here == ")" || here == "]") --depth;
    if (depth == 0 && (here == "{" || here == ";")) break;
  }
  if (tokens.word(open) == ";") {  // declared and empty
    work_.replace(tokens.tokens()[open].span, Fragment(" {\n").add(statement).add("\n}"));
    return name;
  }
  std::uint32_t behind = tokens.tokens()[open].span.end;
  if (view.graph->assemblage != nullptr && !view.graph->assemblage->historic_names.empty())
    behind = tokens.statement_end(view.graph->assemblage->historic_names.back().place.span.begin);
  work_.insert_statement_behind(behind, statement);
  return name;
}

void Editor::erase_let(const cdl::Let& let) {
  const TokenMap& tokens = work_.tokens();
  work_.erase_statement(tokens.tokens()[tokens.at(let.name.place.span.begin) - 1].span.begin);
}

std::string Editor::save_inline(const Spot& spot) {
  const int at = inline_node(spot);
  const GraphNode& node = spot.view.node(at);
  const std::string base =
      !node.expression->as.text.empty() ? node.expression->as.text : default_name(*node.expression);
  // The name that it has, where only it would ask for it.
  std::string name = base;
  const std::size_t dot = node.name.rfind('.');
  const std::string local = dot == std::string::npos ? node.name : node.name.substr(dot + 1);
  if (is_own_name(local, base)) name = local;
  if (is_taken(spot.view, name)) name = free_name(spot.view, base);
  std::string help;
  if (const GraphInput* input = spot.at(); input != nullptr && input->role == Role::kMember) {
    const auto* members = members_of(*spot.view.node(spot.node).expression);
    if (members != nullptr) help = (*members)[static_cast<std::size_t>(input->at)].help;
  }
  return add_let(spot.view, name, value(*node.expression), help);
}

// ---- what stands at an input

Done Editor::write(const Spot& spot, const Fragment& what) {
  if (const cdl::Expression* there = written(spot)) {
    if (inline_node(spot) >= 0) save_inline(spot);
    const GraphInput* input = spot.at();
    const bool is_operand = input != nullptr && input->role == Role::kOperand;
    work_.replace(is_operand ? outer(*there) : there->place.span, what);
    return true;
  }
  return write_new(spot, what);
}

Done Editor::write_new(const Spot& spot, const Fragment& what) {
  const TokenMap& tokens = work_.tokens();
  const OwnerGraph& graph = *spot.view.graph;
  if (!spot.drive.empty()) {
    const text::Span name = graph.robot->name.place.span;
    std::size_t open = tokens.at(name.end);
    while (open + 1 < tokens.tokens().size() && tokens.word(open) != "{") ++open;
    const std::uint32_t close = tokens.tokens()[tokens.closer(open)].span.begin;
    const std::uint32_t last = tokens.tokens()[tokens.at(close) - 1].span.end;
    work_.insert_statement_behind(last, Fragment(spot.drive + " = ").add(what).add(";"));
    return true;
  }
  if (spot.is_result()) {
    if (graph.assemblage == nullptr || spot.view.page->parent >= 0)
      return refusal("nothing can be given here");
    const Fragment statement = Fragment(what).add(what.text().ends_with('}') ? "" : ";");
    std::size_t open = tokens.at(graph.assemblage->name.place.span.end);
    if (tokens.word(open) == "(") open = tokens.closer(open) + 1;
    while (open + 1 < tokens.tokens().size() && tokens.word(open) != "{" && tokens.word(open) != ";") ++open;
    if (tokens.word(open) == ";") {
      work_.replace(tokens.tokens()[open].span, Fragment(" {\n").add(statement).add("\n}"));
      return true;
    }
    const std::size_t last = tokens.closer(open) - 1;
    work_.insert_statement_behind(tokens.tokens()[last].span.end, statement);
    return true;
  }
  const GraphInput& input = *spot.at();
  const GraphNode& node = spot.view.node(spot.node);
  switch (input.role) {
    case Role::kArgument:
      return write_argument(spot, what);
    case Role::kMember: {
      const auto* members = members_of(*node.expression);
      const bool is_weighted =
          node.kind == GraphNode::Kind::kCoordinate || node.kind == GraphNode::Kind::kFuse;
      const bool has_weights = is_weighted && !members->empty() && members->front().weight != nullptr;
      const Fragment statement = Fragment(has_weights ? "1: " : "").add(what).add(";");
      if (!members->empty()) {
        work_.insert_statement_behind(tokens.statement_end(members->back().value->place.span.end), statement);
        return true;
      }
      std::size_t open = tokens.at(node.expression->place.span.begin);
      while (open + 1 < tokens.tokens().size() && tokens.word(open) != "{") ++open;
      const text::Span brace = tokens.tokens()[open].span;
      const text::Span close = tokens.tokens()[tokens.closer(open)].span;
      work_.insert(brace.end, Fragment("\n").add(statement));
      if (work_.text().substr(brace.end, close.begin - brace.end).find('\n') == std::string_view::npos)
        work_.insert(close.begin, "\n");
      return true;
    }
    case Role::kWeight: {
      const auto* members = members_of(*node.expression);
      const cdl::Expression& member = *(*members)[static_cast<std::size_t>(input.at)].value;
      work_.insert(member.place.span.begin, Fragment(what).add(": "));
      return true;
    }
    case Role::kOperand: {
      const auto& logic = std::get<cdl::Logic>(node.expression->what);
      const char* word = logic.connective == cdl::Connective::kAnd ? " and " : " or ";
      work_.insert(outer(*logic.operands.back()).end, Fragment(word).add(what));
      return true;
    }
    case Role::kInitial: {
      const auto& delay = std::get<cdl::Delay>(node.expression->what);
      work_.insert(delay.value->place.span.end, Fragment(", initial = ").add(what));
      return true;
    }
    default:
      return refusal("nothing can be put there");
  }
}

// An argument that is not there yet, or one more item of a list.
Done Editor::write_argument(const Spot& spot, const Fragment& what) {
  const TokenMap& tokens = work_.tokens();
  const GraphInput& input = *spot.at();
  const GraphNode& node = spot.view.node(spot.node);
  const cdl::Call* call = call_of(*node.expression);
  if (call == nullptr) return refusal("this takes no inputs");
  if (input.is_open) {
    const GraphInput* last = nullptr;
    for (const GraphInput& other : node.inputs) {
      if (other.port == input.port && !other.is_open && other.written) last = &other;
    }
    if (last != nullptr && last->item >= 0) {
      work_.insert(last->written->place.span.end, Fragment(", ").add(what));
      return true;
    }
    if (last != nullptr) {
      const text::Span span = last->written->place.span;
      work_.insert(span.begin, "[");
      work_.insert(span.end, Fragment(", ").add(what).add("]"));
      return true;
    }
  }
  // Behind the last argument that the declaration has before it.
  const std::optional<Callable> component = work_.model().components().find(call->callee.text);
  if (!component) return refusal(fmt::format("nothing answers to `{}`", call->callee.text));
  std::vector<std::string> order;
  for (const Socket& socket : component->inputs) order.push_back(socket.name);
  const auto rank = [&](const std::string& name) { return std::ranges::find(order, name) - order.begin(); };
  const std::string name = input.port;
  const cdl::Argument* before = nullptr;
  for (std::size_t i = 0; i < call->arguments.size(); ++i) {
    const cdl::Argument& argument = call->arguments[i];
    if (argument.name.text.empty() || rank(argument.name.text) < rank(name)) before = &argument;
  }
  const Fragment whole = Fragment(name + " = ").add(what);
  if (before != nullptr) {
    work_.insert(before->value->place.span.end, Fragment(", ").add(whole));
    return true;
  }
  const std::size_t behind = tokens.at(call->callee.place.span.end);
  if (tokens.word(behind) != "(") {  // `coordinate by Operator { ... }`
    work_.insert(call->callee.place.span.end, Fragment("(").add(whole).add(")"));
    return true;
  }
  work_.insert(tokens.tokens()[behind].span.end, Fragment(whole).add(call->arguments.empty() ? "" : ", "));
  return true;
}

Done Editor::clear(const Spot& spot) {
  const cdl::Expression* there = written(spot);
  if (there == nullptr) return true;
  if (inline_node(spot) >= 0) save_inline(spot);
  if (spot.is_result()) {
    if (spot.view.page->parent >= 0 || spot.view.graph->assemblage == nullptr) {
      work_.replace(there->place.span, "Stand()");
    } else {
      work_.erase_statement(there->place.span.begin);
    }
    return true;
  }
  const TokenMap& tokens = work_.tokens();
  const GraphInput& input = *spot.at();
  const GraphNode& node = spot.view.node(spot.node);
  switch (input.role) {
    case Role::kArgument:
      clear_argument(spot);
      return true;
    case Role::kMember:
      clear_member(spot);
      return true;
    case Role::kWeight:
      work_.erase({there->place.span.begin, tokens.tokens()[tokens.at(there->place.span.end)].span.end});
      return true;
    case Role::kOperand:
      clear_operand(spot);
      return true;
    case Role::kDelayed:
      work_.replace(there->place.span, "[0, 0]");
      return true;
    case Role::kInitial: {
      const auto& delay = std::get<cdl::Delay>(node.expression->what);
      work_.erase({delay.value->place.span.end, there->place.span.end});
      return true;
    }
    case Role::kSelector:
      work_.replace(there->place.span, "0");
      return true;
    case Role::kCase:
      work_.replace(there->place.span, neutral(given(spot.view, spot.node)));
      return true;
    case Role::kActive: {
      std::size_t at = tokens.at(there->place.span.begin);
      while (at > 0 && tokens.word(at) != "active") --at;
      work_.erase({tokens.tokens()[at - 1].span.end, outer(*there).end});
      return true;
    }
    case Role::kDrive:
      work_.erase_statement(node.drive->binding.place.span.begin);
      return true;
    default:
      return refusal("a name has to stand for something");
  }
}

// The words up to the next argument go as well. Those behind it by position get their names.
void Editor::clear_argument(const Spot& spot) {
  const TokenMap& tokens = work_.tokens();
  const GraphInput& input = *spot.at();
  const cdl::Expression& there = *input.written;
  const cdl::Call& call = *call_of(*spot.view.node(spot.node).expression);
  const auto erase_between_commas = [&](text::Span span) {
    const std::size_t after = tokens.at(span.end);
    const std::size_t before = *tokens.before(span.begin);
    if (tokens.word(after) == ",") {
      const std::uint32_t next = tokens.tokens()[after + 1].span.begin;
      const std::uint32_t comma = tokens.tokens()[after].span.end;
      const bool same_line = work_.text().substr(comma, next - comma).find('\n') == std::string_view::npos;
      work_.erase({span.begin, same_line ? next : comma});
    } else if (tokens.word(before) == ",") {
      work_.erase({tokens.tokens()[before].span.begin, span.end});
    } else {
      work_.erase(span);
    }
  };
  const cdl::Argument& argument = call.arguments[static_cast<std::size_t>(input.at)];
  if (input.item >= 0) {
    const auto& items = std::get<cdl::List>(argument.value->what).items;
    if (items.size() > 1) {
      erase_between_commas(there.place.span);
      return;
    }
  }
  const std::uint32_t begin =
      argument.name.text.empty() ? argument.value->place.span.begin : argument.name.place.span.begin;
  erase_between_commas({begin, argument.value->place.span.end});
  if (!argument.name.text.empty()) return;
  const std::optional<Callable> component = work_.model().components().find(call.callee.text);
  for (std::size_t i = static_cast<std::size_t>(input.at) + 1; i < call.arguments.size(); ++i) {
    const bool is_known = component && i < component->inputs.size() && call.arguments[i].name.text.empty();
    if (is_known) work_.insert(call.arguments[i].value->place.span.begin, component->inputs[i].name + " = ");
  }
}

void Editor::clear_operand(const Spot& spot) {
  const auto& logic = std::get<cdl::Logic>(spot.view.node(spot.node).expression->what);
  const auto at = static_cast<std::size_t>(spot.at()->at);
  const text::Span own = outer(*logic.operands[at]);
  if (logic.operands.size() < 3) {
    work_.replace(own, logic.connective == cdl::Connective::kAnd ? "true" : "false");
  } else if (at > 0) {
    work_.erase({outer(*logic.operands[at - 1]).end, own.end});
  } else {
    work_.erase({own.begin, outer(*logic.operands[1]).begin});
  }
}

void Editor::clear_member(const Spot& spot) {
  const GraphNode& node = spot.view.node(spot.node);
  const GraphInput& input = *spot.at();
  const cdl::Member& member = (*members_of(*node.expression))[static_cast<std::size_t>(input.at)];
  const bool has_weight = member.weight != nullptr;
  if (has_weight) {  // a node that was its weight is not lost
    Spot weight = spot;
    weight.input = spot.input + 1;
    if (inline_node(weight) >= 0) save_inline(weight);
  }
  const auto& first = has_weight ? member.weight : member.value;
  work_.erase_statement(is_logic(*first) ? outer(*first).begin : first->place.span.begin);
}

int Editor::follow(const PageView& view, int node) {
  const std::optional<Anchor> anchor = anchor_of(view.node(node), work_.tokens());
  return anchor ? work_.follow(*anchor) : -1;
}

std::optional<std::pair<PageView, int>> Editor::followed(const std::string& owner, int handle) const {
  const std::optional<std::uint32_t> anchor = handle < 0 ? std::nullopt : work_.where(handle);
  const OwnerGraph* graph = work_.model().graph(owner);
  if (!anchor || graph == nullptr) return std::nullopt;
  for (const GraphPage& page : graph->pages) {
    for (std::size_t i = 0; i < page.nodes.size(); ++i) {
      if (page.nodes[i].kind == GraphNode::Kind::kOuter || page.nodes[i].parameter != nullptr) continue;
      if (anchor_of(page.nodes[i], work_.tokens()) == anchor)
        return std::pair(PageView{graph, &page}, static_cast<int>(i));
    }
  }
  return std::nullopt;
}

}  // namespace mlab::designer
