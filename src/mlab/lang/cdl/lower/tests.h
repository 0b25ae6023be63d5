#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/flow/library.h"
#include "mlab/flow/network.h"
#include "mlab/lang/cdl/configuration.h"
#include "mlab/lang/cdl/lower/lower.h"
#include "mlab/lang/cdl/syntax/tree.h"
#include "mlab/lang/cdl/test_words.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cdl {

/// How long a cycle of a test takes [s].
inline constexpr double kTestCycle = 0.1;
/// A test runs at most so many cycles.
inline constexpr std::uint32_t kMostTestCycles = 100'000;

/// One step of a test, with its constants.
struct LoweredStep {
  const TestStep* written = nullptr;
  std::size_t number = 0;  ///< among the steps of the test
  const TestPerceptInfo* percept = nullptr;
  /// By the inputs of `percept`, as constants of their type in SI units; nothing: it was not said.
  std::vector<std::optional<std::string>> values = {};
  flow::Source condition = {};         ///< a bool: name of a node or parameter, or a constant
  const TestAction* action = nullptr;  ///< that is expected
  std::uint32_t cycles = 1;            ///< how long it waits, or may take
};

/// A test made flat: what it tests, and each condition, are nodes of one network that nothing drives.
struct LoweredTest {
  const Test* test = nullptr;
  flow::Network network;
  std::string subject;  ///< node or parameter that holds the value of what is tested; empty: it gives none
  std::vector<LoweredStep> steps;
};

/// The robot that a test runs on: what is tested, and what is expected of it, as values that nothing drives.
/// They are called as the nodes of its network are.
Robot robot_of(const Test& test, const Configuration& configuration);

/// The tests of a file, in the order of its text.
std::vector<const Test*> tests_of(const Tree& tree);
/// What conditions call the value of what is tested.
Word subject_name(const Test& test);
/// Whether a state's path is what a test calls so: its last names are those.
bool is_named_so(std::string_view path, std::string_view wanted);

/// @errors  as of robots; `unknown-percept`, `unknown-action`, `unknown-state`, `unknown-place`,
/// `wrong-unit`,
///          `out-of-range`; the network then is not to be built. A warning: `expects-nothing`
LoweredTest lower(const Configuration& configuration, const Test& test, const flow::Library& library,
                  text::Diagnostics& sink, EarlierFindings& said);

/// Checks the tests of the configuration's first file, which it was read for.
void check_tests(const Configuration& configuration, const flow::Library& library, text::Diagnostics& sink,
                 EarlierFindings& said);

}  // namespace mlab::cdl
