// Primitives: what stands at an input, and the `let`s of nodes that stand alone.

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/drawing/shapes.h"
#include "mlab/designer/edit/editor.h"
#include "mlab/designer/edit/values.h"
#include "mlab/flow/value_types.h"
#include "mlab/lang/cdl/types/units.h"

namespace mlab::designer {
namespace {

// What of an expression is changed, by its kind.
template <class What>
void change_what(Workspace& work, const cdl::Expression& expression, std::function<void(What&)> how) {
  work.changes().change<What>(std::get<What>(expression.what), std::move(how));
}

// The members of an operator, whichever it is.
void change_members(Workspace& work, const cdl::Expression& expression,
                    const std::function<void(std::vector<cdl::Member>&)>& how) {
  std::visit(
      [&]<class What>(const What& what) {
        if constexpr (requires { what.members; })
          work.changes().change<What>(what, [how](What& now) { how(now.members); });
      },
      expression.what);
}

const cdl::Member& member_of(const Spot& spot) {
  const auto& members = *members_of(*spot.view.node(spot.node).expression);
  return members[static_cast<std::size_t>(spot.at()->at)];
}

}  // namespace

bool Editor::takes(const Spot& spot, const cdl::Expression& expression) const {
  const GraphInput* input = spot.at();
  const Role role = input == nullptr ? Role::kMember : input->role;
  const bool is_line =
      role == Role::kMember || role == Role::kDrive || role == Role::kCase || role == Role::kValue;
  if (is_block(expression)) return is_line;
  return role != Role::kWeight || std::holds_alternative<cdl::Call>(expression.what);
}

cdl::ExpressionPtr Editor::neutral(const cdl::PortType& type) const {
  const auto is = [&](flow::TypeKind kind) { return type.type != nullptr && type.type->kind == kind; };
  if (is(flow::TypeKind::kBool)) return named("false");
  if (is(flow::TypeKind::kVector)) return called(std::string(flow::info(flow::ValueType::kVector).neutral));
  return value_of(is(flow::TypeKind::kPoint) ? "[0, 0]" : "0");
}

namespace {

// 0 in a unit that only products have: no number is written in it.
std::string zero_in(std::string_view unit) {
  std::string out = "0";
  for (const char* sign = " * "; !unit.empty();) {
    const std::size_t end = std::min(unit.find_first_of("*/"), unit.size());
    const std::string_view word = unit.substr(0, end);
    if (word != "1") out += fmt::format("{}1 {}", sign, word);
    if (end == unit.size()) break;
    sign = unit[end] == '/' ? " / " : " * ";
    unit.remove_prefix(end + 1);
  }
  return out;
}

}  // namespace

// What a formula has in the place of what it read.
cdl::ExpressionPtr Editor::zero_of(const cdl::PortType& type) const {
  const bool is_number = type.type != nullptr && type.type->kind == flow::TypeKind::kReal;
  const bool is_vector = type.type != nullptr && type.type->kind == flow::TypeKind::kVector;
  if (is_vector) return value_of("[0, 0]");
  const auto unit = is_number && !type.unit.empty() ? cdl::unit_named(type.unit) : std::nullopt;
  const bool is_written = unit && std::ranges::find(cdl::unit_names(), type.unit) != cdl::unit_names().end();
  const auto value = is_written ? value_of("0 " + type.unit) : unit ? value_of(zero_in(type.unit)) : nullptr;
  return value ? value : neutral(type);
}

// ---- names

bool Editor::is_taken(const PageView& view, std::string_view name) const {
  const auto is_it = [&](const auto& one) { return one.name.text == name; };
  return std::ranges::any_of(view.graph->lets(), is_it) ||
         std::ranges::any_of(view.graph->parameters(), is_it) ||
         given_names_.contains({view.graph->name, std::string(name)});
}

std::string Editor::free_name(const PageView& view, const std::string& wanted) const {
  std::set<std::string> taken;
  for (const cdl::Let& let : view.graph->lets()) taken.insert(let.name.text);
  for (const cdl::Parameter& parameter : view.graph->parameters()) taken.insert(parameter.name.text);
  for (const auto& [owner, name] : given_names_) {
    if (owner == view.graph->name) taken.insert(name);
  }
  const GraphPage& own = view.graph->pages.front();
  for (const GraphNode& node : own.nodes) taken.insert(node.name);
  if (own.sequence != nullptr) {
    for (const cdl::State& state : own.sequence->states) taken.insert(state.name.text);
  }
  return unique(wanted, taken);
}

// ---- lets

std::string Editor::add_let(const PageView& view, const std::string& name, cdl::ExpressionPtr value,
                            const std::string& help) {
  given_names_.emplace(view.graph->name, name);
  change_owner(view, [name, value = std::move(value), help](auto& now) {
    now.lets.push_back({{name, {}}, value, help});
  });
  return name;
}

std::string Editor::save_inline(const Spot& spot) {
  const int at = spot.inline_node();
  const GraphNode& node = spot.view.node(at);
  const std::string base =
      !node.expression->as.text.empty() ? node.expression->as.text : default_name(*node.expression);
  // The name that it has, where only it would ask for it.
  std::string name = base;
  const std::size_t dot = node.name.rfind('.');
  const std::string local = dot == std::string::npos ? node.name : node.name.substr(dot + 1);
  if (is_own_name(local, base)) name = local;
  if (is_taken(spot.view, name)) name = free_name(spot.view, base);
  const bool is_member = spot.at() != nullptr && spot.at()->role == Role::kMember;
  return add_let(spot.view, name, bare(*node.expression), is_member ? member_of(spot).help : "");
}

std::string Editor::make_let(const Spot& spot) {
  const std::string name = save_inline(spot);
  work_.changes().replace(*spot.written(), named(name));
  return name;
}

// ---- what stands at an input

Done Editor::write(const Spot& spot, const cdl::ExpressionPtr& what) {
  const cdl::Expression* there = spot.written();
  if (there == nullptr) return write_new(spot, what);
  if (spot.is_kept()) save_inline(spot);
  work_.changes().replace(*there, what);
  return true;
}

Done Editor::write_new(const Spot& spot, const cdl::ExpressionPtr& what) {
  const OwnerGraph& graph = *spot.view.graph;
  if (!spot.drive.empty()) {
    work_.changes().change<cdl::Robot>(*graph.robot, [name = spot.drive, what](cdl::Robot& now) {
      now.drives.push_back({{name, {}}, what});
    });
    return true;
  }
  if (spot.is_result()) {
    if (graph.assemblage == nullptr || spot.view.page->parent >= 0)
      return refusal("nothing can be given here");
    work_.changes().change<cdl::Assemblage>(*graph.assemblage,
                                            [what](cdl::Assemblage& now) { now.body = what; });
    return true;
  }
  const cdl::Expression& expression = *spot.view.node(spot.node).expression;
  switch (spot.at()->role) {
    case Role::kArgument:
      return write_argument(spot, what);
    case Role::kMember:
      write_member(expression, what);
      return true;
    case Role::kWeight:
      work_.changes().change<cdl::Member>(member_of(spot), [what](cdl::Member& now) { now.weight = what; });
      return true;
    case Role::kOperand:
      change_what<cdl::Logic>(work_, expression, [what](cdl::Logic& now) { now.operands.push_back(what); });
      return true;
    case Role::kInitial:
      change_what<cdl::Delay>(work_, expression, [what](cdl::Delay& now) { now.initial = what; });
      return true;
    default:
      return refusal("nothing can be put there");
  }
}

void Editor::write_member(const cdl::Expression& expression, const cdl::ExpressionPtr& what) {
  const bool is_weighted = call_of(expression) != nullptr;  // `coordinate by`, `fuse by`
  change_members(work_, expression, [is_weighted, what](std::vector<cdl::Member>& now) {
    const bool has_weights = is_weighted && !now.empty() && now.front().weight != nullptr;
    now.push_back({has_weights ? value_of("1") : nullptr, what, ""});
  });
}

// An argument that is not there yet, or one more item of a list.
Done Editor::write_argument(const Spot& spot, const cdl::ExpressionPtr& what) {
  const GraphInput& input = *spot.at();
  const GraphNode& node = spot.view.node(spot.node);
  const cdl::Call* call = call_of(*node.expression);
  if (call == nullptr) return refusal("this takes no inputs");
  const GraphInput* last = nullptr;
  for (const GraphInput& other : node.inputs) {
    if (input.is_open && other.port == input.port && !other.is_open && other.written) last = &other;
  }
  if (last != nullptr) {
    const cdl::ExpressionPtr& value = call->arguments[static_cast<std::size_t>(last->at)].value;
    if (last->item >= 0) {
      change_what<cdl::List>(work_, *value, [what](cdl::List& now) { now.items.push_back(what); });
    } else {
      auto list = std::make_shared<cdl::Expression>();
      list->what = cdl::List{{value, what}};
      work_.changes().replace(*value, list);
    }
    return true;
  }
  // Behind the last argument that the declaration has before it.
  const std::optional<Callable> component = work_.model().components().find(call->callee.text);
  if (!component) return refusal(fmt::format("nothing answers to `{}`", call->callee.text));
  const auto rank = [&](const std::string& name) {
    return std::ranges::find(component->inputs, name, &Socket::name) - component->inputs.begin();
  };
  std::size_t at = 0;
  for (std::size_t i = 0; i < call->arguments.size(); ++i) {
    const std::string& name = call->arguments[i].name.text;
    if (name.empty() || rank(name) < rank(input.port)) at = i + 1;
  }
  work_.changes().change<cdl::Call>(*call, [at, port = input.port, what](cdl::Call& now) {
    const auto where =
        now.arguments.begin() + static_cast<std::ptrdiff_t>(std::min(at, now.arguments.size()));
    now.arguments.insert(where, {{port, {}}, what});
  });
  return true;
}

Done Editor::clear(const Spot& spot) {
  const cdl::Expression* there = spot.written();
  if (there == nullptr) return true;
  if (spot.is_kept()) save_inline(spot);
  cdl::Changes& changes = work_.changes();
  if (spot.is_result()) {
    const bool is_inner = spot.view.page->parent >= 0 || spot.view.graph->assemblage == nullptr;
    changes.replace(*there, is_inner ? called("Stand") : nullptr);
    return true;
  }
  const GraphNode& node = spot.view.node(spot.node);
  switch (spot.at()->role) {
    case Role::kArgument:
      clear_argument(spot);
      return true;
    case Role::kMember:
      clear_member(spot);
      return true;
    case Role::kOperand:
      clear_operand(spot);
      return true;
    case Role::kWeight:
    case Role::kInitial:
    case Role::kActive:
      changes.replace(*there, nullptr);
      return true;
    case Role::kTerm:
      changes.replace(*there, zero_of(spot.view.graph->type_of(*there)));
      return true;
    case Role::kFormula:
      changes.replace(*there, neutral(spot.view.graph->type_of(*there)));
      return true;
    case Role::kDelayed:
      changes.replace(*there, value_of("[0, 0]"));
      return true;
    case Role::kSelector:
      changes.replace(*there, value_of("0"));
      return true;
    case Role::kCase:
      changes.replace(*there, neutral(spot.view.type_of(spot.node)));
      return true;
    case Role::kDrive:
      changes.remove(*node.drive);
      return true;
    default:
      return refusal("a name has to stand for something");
  }
}

// Those behind it by position get their names.
void Editor::clear_argument(const Spot& spot) {
  const GraphInput& input = *spot.at();
  const cdl::Call& call = *call_of(*spot.view.node(spot.node).expression);
  const auto at = static_cast<std::size_t>(input.at);
  const cdl::Argument& argument = call.arguments[at];
  if (input.item >= 0 && std::get<cdl::List>(argument.value->what).items.size() > 1) {
    change_what<cdl::List>(work_, *argument.value, [item = input.item](cdl::List& now) {
      now.items.erase(now.items.begin() + item);
    });
    return;
  }
  work_.changes().remove(argument);
  if (!argument.name.text.empty()) return;
  const std::optional<Callable> component = work_.model().components().find(call.callee.text);
  for (std::size_t i = at + 1; i < call.arguments.size(); ++i) {
    if (component && i < component->inputs.size() && call.arguments[i].name.text.empty())
      work_.changes().rename(call.arguments[i].name, component->inputs[i].name);
  }
}

void Editor::clear_operand(const Spot& spot) {
  const cdl::Expression& expression = *spot.view.node(spot.node).expression;
  const auto& logic = std::get<cdl::Logic>(expression.what);
  const int at = spot.at()->at;
  if (logic.operands.size() < 3) {
    const bool is_and = logic.connective == cdl::Connective::kAnd;
    work_.changes().replace(*logic.operands[static_cast<std::size_t>(at)], named(is_and ? "true" : "false"));
    return;
  }
  change_what<cdl::Logic>(work_, expression,
                          [at](cdl::Logic& now) { now.operands.erase(now.operands.begin() + at); });
}

void Editor::clear_member(const Spot& spot) {
  const cdl::Member& member = member_of(spot);
  if (member.weight) {  // a node that was its weight is not lost
    Spot weight = spot;
    weight.input = spot.input + 1;
    if (weight.inline_node() >= 0) save_inline(weight);
  }
  work_.changes().remove(member);
}

}  // namespace mlab::designer
