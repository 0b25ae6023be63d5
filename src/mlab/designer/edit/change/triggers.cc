#include "mlab/designer/edit/change/triggers.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "mlab/designer/drawing/shapes.h"
#include "mlab/designer/edit/find/sequences.h"
#include "mlab/designer/edit/values.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

cdl::ExpressionPtr joined(cdl::Connective connective, std::vector<cdl::ExpressionPtr> operands) {
  auto out = std::make_shared<cdl::Expression>();
  out->what = cdl::Logic{connective, std::move(operands)};
  return out;
}

const cdl::Logic* logic_of(const cdl::ExpressionPtr& expression, cdl::Connective connective) {
  const auto* logic = std::get_if<cdl::Logic>(&expression->what);
  return logic != nullptr && logic->connective == connective ? logic : nullptr;
}

/// A part of a trigger, with all that it stands in.
class Part {
 public:
  /// Null where the trigger has no such part.
  static std::optional<Part> of(const cdl::ExpressionPtr& trigger, const auto& way) {
    Part out;
    out.chain_.push_back(trigger);
    for (const std::uint32_t operand : way) {
      const auto* logic = std::get_if<cdl::Logic>(&out.chain_.back()->what);
      if (logic == nullptr || operand >= logic->operands.size()) return std::nullopt;
      out.places_.push_back(operand);
      out.chain_.push_back(logic->operands[operand]);
    }
    return out;
  }

  const cdl::ExpressionPtr& expression() const { return chain_.back(); }
  bool is_whole() const { return places_.empty(); }
  const cdl::ExpressionPtr& outer() const { return chain_[chain_.size() - 2]; }
  const cdl::Logic& outer_logic() const { return std::get<cdl::Logic>(outer()->what); }
  /// Among the operands of the outer one.
  std::size_t place() const { return places_.back(); }
  void go_out() {
    chain_.pop_back();
    places_.pop_back();
  }

 private:
  std::vector<cdl::ExpressionPtr> chain_;  // the trigger first
  std::vector<std::size_t> places_;
};

std::vector<cdl::ExpressionPtr> operands_of(const cdl::ExpressionPtr& expression,
                                            cdl::Connective connective) {
  const cdl::Logic* logic = logic_of(expression, connective);
  return logic == nullptr ? std::vector{expression} : logic->operands;
}

// Operands of operands are of the outer one where both join alike: `and` in an `and` says nothing.
void put(cdl::Changes& changes, const Part& part, const cdl::ExpressionPtr& by) {
  const auto* logic = std::get_if<cdl::Logic>(&by->what);
  const bool is_alike = logic != nullptr && !part.is_whole() && logic->connective != cdl::Connective::kNot &&
                        logic->connective == part.outer_logic().connective;
  if (!is_alike) {
    changes.replace(*part.expression(), by);
    return;
  }
  changes.change<cdl::Logic>(
      part.outer_logic(), [operands = logic->operands, place = part.place()](cdl::Logic& now) {
        const auto at = now.operands.erase(now.operands.begin() + static_cast<std::ptrdiff_t>(place));
        now.operands.insert(at, operands.begin(), operands.end());
      });
}

void join(cdl::Changes& changes, const Part& part, cdl::Connective connective,
          const cdl::ExpressionPtr& other) {
  std::vector<cdl::ExpressionPtr> operands = operands_of(part.expression(), connective);
  operands.push_back(other);
  put(changes, part, joined(connective, std::move(operands)));
}

void negate(cdl::Changes& changes, const Part& part) {
  if (const cdl::Logic* own = logic_of(part.expression(), cdl::Connective::kNot)) {
    put(changes, part, bare(*own->operands.front()));
  } else if (!part.is_whole() && part.outer_logic().connective == cdl::Connective::kNot) {
    Part outer = part;
    outer.go_out();
    put(changes, outer, bare(*part.expression()));
  } else {
    put(changes, part, joined(cdl::Connective::kNot, {part.expression()}));
  }
}

void switch_over(cdl::Changes& changes, const Part& part, cdl::Connective to) {
  std::vector<cdl::ExpressionPtr> operands;
  for (const cdl::ExpressionPtr& old : std::get<cdl::Logic>(part.expression()->what).operands) {
    const std::vector<cdl::ExpressionPtr> more = operands_of(old, to);
    operands.insert(operands.end(), more.begin(), more.end());
  }
  put(changes, part, joined(to, std::move(operands)));
}

// What is alone then needs no `and`.
void take_away(cdl::Changes& changes, Part part) {
  while (!part.is_whole() && part.outer_logic().connective == cdl::Connective::kNot) part.go_out();
  if (part.is_whole()) {
    changes.replace(*part.expression(), no_trigger());
    return;
  }
  const cdl::Logic& logic = part.outer_logic();
  const std::size_t place = part.place();
  if (logic.operands.size() == 2) {
    const cdl::ExpressionPtr left = bare(*logic.operands[1 - place]);
    part.go_out();
    put(changes, part, left);
    return;
  }
  changes.change<cdl::Logic>(logic, [place](cdl::Logic& now) {
    now.operands.erase(now.operands.begin() + static_cast<std::ptrdiff_t>(place));
  });
}

text::Result<cdl::ExpressionPtr> condition_of(const Components& components, const std::string& component) {
  if (component == kComparison) return value_of(kComparisonWords);
  const std::optional<Callable>& found = components.find(component);
  if (!found) return refusal(fmt::format("nothing answers to `{}`", text::shown(component)));
  const std::string reason = why_not(found->output, components.types().named("bool"));
  if (found->gives_nothing || !reason.empty())
    return refusal(fmt::format("`{}` is no trigger: it gives no truth value", component));
  return called(component);
}

// Arguments of a call that the other one takes as well.
cdl::ExpressionPtr chosen(const Components& components, const cdl::Expression& old, const Callable& component,
                          const OwnerGraph& graph) {
  auto out = std::make_shared<cdl::Expression>();
  auto& call = out->what.emplace<cdl::Call>();
  call.callee.text = component.name;
  const auto* before = std::get_if<cdl::Call>(&old.what);
  if (before == nullptr) return out;
  const std::optional<Callable>& replaced = components.find(before->callee.text);
  if (!replaced) return out;
  for (std::size_t i = 0; i < before->arguments.size(); ++i) {
    const cdl::Argument& argument = before->arguments[i];
    const bool has_name = !argument.name.text.empty();
    if (!has_name && i >= replaced->inputs.size()) continue;
    const std::string& name = has_name ? argument.name.text : replaced->inputs[i].name;
    const auto had = std::ranges::find(replaced->inputs, name, &Socket::name);
    const auto takes = std::ranges::find(component.inputs, name, &Socket::name);
    if (had == replaced->inputs.end() || takes == component.inputs.end()) continue;
    const cdl::PortType type = has_node(*argument.value) ? graph.type_of(*argument.value) : had->type;
    if (why_not(type, takes->type).empty()) call.arguments.push_back({{name, {}}, argument.value});
  }
  return out;
}

}  // namespace

Done change_trigger(Workspace& work, const ChangeTrigger& change) {
  const auto found = find_transition(work.model(), change.page(), change.from(), change.index());
  if (!found) return std::unexpected(found.error());
  const text::Result<PageView> view = find_page(work.model(), change.page());
  const cdl::ExpressionPtr& trigger = (*found)->trigger;
  const std::optional<Part> part = trigger ? Part::of(trigger, change.part()) : std::nullopt;
  if (!part) return refusal("that part of the trigger has gone");
  cdl::Changes& changes = work.changes();
  switch (change.how()) {
    case ChangeTrigger::CHOOSE:
    case ChangeTrigger::AND:
    case ChangeTrigger::OR: {
      const text::Result<cdl::ExpressionPtr> other =
          condition_of(work.model().components(), change.component());
      if (!other) return std::unexpected(other.error());
      if (change.how() == ChangeTrigger::CHOOSE) {
        const std::optional<Callable> component = work.model().components().find(change.component());
        changes.replace(*part->expression(), component ? chosen(work.model().components(),
                                                                *part->expression(), *component, *view->graph)
                                                       : *other);
      } else {
        const bool is_and = change.how() == ChangeTrigger::AND;
        join(changes, *part, is_and ? cdl::Connective::kAnd : cdl::Connective::kOr, *other);
      }
      break;
    }
    case ChangeTrigger::NOT:
      negate(changes, *part);
      break;
    case ChangeTrigger::SWITCH: {
      const bool is_and = logic_of(part->expression(), cdl::Connective::kAnd) != nullptr;
      if (!is_and && logic_of(part->expression(), cdl::Connective::kOr) == nullptr)
        return refusal("only `and` becomes `or`, and the other way round");
      switch_over(changes, *part, is_and ? cdl::Connective::kOr : cdl::Connective::kAnd);
      break;
    }
    case ChangeTrigger::REMOVE:
      take_away(changes, *part);
      break;
    default:
      return refusal("this is no way to change a trigger");
  }
  return work.commit();
}

Done place_in_trigger(PageWriter& pages, const PageView& view, const Place& change) {
  Workspace& work = pages.work();
  const text::Result<Spot> to = find_spot(view, change.to_node(), change.to_port(), std::nullopt, true);
  if (!to) return std::unexpected(to.error());
  const std::optional<Callable> component = work.model().components().find(change.component());
  if (change.component() == kComparison) {
    const Done done = pages.write(*to, value_of(kComparisonWords));
    return done ? work.commit() : done;
  }
  if (!component || component->gives_nothing) return refusal("a trigger asks components that give something");
  if (const std::string reason = why_not(component->output, wanted_type(work.model(), *to)); !reason.empty())
    return refusal(reason);
  const Done done = pages.write(*to, called(change.component()));
  return done ? work.commit() : done;
}

}  // namespace mlab::designer
