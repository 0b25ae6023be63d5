#pragma once

#include <concepts>
#include <tuple>
#include <type_traits>

#include "mlab/lang/cdl/syntax/tree.h"

// What each construct of the tree consists of: its words, expressions and statements, in the order of its
// members. For whoever goes through all of them alike.

namespace mlab::cdl {

template <class X, class Construct>
concept Is = std::same_as<std::remove_const_t<X>, Construct>;

auto parts(Is<Hole> auto& /*has none*/) {
  return std::tie();
}
auto parts(Is<Text> auto& /*has none*/) {
  return std::tie();
}
auto parts(Is<Number> auto& x) {
  return std::tie(x.unit);
}
auto parts(Is<Name> auto& x) {
  return std::tie(x.name);
}
auto parts(Is<List> auto& x) {
  return std::tie(x.items);
}
auto parts(Is<Argument> auto& x) {
  return std::tie(x.name, x.value);
}
auto parts(Is<Call> auto& x) {
  return std::tie(x.callee, x.arguments);
}
auto parts(Is<Logic> auto& x) {
  return std::tie(x.operands);
}
auto parts(Is<Arithmetic> auto& x) {
  return std::tie(x.operands);
}
auto parts(Is<Member> auto& x) {
  return std::tie(x.weight, x.value);
}
auto parts(Is<Cooperate> auto& x) {
  return std::tie(x.members);
}
auto parts(Is<Compete> auto& x) {
  return std::tie(x.rule_word, x.members);
}
auto parts(Is<Coordinate> auto& x) {
  return std::tie(x.by, x.members);
}
auto parts(Is<Fuse> auto& x) {
  return std::tie(x.by, x.members);
}
auto parts(Is<Transition> auto& x) {
  return std::tie(x.trigger, x.target);
}
auto parts(Is<State> auto& x) {
  return std::tie(x.name, x.member, x.transitions);
}
auto parts(Is<Sequence> auto& x) {
  return std::tie(x.states);
}
auto parts(Is<Case> auto& x) {
  return std::tie(x.values, x.member);
}
auto parts(Is<Select> auto& x) {
  return std::tie(x.by, x.cases);
}
auto parts(Is<Delay> auto& x) {
  return std::tie(x.value, x.initial);
}
auto parts(Is<Expression> auto& x) {
  return std::tie(x.what, x.as, x.active);
}
auto parts(Is<Parameter> auto& x) {
  return std::tie(x.name, x.type, x.unit, x.initial);
}
auto parts(Is<Let> auto& x) {
  return std::tie(x.name, x.value);
}
auto parts(Is<Assemblage> auto& x) {
  return std::tie(x.name, x.parameters, x.result_type, x.lets, x.body, x.historic_names);
}
auto parts(Is<Binding> auto& x) {
  return std::tie(x.name, x.parameters, x.result_type);
}
auto parts(Is<Device> auto& x) {
  return std::tie(x.name, x.by, x.binds);
}
auto parts(Is<BodySetting> auto& x) {
  return std::tie(x.name, x.value);
}
auto parts(Is<RobotClass> auto& x) {
  return std::tie(x.name, x.parameters, x.body, x.devices);
}
auto parts(Is<Drive> auto& x) {
  return std::tie(x.binding, x.value);
}
auto parts(Is<Choice> auto& x) {
  return std::tie(x.device, x.binding);
}
auto parts(Is<Robot> auto& x) {
  return std::tie(x.name, x.parameters, x.class_name, x.lets, x.choices, x.drives);
}
auto parts(Is<SocietyMember> auto& x) {
  return std::tie(x.name, x.members, x.by);
}
auto parts(Is<Society> auto& x) {
  return std::tie(x.name, x.what);
}
auto parts(Is<SocietyOperator> auto& x) {
  return std::tie(x.name, x.devices);
}
auto parts(Is<TestStep> auto& x) {
  return std::tie(x.percept, x.span, x.condition, x.fact);
}
auto parts(Is<Test> auto& x) {
  return std::tie(x.name, x.subject, x.class_name, x.lets, x.steps);
}
auto parts(Is<Use> auto& x) {
  return std::tie(x.path);
}
auto parts(Is<Architecture> auto& x) {
  return std::tie(x.name);
}
auto parts(Is<LayoutEntry> auto& x) {
  return std::tie(x.node);
}
auto parts(Is<LayoutNote> auto& /*has none*/) {
  return std::tie();
}
auto parts(Is<Layout> auto& x) {
  return std::tie(x.owner, x.entries, x.notes);
}

template <class X>
inline constexpr bool kIsList = false;
template <class X>
inline constexpr bool kIsList<std::vector<X>> = true;

/// Calls `visit` with a construct (or a word) and with all that it consists of, the outer ones first. What a
/// list, a pointer or a variant holds is visited, and not these themselves.
template <class X>
void for_each_construct(const X& construct, const auto& visit) {
  if constexpr (std::same_as<X, ExpressionPtr>) {
    if (construct) for_each_construct(*construct, visit);
  } else if constexpr (kIsList<X>) {
    for (const auto& one : construct) for_each_construct(one, visit);
  } else if constexpr (requires { construct.index(); }) {
    std::visit([&](const auto& one) { for_each_construct(one, visit); }, construct);
  } else {
    visit(construct);
    if constexpr (requires { parts(construct); })
      std::apply([&](const auto&... part) { (for_each_construct(part, visit), ...); }, parts(construct));
  }
}

}  // namespace mlab::cdl
