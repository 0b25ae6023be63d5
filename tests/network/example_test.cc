// What docs/contributing.md shows.

#include <gtest/gtest.h>

#include "network/test_network.h"

namespace mlab::network {
namespace {

using namespace std::chrono_literals;

TEST(NetworkExample, AHostThatIsCutOffHearsNobody) {
  MLAB_NEEDS_HOSTS();
  TestNetwork network({.seed = 7, .hosts = {{"base"}, {"field"}}});
  network.set({.loss = 0.2, .delay = 5ms});
  const Process echo = network.host("field").start({MLAB_NETWORK_TALK, "echo", "4000"});
  ASSERT_TRUE(echo.prints("ready", 10s)) << echo.errors();
  network.isolate(network.host("field"));
  Process lonely = network.host("base").start({MLAB_NETWORK_TALK, "ask", "field", "4000", "3", "50"});
  ASSERT_TRUE(lonely.wait(10s));
  EXPECT_TRUE(lonely.output().starts_with("0 "));
  EXPECT_TRUE(network.leftovers().empty());
}

}  // namespace
}  // namespace mlab::network
