#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "mlab/base/random.h"
#include "mlab/flow/network.h"

namespace mlab::robot_build::testing {

/// A network that nobody thought of: sequences and selections in each other, delays, parameters, noise,
/// obstacles, numbers of any size. The same number gives the same network.
class AnyNetwork {
 public:
  explicit AnyNetwork(std::uint64_t number) : random_(base::Random::of(number, 1, 2, 3)) {}

  flow::Network make() {
    network_.name = "any";
    for (int i = 0; i < 3; ++i) {
      flow::Parameter parameter;
      parameter.name = fmt::format("p{}", i);
      parameter.type = "double";
      parameter.help = "what \"it\" is\\for, with a ? in it";
      parameter.initial = constant(number(0.1, 2.0));
      parameter.min = -100.0;
      parameter.max = 100.0;
      network_.parameters.push_back(parameter);
    }
    flow::Parameter gate;
    gate.name = "gate";
    gate.type = "Point";
    gate.unit = "m";
    gate.initial = constant("{0, 0}");
    gate.place_name.text = "the \"Gate\"";
    network_.parameters.push_back(gate);
    node("obstacles", "DetectObstacles", {{"range", constant(number(1.0, 30.0))}});
    const std::string movement = vector("movement", 4);
    node("wheels", "Drive",
         {{"v", from(movement)}, {"base_velocity", from("p0")}, {"max_velocity", constant("3")}});
    return network_;
  }

 private:
  using Links = std::vector<std::pair<std::string, flow::Source>>;

  static flow::Source constant(std::string text) {
    return {flow::Source::Kind::kConstant, std::move(text), {}};
  }
  static flow::Source from(std::string name) { return {flow::Source::Kind::kName, std::move(name), {}}; }
  std::string number(double low, double high) { return fmt::format("{}", random_.uniform(low, high)); }
  int below(int count) { return static_cast<int>(random_.below(static_cast<std::uint64_t>(count))); }
  flow::Source gain() {
    return below(3) == 0 ? from(fmt::format("p{}", below(3))) : constant(number(-1.0, 2.0));
  }

  flow::Node& node(const std::string& name, const std::string& behavior, const Links& links) {
    flow::Node& out = network_.nodes.emplace_back();
    out.name = name;
    out.behavior = behavior;
    for (const auto& [input, source] : links) out.links.push_back({input, source, {}});
    return out;
  }

  std::string trigger(const std::string& name) {
    if (below(2) == 0)
      node(name, "Wait", {{"delay", constant(number(0.1, 1.5))}});
    else
      node(name, "MovedDistance", {{"distance", constant(number(0.05, 0.5))}});
    return name;
  }

  std::string sum(const std::string& name, int depth) {
    Links links;
    for (int i = 2 + below(2); i > 0; --i) {
      links.emplace_back("members", from(vector(fmt::format("{}.m{}", name, i), depth - 1)));
      links.emplace_back("gains", gain());
    }
    node(name, "WeightedSum", links);
    return name;
  }

  std::string sequence(const std::string& name, int depth) {
    std::vector<flow::State> states(2 + static_cast<std::size_t>(below(2)));
    for (std::size_t i = 0; i < states.size(); ++i) {
      flow::State& state = states[i];
      state.name = fmt::format("S{}", i);
      state.is_start = i == 0;
      state.member = from(vector(fmt::format("{}.S{}", name, i), depth - 1));
      for (int t = 1 + below(2); t > 0; --t) {
        const std::size_t target = static_cast<std::size_t>(below(static_cast<int>(states.size())));
        state.transitions.push_back({from(trigger(fmt::format("{}.S{}.t{}", name, i, t))),
                                     t == 2,
                                     fmt::format("S{}", target),
                                     below(2) == 0,
                                     {}});
      }
    }
    flow::Node& out = node(name, "Vector", {});
    out.kind = flow::Node::Kind::kSequence;
    out.states = std::move(states);
    return name;
  }

  std::string selection(const std::string& name, int depth) {
    const std::string seen = name + ".n";
    node(name + ".o", "DetectObjects", {});
    node(seen, "CountObjects", {{"objects", from(name + ".o")}});
    std::vector<flow::Case> cases;
    cases.push_back({{0, 2}, from(vector(name + ".even", depth - 1)), {}});
    cases.push_back({{}, from(vector(name + ".rest", depth - 1)), {}});
    flow::Node& out = node(name, "Vector", {});
    out.kind = flow::Node::Kind::kSelect;
    out.selector = from(seen);
    out.cases = std::move(cases);
    return name;
  }

  std::string delay(const std::string& name, int depth) {
    const std::string value = vector(name + ".now", depth - 1);
    flow::Node& out = node(name, "Vector", {{"value", from(value)}, {"initial", constant("{0.5, -0.25}")}});
    out.kind = flow::Node::Kind::kDelay;
    return name;
  }

  std::string vector(const std::string& name, int depth) {
    switch (depth <= 0 ? below(3) : 3 + below(4)) {
      case 0:
        node(name, "Noise", {{"persistence", constant(number(0.1, 3.0))}});
        return name;
      case 1:
        node(name, "MoveForward", {{"amount", gain()}});
        return name;
      case 2:
        node(name, "AvoidStaticObstacles",
             {{"readings", from("obstacles")}, {"sphere", constant(number(1.0, 9.0))}});
        return name;
      case 3:
        return sequence(name, depth);
      case 4:
        return selection(name, depth);
      case 5:
        return delay(name, depth);
      default:
        return sum(name, depth);
    }
  }

  base::Random random_;
  flow::Network network_;
};

}  // namespace mlab::robot_build::testing
