#include "mlab/designer/edit/page_writer.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/drawing/components.h"
#include "mlab/designer/edit/values.h"

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

// ---- what is new at an input

// An argument that is not there yet, or one more item of a list.
Done write_argument(Workspace& work, const Spot& spot, const cdl::ExpressionPtr& what) {
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
      change_what<cdl::List>(work, *value, [what](cdl::List& now) { now.items.push_back(what); });
    } else {
      auto list = std::make_shared<cdl::Expression>();
      list->what = cdl::List{{value, what}};
      work.changes().replace(*value, list);
    }
    return true;
  }
  // Behind the last argument that the declaration has before it.
  const std::optional<Callable> component = work.model().components().find(call->callee.text);
  if (!component) return refusal(fmt::format("nothing answers to `{}`", call->callee.text));
  const auto rank = [&](const std::string& name) {
    return std::ranges::find(component->inputs, name, &Socket::name) - component->inputs.begin();
  };
  std::size_t at = 0;
  for (std::size_t i = 0; i < call->arguments.size(); ++i) {
    const std::string& name = call->arguments[i].name.text;
    if (name.empty() || rank(name) < rank(input.port)) at = i + 1;
  }
  work.changes().change<cdl::Call>(*call, [at, port = input.port, what](cdl::Call& now) {
    const auto where =
        now.arguments.begin() + static_cast<std::ptrdiff_t>(std::min(at, now.arguments.size()));
    now.arguments.insert(where, {{port, {}}, what});
  });
  return true;
}

void write_member(Workspace& work, const cdl::Expression& expression, const cdl::ExpressionPtr& what) {
  const bool is_weighted = call_of(expression) != nullptr;  // `coordinate by`, `fuse by`
  change_members(work, expression, [is_weighted, what](std::vector<cdl::Member>& now) {
    const bool has_weights = is_weighted && !now.empty() && now.front().weight != nullptr;
    now.push_back({has_weights ? value_of("1") : nullptr, what, ""});
  });
}

Done write_new(Workspace& work, const Spot& spot, const cdl::ExpressionPtr& what) {
  const OwnerGraph& graph = *spot.view.graph;
  if (!spot.drive.empty()) {
    work.changes().change<cdl::Robot>(*graph.robot, [name = spot.drive, what](cdl::Robot& now) {
      now.drives.push_back({{name, {}}, what});
    });
    return true;
  }
  if (spot.is_result()) {
    if (graph.assemblage == nullptr || spot.view.page->parent >= 0)
      return refusal("nothing can be given here");
    work.changes().change<cdl::Assemblage>(*graph.assemblage,
                                           [what](cdl::Assemblage& now) { now.body = what; });
    return true;
  }
  const cdl::Expression& expression = *spot.view.node(spot.node).expression;
  switch (spot.at()->role) {
    case Role::kArgument:
      return write_argument(work, spot, what);
    case Role::kMember:
      write_member(work, expression, what);
      return true;
    case Role::kWeight:
      work.changes().change<cdl::Member>(member_of(spot), [what](cdl::Member& now) { now.weight = what; });
      return true;
    case Role::kOperand:
      change_what<cdl::Logic>(work, expression, [what](cdl::Logic& now) { now.operands.push_back(what); });
      return true;
    case Role::kInitial:
      change_what<cdl::Delay>(work, expression, [what](cdl::Delay& now) { now.initial = what; });
      return true;
    default:
      return refusal("nothing can be put there");
  }
}

// ---- what goes from one

// Those behind it by position get their names.
void clear_argument(Workspace& work, const Spot& spot) {
  const GraphInput& input = *spot.at();
  const cdl::Call& call = *call_of(*spot.view.node(spot.node).expression);
  const auto at = static_cast<std::size_t>(input.at);
  const cdl::Argument& argument = call.arguments[at];
  if (input.item >= 0 && std::get<cdl::List>(argument.value->what).items.size() > 1) {
    change_what<cdl::List>(work, *argument.value, [item = input.item](cdl::List& now) {
      now.items.erase(now.items.begin() + item);
    });
    return;
  }
  work.changes().remove(argument);
  if (!argument.name.text.empty()) return;
  const std::optional<Callable> component = work.model().components().find(call.callee.text);
  for (std::size_t i = at + 1; i < call.arguments.size(); ++i) {
    if (component && i < component->inputs.size() && call.arguments[i].name.text.empty())
      work.changes().rename(call.arguments[i].name, component->inputs[i].name);
  }
}

void clear_operand(Workspace& work, const Spot& spot) {
  const cdl::Expression& expression = *spot.view.node(spot.node).expression;
  const auto& logic = std::get<cdl::Logic>(expression.what);
  const int at = spot.at()->at;
  if (logic.operands.size() < 3) {
    const bool is_and = logic.connective == cdl::Connective::kAnd;
    work.changes().replace(*logic.operands[static_cast<std::size_t>(at)], named(is_and ? "true" : "false"));
    return;
  }
  change_what<cdl::Logic>(work, expression,
                          [at](cdl::Logic& now) { now.operands.erase(now.operands.begin() + at); });
}

}  // namespace

// ---- lets

void add_lets(Workspace& work, const OwnerGraph& owner, std::vector<cdl::Let> lets) {
  const auto append = [lets = std::move(lets)](auto& now) {
    now.lets.insert(now.lets.end(), lets.begin(), lets.end());
  };
  if (owner.assemblage != nullptr)
    work.changes().change<cdl::Assemblage>(*owner.assemblage, append);
  else
    work.changes().change<cdl::Robot>(*owner.robot, append);
}

void PageWriter::add_let(const PageView& view, const std::string& name, cdl::ExpressionPtr value,
                         const std::string& help) {
  names_.give(*view.graph, name);
  add_lets(work_, *view.graph, std::vector{cdl::Let{{name, {}}, std::move(value), help}});
}

std::string PageWriter::save_inline(const Spot& spot) {
  const int at = spot.inline_node();
  const GraphNode& node = spot.view.node(at);
  const std::string base =
      !node.expression->as.text.empty() ? node.expression->as.text : default_name(*node.expression);
  // The name that it has, where only it would ask for it.
  std::string name = base;
  const std::size_t dot = node.name.rfind('.');
  const std::string local = dot == std::string::npos ? node.name : node.name.substr(dot + 1);
  if (is_own_name(local, base)) name = local;
  if (names_.is_taken(*spot.view.graph, name)) name = names_.free_name(*spot.view.graph, base);
  const bool is_member = spot.at() != nullptr && spot.at()->role == Role::kMember;
  add_let(spot.view, name, bare(*node.expression), is_member ? member_of(spot).help : "");
  return name;
}

std::string PageWriter::make_let(const Spot& spot) {
  const std::string name = save_inline(spot);
  work_.changes().replace(*spot.written(), named(name));
  return name;
}

// ---- what stands at an input

Done PageWriter::write(const Spot& spot, const cdl::ExpressionPtr& what) {
  const cdl::Expression* there = spot.written();
  if (there == nullptr) return write_new(work_, spot, what);
  if (spot.is_kept()) save_inline(spot);
  work_.changes().replace(*there, what);
  return true;
}

Done PageWriter::clear(const Spot& spot) {
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
      clear_argument(work_, spot);
      return true;
    case Role::kMember:
      clear_member(spot);
      return true;
    case Role::kOperand:
      clear_operand(work_, spot);
      return true;
    case Role::kWeight:
    case Role::kInitial:
    case Role::kActive:
      changes.replace(*there, nullptr);
      return true;
    case Role::kTerm:
      changes.replace(*there, zero_for(spot.view.graph->type_of(*there)));
      return true;
    case Role::kFormula:
      changes.replace(*there, neutral_for(spot.view.graph->type_of(*there)));
      return true;
    case Role::kDelayed:
      changes.replace(*there, value_of("[0, 0]"));
      return true;
    case Role::kSelector:
      changes.replace(*there, value_of("0"));
      return true;
    case Role::kCase:
      changes.replace(*there, neutral_for(spot.view.type_of(spot.node)));
      return true;
    case Role::kDrive:
      changes.remove(*node.drive);
      return true;
    default:
      return refusal("a name has to stand for something");
  }
}

void PageWriter::clear_member(const Spot& spot) {
  const cdl::Member& member = member_of(spot);
  if (member.weight) {  // a node that was its weight is not lost
    Spot weight = spot;
    weight.input = spot.input + 1;
    if (weight.inline_node() >= 0) save_inline(weight);
  }
  work_.changes().remove(member);
}

}  // namespace mlab::designer
