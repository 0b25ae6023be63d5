#pragma once

#include <memory>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "mlab/flow/testing/behaviors.h"

namespace mlab::robot_process {

/// Away from all obstacles, with a random part, and on at a pace; its value is its strength.
inline void fire_wander(flow::Call& call) {
  base::Random random = call.random();
  geom::Vector v{call.at<double>(call.inputs[0]) + random.uniform(0.0, 1.0), random.uniform(-1.0, 1.0), 0.0};
  for (const percept::Obstacle& obstacle : call.cycle->percepts->obstacles)
    v -= geom::unit(obstacle.center) * (1.0 / (1.0 + geom::length(obstacle.center)));
  call.cycle->action->velocity = v;
  call.cycle->action->drives = true;
  call.at<double>(call.output) = geom::length(v);
}
inline const flow::Behavior& wander() {
  static const flow::Input kInputs[] = {
      {"pace", &flow::type_info<double>(), "", "", false, "", -flow::kNoLimit, flow::kNoLimit},
      {"range", &flow::type_info<double>(), "m", "", false, "7", 0.0, 100.0}};
  static const flow::Need kNeeds[] = {{percept::Sensor::kObstacles, 1, 0.0}};
  static const flow::Behavior kBehavior = [] {
    flow::Behavior b;
    b.name = "Wander";
    b.inputs = kInputs;
    b.output = &flow::type_info<double>();
    b.needs = kNeeds;
    b.fire = fire_wander;
    return b;
  }();
  return kBehavior;
}

inline std::shared_ptr<const flow::Program> program_of(flow::Network network) {
  static const flow::Behavior* const kOwn[] = {&wander()};
  flow::Library library = flow::test::library();
  library.add(kOwn);
  text::Diagnostics sink;
  network.name = "wanderer";
  auto program = flow::build_program(network, library, sink);
  EXPECT_TRUE(program) << text::render(sink);
  return program;
}

/// A robot with a parameter, something to sense, state and random numbers.
inline std::shared_ptr<const flow::Program> wandering_program() {
  using namespace flow::test;
  flow::Network network;
  network.parameters.push_back({"pace", "double", "", "", {}, constant("1"), 0.0, 10.0, {}});
  network.nodes.push_back(node("counted", "Count", {{"start", constant("0")}}));
  network.nodes.push_back(node("total", "Add", {{"a", name("counted")}, {"b", name("pace")}}));
  network.nodes.push_back(node("walk", "Wander", {{"pace", name("total")}}));
  network.nodes.back().is_public = true;
  return program_of(std::move(network));
}

}  // namespace mlab::robot_process
