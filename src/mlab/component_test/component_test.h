#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/component_test/feeding.h"
#include "mlab/flow/frame.h"
#include "mlab/lang/cdl/lower/tests.h"
#include "mlab/robot/program/robot_program.h"
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
  std::vector<std::string> names;    ///< of all, in the order of the text
  std::vector<Test> tests;           ///< those that are wanted, in that order
};

/// Which tests are wanted, by their names.
using IsWanted = std::function<bool(std::string_view)>;

/// Reads a configuration and makes the programs of those of its tests that are wanted. All are checked.
///
/// @return  nothing where there are errors in it, in what it uses or in a test
Tests load(
    const text::SourcePtr& source, const robot::ProgramSources& sources, text::Diagnostics& sink,
    const IsWanted& is_wanted = [](std::string_view) { return true; });

/// Why a test failed.
struct Failure {
  text::Place place;                 ///< of the expectation
  std::string expected;              ///< in its author's words, on one line
  std::string reason;                ///< a sentence without its subject: `is false`
  std::string label;                 ///< when it was to be so, where that is not one cycle; may be empty
  std::uint64_t cycle = 0;           ///< in which it showed, from 1
  std::vector<NodeValue> said;       ///< what it takes its value from, in that cycle
  std::vector<std::string> states;   ///< of sequences that ran in that cycle, by their paths
  std::vector<std::string> actions;  ///< what the robot did in it besides moving
};

/// All values of a cycle, for who shows them; of the test's program.
struct Moment {
  flow::Frame frame;  ///< empty: no cycle ran
  /// How sequences stood before the cycle.
  std::vector<flow::Program::SequenceState> before;
};

struct Outcome {
  std::string name;
  std::uint64_t cycles = 0;  ///< that it ran
  std::optional<Failure> failure;
  bool was_stopped = false;  ///< by its RunOptions: whether it passes is not known
  Moment last;               ///< of the last cycle that it ran

  bool has_passed() const { return !failure.has_value() && !was_stopped; }
};

struct RunOptions {
  std::uint64_t seed = 1;
  /// Ends with this cycle, from 1; 0: with the test.
  std::uint64_t last_cycle = 0;
  /// Asked before each cycle, and while a process of its own computes one: nobody wants it any more.
  std::function<bool()> is_stopped = {};
};

/// Runs a test. The same for the same seed.
Outcome run(const Test& test, const RunOptions& options);

/// The failure as a diagnostic of kind `failed-expectation`.
text::Diagnostic told(const Failure& failure);
/// What is to be known of the cycle, a sentence each: values, states, actions.
std::vector<std::string> findings(const Failure& failure);

}  // namespace mlab::component_test
