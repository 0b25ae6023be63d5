#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "mlab/component_test/component_test.h"
#include "mlab/designer.pb.h"
#include "mlab/designer/component_tests/loaded_tests.h"

namespace mlab::designer {

/// A page that is looked at while a test is.
struct LookedPage {
  std::string source;  ///< name of the text that declares it
  std::string path;
};

/// The values of a cycle of a test where a page runs in it, as a robot's are told.
///
/// @param cycle       from 1; beyond its end: the last
/// @param is_stopped  nobody waits for it any more, what comes back is of no use
/// @return  without ports where the page does not run in the test
TestCycle test_cycle(LoadedFile& file, const component_test::Test& test, std::uint64_t cycle,
                     const LookedPage& page, const std::function<bool()>& is_stopped);

}  // namespace mlab::designer
