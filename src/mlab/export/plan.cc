#include "mlab/export/plan.h"

#include <deque>
#include <map>
#include <utility>

#include <fmt/core.h>

#include "mlab/lang/cdl/types/units.h"

namespace mlab::exports {
namespace {

using cdl::Expression;

constexpr int kMaxDepth = 200;

/// What names stand for where an expression is read.
struct Scope {
  struct Bound {
    const Expression* expression = nullptr;
    const Scope* scope = nullptr;
  };
  std::map<std::string, Bound, std::less<>> names;
};

class Planner {
 public:
  Planner(const Subject& subject, const char* format, text::Diagnostics& sink)
      : subject_(subject), format_(format), sink_(sink) {}

  std::unique_ptr<Plan> run() {
    const cdl::Robot& robot = subject_.robot;
    const std::size_t errors_before = sink_.error_count();
    Scope& scope = new_scope(robot.parameters, robot.lets);
    std::unique_ptr<Plan> out;
    if (!robot.drives.empty() && robot.drives.front().value) {
      const Scope::Bound member = reduced({robot.drives.front().value.get(), &scope});
      if (const auto* sequence = std::get_if<cdl::Sequence>(&member.expression->what))
        out = plan(*sequence, *member.scope, member.expression->place);
    }
    if (!out && sink_.error_count() == errors_before) {
      sink_
          .error("no-sequence", robot.name.place,
                 fmt::format("what robot `{}` does is no sequence", robot.name.text))
          .hints = {
          fmt::format("{} takes a `sequence {{ ... }}` of skills, or an assemblage that is one", format_)};
    }
    if (sink_.error_count() > errors_before) return nullptr;
    if (out) out->name = robot.name.text;
    return out;
  }

 private:
  Scope& new_scope(const std::vector<cdl::Parameter>& parameters, const std::vector<cdl::Let>& lets) {
    Scope& scope = scopes_.emplace_back();
    for (const cdl::Parameter& one : parameters) {
      if (one.initial) scope.names[one.name.text] = {one.initial.get(), &scope};
    }
    for (const cdl::Let& let : lets) {
      if (let.value) scope.names[let.name.text] = {let.value.get(), &scope};
    }
    return scope;
  }

  const cdl::Assemblage* assemblage(const cdl::Call& call) const {
    const auto found = subject_.configuration.assemblages.find(call.callee.text);
    return found == subject_.configuration.assemblages.end() ? nullptr : found->second;
  }

  const Scope& inside(const cdl::Assemblage& assemblage, const cdl::Call& call, const Scope& outer) {
    Scope& scope = new_scope(assemblage.parameters, assemblage.lets);
    for (std::size_t i = 0; i < call.arguments.size(); ++i) {
      const cdl::Argument& argument = call.arguments[i];
      std::string name = argument.name.text;
      if (name.empty() && i < assemblage.parameters.size()) name = assemblage.parameters[i].name.text;
      if (argument.value) scope.names[name] = {argument.value.get(), &outer};
    }
    return scope;
  }

  // Through names, operators with one member, and assemblages that only call another or are a sequence.
  Scope::Bound reduced(Scope::Bound at) {
    for (int i = 0; i < kMaxDepth; ++i) {
      const Expression& expression = *at.expression;
      if (const auto* name = std::get_if<cdl::Name>(&expression.what)) {
        const auto bound = at.scope->names.find(name->name.text);
        if (bound == at.scope->names.end()) return at;
        at = bound->second;
      } else if (const cdl::ExpressionPtr only = only_member(expression)) {
        at.expression = only.get();
      } else if (const auto* call = std::get_if<cdl::Call>(&expression.what)) {
        const cdl::Assemblage* called = assemblage(*call);
        if (called == nullptr || !called->body || !opens(*called)) return at;
        at = {called->body.get(), &inside(*called, *call, *at.scope)};
      } else {
        return at;
      }
    }
    return at;
  }
  static cdl::ExpressionPtr only_member(const Expression& expression) {
    const std::vector<cdl::Member>* members = nullptr;
    if (const auto* cooperate = std::get_if<cdl::Cooperate>(&expression.what)) members = &cooperate->members;
    if (const auto* compete = std::get_if<cdl::Compete>(&expression.what)) members = &compete->members;
    return members != nullptr && members->size() == 1 ? members->front().value : nullptr;
  }
  bool opens(const cdl::Assemblage& called) const {
    const Expression& body = *called.body;
    if (std::holds_alternative<cdl::Sequence>(body.what)) return true;
    if (const cdl::ExpressionPtr only = only_member(body))
      return std::holds_alternative<cdl::Call>(only->what);
    const auto* call = std::get_if<cdl::Call>(&body.what);
    return call != nullptr && assemblage(*call) != nullptr;
  }

  std::unique_ptr<Plan> plan(const cdl::Sequence& sequence, const Scope& scope, const text::Place& place) {
    auto out = std::make_unique<Plan>();
    out->place = place;
    if (++depth_ > kMaxDepth) {
      sink_.error("nested-too-deep", place,
                  fmt::format("sequences stand in each other more than {} deep", kMaxDepth));
      return out;
    }
    for (std::size_t i = 0; i < sequence.states.size(); ++i) {
      if (sequence.states[i].is_start) out->start = i;
      out->steps.push_back(step(sequence.states[i], sequence, scope));
    }
    --depth_;
    return out;
  }

  Step step(const cdl::State& state, const cdl::Sequence& sequence, const Scope& scope) {
    Step out;
    out.name = state.name.text;
    out.is_final = state.is_final;
    out.place = state.name.place;
    if (state.member) {
      const Scope::Bound member = reduced({state.member.get(), &scope});
      if (const auto* inner = std::get_if<cdl::Sequence>(&member.expression->what)) {
        out.plan = plan(*inner, *member.scope, member.expression->place);
      } else if (std::holds_alternative<cdl::Call>(member.expression->what)) {
        out.skill = value(member);
      } else {
        sink_
            .error("no-skill", member.expression->place,
                   fmt::format("the member of state `{}` is no skill", state.name.text))
            .hints = {fmt::format(
            "{} has no operators inside of a step: make an assemblage of it, and call that here", format_)};
      }
    }
    for (const cdl::Transition& transition : state.transitions) {
      Step::Exit exit;
      exit.condition = condition({transition.trigger.get(), &scope});
      exit.restarts = transition.restarts;
      exit.place = transition.target.place;
      for (std::size_t i = 0; i < sequence.states.size(); ++i) {
        if (sequence.states[i].name.text == transition.target.text) exit.target = i;
      }
      out.exits.push_back(std::move(exit));
    }
    return out;
  }

  Condition condition(Scope::Bound at) {
    at = named(at);
    Condition out;
    const auto* logic = std::get_if<cdl::Logic>(&at.expression->what);
    if (logic == nullptr || ++depth_ > kMaxDepth) {
      out.value = value(at);
      return out;
    }
    out.kind = logic->connective == cdl::Connective::kNot   ? Condition::Kind::kNot
               : logic->connective == cdl::Connective::kAnd ? Condition::Kind::kAnd
                                                            : Condition::Kind::kOr;
    for (const cdl::ExpressionPtr& operand : logic->operands)
      out.operands.push_back(condition({operand.get(), at.scope}));
    --depth_;
    return out;
  }

  static Scope::Bound named(Scope::Bound at) {
    for (int i = 0; i < kMaxDepth; ++i) {
      const auto* name = std::get_if<cdl::Name>(&at.expression->what);
      if (name == nullptr) break;
      const auto bound = at.scope->names.find(name->name.text);
      if (bound == at.scope->names.end() || bound->second.expression == at.expression) break;
      at = bound->second;
    }
    return at;
  }

  Value value(Scope::Bound at) {
    at = named(at);
    Value out;
    if (++depth_ > kMaxDepth) {
      sink_.error("nested-too-deep", at.expression->place, "calls stand in each other too deep");
      return out;
    }
    if (const auto* number = std::get_if<cdl::Number>(&at.expression->what)) {
      const auto unit = cdl::unit_named(number->unit.text);
      out.kind = Value::Kind::kNumber;
      out.number = unit ? number->value * unit->numerator / unit->denominator : number->value;
    } else if (const auto* text = std::get_if<cdl::Text>(&at.expression->what)) {
      out.kind = Value::Kind::kText;
      out.text = text->value;
    } else if (const auto* name = std::get_if<cdl::Name>(&at.expression->what)) {
      out.text = name->name.text;
    } else if (const auto* list = std::get_if<cdl::List>(&at.expression->what)) {
      out.kind = Value::Kind::kList;
      for (const cdl::ExpressionPtr& item : list->items) out.items.push_back(value({item.get(), at.scope}));
    } else if (const auto* call = std::get_if<cdl::Call>(&at.expression->what)) {
      out = called(*call, *at.scope);
    } else {
      sink_
          .error("no-skill", at.expression->place, fmt::format("{} takes a constant or a call here", format_))
          .hints = {"make an assemblage of it, and call that here"};
    }
    --depth_;
    return out;
  }

  // Arguments by name: those that are given, then the defaults of an assemblage.
  Value called(const cdl::Call& call, const Scope& scope) {
    Value out;
    out.kind = Value::Kind::kCall;
    out.text = call.callee.text;
    const cdl::Assemblage* assemblage = this->assemblage(call);
    if (assemblage != nullptr) {
      const Scope& inner = inside(*assemblage, call, scope);
      for (const cdl::Parameter& parameter : assemblage->parameters) {
        const auto bound = inner.names.find(parameter.name.text);
        if (bound != inner.names.end()) out.arguments.push_back({parameter.name.text, value(bound->second)});
      }
      return out;
    }
    const flow::Behavior* behavior = subject_.library.find(call.callee.text).behavior;
    const auto binding = subject_.configuration.bindings.find(call.callee.text);
    for (std::size_t i = 0; i < call.arguments.size(); ++i) {
      const cdl::Argument& argument = call.arguments[i];
      std::string name = argument.name.text;
      if (name.empty() && binding != subject_.configuration.bindings.end() &&
          i < binding->second->parameters.size())
        name = binding->second->parameters[i].name.text;
      else if (name.empty() && behavior != nullptr && i < behavior->inputs.size())
        name = behavior->inputs[i].name;
      if (argument.value) out.arguments.push_back({name, value({argument.value.get(), &scope})});
    }
    return out;
  }

  const Subject& subject_;
  const char* format_;
  text::Diagnostics& sink_;
  std::deque<Scope> scopes_;
  int depth_ = 0;
};

}  // namespace

std::unique_ptr<Plan> plan_of(const Subject& subject, const char* format, text::Diagnostics& sink) {
  return Planner(subject, format, sink).run();
}

}  // namespace mlab::exports
