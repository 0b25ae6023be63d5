#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "mlab/flow/network.h"
#include "mlab/lang/cdl/lower/arguments.h"
#include "mlab/lang/cdl/lower/binder.h"
#include "mlab/lang/cdl/lower/evaluator.h"
#include "mlab/lang/cdl/lower/findings.h"
#include "mlab/lang/cdl/lower/tests.h"
#include "mlab/lang/cdl/lower/value.h"
#include "mlab/lang/cdl/types/types.h"

namespace mlab::cdl {

/// Tests: their subject and conditions as nodes of one network, what is sensed as constants.
class TestLowering {
 public:
  struct Parts {
    const Types& types;
    Findings& findings;
    Binder& binder;
    Arguments& arguments;
    Evaluator& values;
    Scopes& scopes;
    flow::Network& network;
  };
  explicit TestLowering(const Parts& parts) : parts_(parts) {}

  /// Without the network.
  /// @param scope  names of `robot_of` the test
  LoweredTest test(const Test& test, Scope& scope);

 private:
  void step(const TestStep& step, Scope& scope, LoweredStep& out);
  /// @param around  of the test: what it computes is not sensed
  void percept(const TestStep& step, const Scope& around, LoweredStep& out);
  /// Says why a test can't say that something is sensed so. True: it can.
  bool may_be_sensed(const GivenArgument& given, const TestInput& input, const Scope& around,
                     const LoweredStep& step);
  void percept_value(const GivenArgument& given, const TestInput& input, LoweredStep& out);
  void condition(const TestStep& step, Scope& scope, LoweredStep& out);
  void fact(const TestStep& step, LoweredStep& out);
  std::uint32_t cycles_of(const TestStep& step);
  /// These nodes are evaluated though nobody reads them; and notes all states that there are.
  void keep_awake(const std::set<std::string>& nodes);
  /// That it may run for so long, and that it can fail.
  void check_extent(const Test& test, const LoweredTest& lowered);
  void check_places(const LoweredTest& test);

  const Parts parts_;
  std::map<std::string, std::vector<std::string>, std::less<>> states_;  // their paths, by name
};

}  // namespace mlab::cdl
