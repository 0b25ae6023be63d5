#include "mlab/robot/process/wiring.h"

#include "mlab/flow/network.h"

namespace mlab::robot_process {
namespace {

flow::Source source(Value value) {
  return {value.is_constant ? flow::Source::Kind::kConstant : flow::Source::Kind::kName, value.text, {}};
}

}  // namespace

NodeWiring& NodeWiring::input(const char* name, Value value) {
  node_->links.push_back({name, source(value), {}});
  return *this;
}

NodeWiring& NodeWiring::watched() {
  node_->is_public = true;
  return *this;
}

flow::State& NodeWiring::last_state() {
  if (node_->states.empty()) node_->states.emplace_back();  // only where the text was changed by hand
  return node_->states.back();
}

NodeWiring& NodeWiring::state(const char* name, Value member) {
  flow::State& state = node_->states.emplace_back();
  state.name = name;
  state.member = source(member);
  return *this;
}

NodeWiring& NodeWiring::start() {
  last_state().is_start = true;
  return *this;
}

NodeWiring& NodeWiring::final() {
  last_state().is_final = true;
  return *this;
}

NodeWiring& NodeWiring::when(Value trigger, const char* target) {
  last_state().transitions.push_back({source(trigger), false, target, false, {}});
  return *this;
}

NodeWiring& NodeWiring::when_not(Value trigger, const char* target) {
  last_state().transitions.push_back({source(trigger), true, target, false, {}});
  return *this;
}

NodeWiring& NodeWiring::restarting() {
  if (!last_state().transitions.empty()) last_state().transitions.back().restarts = true;
  return *this;
}

NodeWiring& NodeWiring::by(Value selector) {
  node_->selector = source(selector);
  return *this;
}

NodeWiring& NodeWiring::on(std::initializer_list<std::int64_t> values, Value member) {
  node_->cases.push_back({values, source(member), {}});
  return *this;
}

NodeWiring& NodeWiring::otherwise(Value member) {
  return on({}, member);
}

void Wiring::parameter(const char* name, const char* type, const char* unit, Value initial, Limits limits,
                       const char* help, std::initializer_list<const char*> other_names) {
  network_->parameters.push_back({name,
                                  type,
                                  unit,
                                  help,
                                  {other_names.begin(), other_names.end()},
                                  source(initial),
                                  limits.min,
                                  limits.max,
                                  {}});
}

void Wiring::place_name(const char* name) {
  network_->parameters.back().place_name.text = name;
}

NodeWiring Wiring::add(int kind, const char* name, const char* behavior) {
  flow::Node& node = network_->nodes.emplace_back();
  node.kind = static_cast<flow::Node::Kind>(kind);
  node.name = name;
  node.behavior = behavior;
  return NodeWiring(node);
}

NodeWiring Wiring::behavior(const char* name, const char* behavior) {
  return add(static_cast<int>(flow::Node::Kind::kBehavior), name, behavior);
}
NodeWiring Wiring::sequence(const char* name, const char* type) {
  return add(static_cast<int>(flow::Node::Kind::kSequence), name, type);
}
NodeWiring Wiring::select(const char* name, const char* type) {
  return add(static_cast<int>(flow::Node::Kind::kSelect), name, type);
}
NodeWiring Wiring::delay(const char* name, const char* type) {
  return add(static_cast<int>(flow::Node::Kind::kDelay), name, type);
}

}  // namespace mlab::robot_process
