#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/flow/library.h"
#include "mlab/flow/network.h"

namespace mlab::exports {

/// A wire of a network: the value of `from` goes to `to`.
struct Wire {
  std::string from;  ///< a node or a parameter
  std::string to;    ///< a node
  std::string port;  ///< the input; of operators the state, case, `by` or `value`
  enum class Role { kInput, kMember, kTrigger, kSelector } role = Role::kInput;
};

/// A network with its names resolved.
class NetworkView {
 public:
  NetworkView(const flow::Network& network, const flow::Library& library);

  const flow::Network& network() const { return network_; }
  /// Null for parameters, constants and what is not there.
  const flow::Node* node(std::string_view name) const;
  const flow::Behavior* behavior(const flow::Node& node) const;
  /// The name of the type that a node gives; empty: nothing.
  std::string type(const flow::Node& node) const;
  std::string unit(const flow::Node& node) const;
  const std::vector<Wire>& wires() const { return wires_; }
  /// Nodes that a node reads whenever it is evaluated: not the members of operators.
  std::vector<const flow::Node*> inputs(const flow::Node& node) const;
  /// Nodes that are evaluated in every cycle because they act.
  std::vector<const flow::Node*> roots() const;

 private:
  void add(const flow::Source& source, const flow::Node& to, std::string port, Wire::Role role);

  const flow::Network& network_;
  const flow::Library& library_;
  std::map<std::string, const flow::Node*, std::less<>> nodes_;
  std::map<std::string, const flow::Parameter*, std::less<>> parameters_;
  std::vector<Wire> wires_;
};

/// `case_2`, `case_2_4`, `otherwise`: what a case of a select is called.
std::string case_name(const flow::Case& one);

}  // namespace mlab::exports
