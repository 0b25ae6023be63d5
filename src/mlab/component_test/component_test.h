#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mlab/component_test/feeding.h"
#include "mlab/flow/frame.h"
#include "mlab/lang/cdl/tests.h"
#include "mlab/robot/robot_program.h"
#include "mlab/text/diagnostic.h"

namespace mlab::component_test {

/// A test made ready to run.
struct Test {
  cdl::LoweredTest lowered;
  robot::RobotProgram program;
};

/// The tests of one configuration.
struct Tests {
  cdl::Configuration configuration;  ///< whose trees the tests point into
  std::vector<Test> tests;           ///< in the order of the text
};

/// Reads a configuration and makes the programs of its tests.
///
/// @return  nothing where there are errors in it, in what it uses or in a test
Tests load(const text::SourcePtr& source, const robot::ProgramSources& sources, text::Diagnostics& sink);

/// Why a test failed.
struct Failure {
  text::Place place;                 ///< of the expectation
  std::string expected;              ///< in its author's words, on one line
  std::string reason;                ///< a sentence without its subject: `is false`
  std::string label;                 ///< when it was to be so, where that is not one cycle; may be empty
  std::uint64_t cycle = 0;           ///< in which it showed, from 1
  std::vector<Said> said;            ///< what it takes its value from, in that cycle
  std::vector<std::string> states;   ///< of sequences that ran in that cycle, by their paths
  std::vector<std::string> actions;  ///< what the robot did in it besides moving
  /// All values of that cycle, for who shows them; of the test's program.
  flow::Frame frame;
};

struct Outcome {
  std::string name;
  std::uint64_t cycles = 0;  ///< that it ran
  std::optional<Failure> failure;

  bool has_passed() const { return !failure.has_value(); }
};

/// Runs a test. The same for the same seed.
Outcome run(const Test& test, std::uint64_t seed);

/// The failure as a diagnostic of kind `failed-expectation`.
text::Diagnostic told(const Failure& failure);
/// What is to be known of the cycle, a sentence each: values, states, actions.
std::vector<std::string> findings(const Failure& failure);

}  // namespace mlab::component_test
