#pragma once

#include "mlab/lang/cdl/syntax/tree.h"

namespace mlab::cdl {

/// Calls `visit` with every expression that stands right inside of this one.
template <class Visit>
void for_each_part(const Expression& expression, const Visit& visit) {
  const auto part = [&](const ExpressionPtr& one) {
    if (one) visit(*one);
  };
  const auto call_parts = [&](const Call& call) {
    for (const Argument& argument : call.arguments) part(argument.value);
  };
  const auto member_parts = [&](const std::vector<Member>& members) {
    for (const Member& member : members) {
      part(member.weight);
      part(member.value);
    }
  };
  if (const auto* list = std::get_if<List>(&expression.what)) {
    for (const ExpressionPtr& item : list->items) part(item);
  } else if (const auto* call = std::get_if<Call>(&expression.what)) {
    call_parts(*call);
  } else if (const auto* logic = std::get_if<Logic>(&expression.what)) {
    for (const ExpressionPtr& operand : logic->operands) part(operand);
  } else if (const auto* arithmetic = std::get_if<Arithmetic>(&expression.what)) {
    for (const ExpressionPtr& operand : arithmetic->operands) part(operand);
  } else if (const auto* cooperate = std::get_if<Cooperate>(&expression.what)) {
    member_parts(cooperate->members);
  } else if (const auto* compete = std::get_if<Compete>(&expression.what)) {
    member_parts(compete->members);
  } else if (const auto* coordinate = std::get_if<Coordinate>(&expression.what)) {
    call_parts(coordinate->by);
    member_parts(coordinate->members);
  } else if (const auto* fuse = std::get_if<Fuse>(&expression.what)) {
    call_parts(fuse->by);
    member_parts(fuse->members);
  } else if (const auto* sequence = std::get_if<Sequence>(&expression.what)) {
    for (const State& state : sequence->states) {
      part(state.member);
      for (const Transition& transition : state.transitions) part(transition.trigger);
    }
  } else if (const auto* select = std::get_if<Select>(&expression.what)) {
    part(select->by);
    for (const Case& one : select->cases) part(one.member);
  } else if (const auto* delay = std::get_if<Delay>(&expression.what)) {
    part(delay->value);
    part(delay->initial);
  }
  part(expression.active);
}

/// The expression and all that stands in it, the outer ones first.
template <class Visit>
void for_each_expression(const Expression& expression, const Visit& visit) {
  visit(expression);
  for_each_part(expression, [&](const Expression& part) { for_each_expression(part, visit); });
}

}  // namespace mlab::cdl
