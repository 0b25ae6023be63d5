#pragma once

#include <cstdint>
#include <initializer_list>

/// How generated C++ says what a robot's network is. It includes this header and nothing else, so that it
/// compiles at once.

namespace mlab::flow {
struct Network;
struct Node;
struct Source;
struct State;
}  // namespace mlab::flow

namespace mlab::robot_process {

/// Where an input takes its value from.
struct Value {
  const char* text;
  bool is_constant;
};
/// A constant as CNL writes it, without quotes.
constexpr Value constant(const char* text) {
  return {text, true};
}
/// The value of a node or parameter.
constexpr Value from(const char* name) {
  return {name, false};
}

/// A node that is being wired. Valid until the next node.
class NodeWiring {
 public:
  explicit NodeWiring(flow::Node& node) : node_(&node) {}

  NodeWiring& input(const char* name, Value value);
  /// Evaluated even if nobody consumes it.
  NodeWiring& watched();

  /// A state of a sequence; the transitions behind it are its own.
  NodeWiring& state(const char* name, Value member);
  NodeWiring& start();  ///< the last state is the first to be active
  NodeWiring& final();  ///< the last state may lack a way out
  NodeWiring& when(Value trigger, const char* target);
  NodeWiring& when_not(Value trigger, const char* target);
  NodeWiring& restarting();  ///< the last transition restarts its target

  NodeWiring& by(Value selector);
  NodeWiring& on(std::initializer_list<std::int64_t> values, Value member);
  NodeWiring& otherwise(Value member);

 private:
  flow::State& last_state();

  flow::Node* node_;
};

/// Part of a network that is being wired.
class Wiring {
 public:
  explicit Wiring(flow::Network& network) : network_(&network) {}

  struct Limits {
    double min;  ///< in the parameter's unit
    double max;
  };
  void parameter(const char* name, const char* type, const char* unit, Value initial, Limits limits,
                 const char* help, std::initializer_list<const char*> other_names);
  /// The parameter before is that named place of the mission's overlay, where no mission sets it.
  void place_name(const char* name);
  NodeWiring behavior(const char* name, const char* behavior);
  NodeWiring sequence(const char* name, const char* type);
  NodeWiring select(const char* name, const char* type);
  NodeWiring delay(const char* name, const char* type);

 private:
  NodeWiring add(int kind, const char* name, const char* behavior);

  flow::Network* network_;
};

using WiringFunction = void (*)(Wiring&);

}  // namespace mlab::robot_process
