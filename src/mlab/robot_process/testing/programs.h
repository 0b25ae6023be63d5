#pragma once

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "mlab/flow/program.h"
#include "mlab/lang/cnl/elaborate.h"
#include "mlab/lang/cnl/load.h"
#include "mlab/library/library.h"

namespace mlab::robot_process {

/// The program of a network in CNL over the component library.
inline std::shared_ptr<const flow::Program> program_of(const std::string& cnl_text) {
  const auto source = std::make_shared<const text::Source>("test.cnl", cnl_text);
  text::Diagnostics sink;
  const cnl::Tree tree = cnl::load(source, sink);
  flow::Network network = cnl::elaborate(tree, sink);
  flow::Library library;
  library.add(mlab_library_behaviors());
  auto program = flow::build_program(network, library, sink);
  EXPECT_TRUE(program) << text::render(sink);
  return program;
}

/// A robot with a parameter, a sequence, noise and obstacles to avoid.
inline std::shared_ptr<const flow::Program> wandering_program() {
  return program_of(R"(
parameter double pace = 1 in 0 .. 10;
node near is DetectObstacles with range = 7; nend
node avoid is AvoidStaticObstacles with readings = near; sphere = 5; safety_margin = 0.5; nend
node noise is Noise with persistence = 3; nend
node ahead is MoveForward with amount = pace; nend
node mix is WeightedSum with members = avoid; members = noise; members = ahead; gains = 1; gains = 0.7; gains = 1; nend
node fast is Drive with v = mix; base_velocity = 2; max_velocity = 3; nend
)");
}

}  // namespace mlab::robot_process
