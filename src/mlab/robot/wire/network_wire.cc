#include "mlab/robot/wire/network_wire.h"

#include <utility>

// Each struct is taken apart by a structured binding: a field that is added later does not compile until it
// travels.

namespace mlab::robot_wire {
namespace {

using flow::Source;

void put(const Source& source, wire::NetworkSource& out) {
  const auto& [kind, text, place] = source;
  out.set_text(text);
  out.set_is_name(kind == Source::Kind::kName);
}

Source source_of(const wire::NetworkSource& message) {
  return {message.is_name() ? Source::Kind::kName : Source::Kind::kConstant, message.text(), {}};
}

void put(const flow::Parameter& parameter, wire::NetworkParameter& out) {
  const auto& [name, type, unit, help, other_names, initial, min, max, place, place_name] = parameter;
  out.set_name(name);
  out.set_type(type);
  out.set_unit(unit);
  out.set_help(help);
  for (const std::string& other : other_names) out.add_other_names(other);
  put(initial, *out.mutable_initial());
  out.set_min(min);
  out.set_max(max);
  out.set_place_name(place_name.text);
}

flow::Parameter parameter_of(const wire::NetworkParameter& message) {
  flow::Parameter out;
  out.name = message.name();
  out.type = message.type();
  out.unit = message.unit();
  out.help = message.help();
  out.other_names.assign(message.other_names().begin(), message.other_names().end());
  out.initial = source_of(message.initial());
  out.min = message.min();
  out.max = message.max();
  out.place_name.text = message.place_name();
  return out;
}

void put(const flow::State& state, wire::NetworkState& out) {
  const auto& [name, member, transitions, is_start, is_final, place] = state;
  out.set_name(name);
  put(member, *out.mutable_member());
  for (const auto& [trigger, is_negated, target, restarts, at] : transitions) {
    wire::NetworkTransition& way = *out.add_transitions();
    put(trigger, *way.mutable_trigger());
    way.set_is_negated(is_negated);
    way.set_target(target);
    way.set_restarts(restarts);
  }
  out.set_is_start(is_start);
  out.set_is_final(is_final);
}

flow::State state_of(const wire::NetworkState& message) {
  flow::State out;
  out.name = message.name();
  out.member = source_of(message.member());
  for (const wire::NetworkTransition& way : message.transitions())
    out.transitions.push_back({source_of(way.trigger()), way.is_negated(), way.target(), way.restarts(), {}});
  out.is_start = message.is_start();
  out.is_final = message.is_final();
  return out;
}

void put(const flow::Node& node, wire::NetworkNode& out) {
  const auto& [kind, name, behavior, behavior_place, links, states, selector, cases, is_public, place] = node;
  out.set_kind(static_cast<wire::NetworkNode::Kind>(kind));
  out.set_name(name);
  out.set_behavior(behavior);
  for (const auto& [input, source, at] : links) {
    wire::NetworkLink& link = *out.add_links();
    link.set_input(input);
    put(source, *link.mutable_source());
  }
  for (const flow::State& state : states) put(state, *out.add_states());
  put(selector, *out.mutable_selector());
  for (const auto& [values, member, at] : cases) {
    wire::NetworkCase& one = *out.add_cases();
    for (const std::int64_t value : values) one.add_values(value);
    put(member, *one.mutable_member());
  }
  out.set_is_public(is_public);
}

flow::Node node_of(const wire::NetworkNode& message) {
  flow::Node out;
  const int kind = message.kind();
  out.kind = kind >= 0 && kind <= 3 ? static_cast<flow::Node::Kind>(kind) : flow::Node::Kind::kBehavior;
  out.name = message.name();
  out.behavior = message.behavior();
  for (const wire::NetworkLink& link : message.links())
    out.links.push_back({link.input(), source_of(link.source()), {}});
  for (const wire::NetworkState& state : message.states()) out.states.push_back(state_of(state));
  out.selector = source_of(message.selector());
  for (const wire::NetworkCase& one : message.cases())
    out.cases.push_back({{one.values().begin(), one.values().end()}, source_of(one.member()), {}});
  out.is_public = message.is_public();
  return out;
}

}  // namespace

void encode(const flow::Network& network, wire::Network& out) {
  const auto& [name, parameters, nodes] = network;
  out.Clear();
  out.set_name(name);
  for (const flow::Parameter& parameter : parameters) put(parameter, *out.add_parameters());
  for (const flow::Node& node : nodes) put(node, *out.add_nodes());
}

flow::Network decode(const wire::Network& message) {
  flow::Network out;
  out.name = message.name();
  for (const wire::NetworkParameter& parameter : message.parameters())
    out.parameters.push_back(parameter_of(parameter));
  for (const wire::NetworkNode& node : message.nodes()) out.nodes.push_back(node_of(node));
  return out;
}

}  // namespace mlab::robot_wire
