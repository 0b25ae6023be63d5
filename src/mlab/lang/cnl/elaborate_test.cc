#include "mlab/lang/cnl/elaborate.h"

#include <memory>

#include <gtest/gtest.h>

#include "mlab/lang/cnl/parser.h"

namespace mlab::cnl {
namespace {

flow::Network network(const char* text, std::size_t errors = 0) {
  text::Diagnostics sink;
  const Tree tree = parse(std::make_shared<const text::Source>("folder/forager.cnl", text), sink);
  flow::Network out = elaborate(tree, sink);
  EXPECT_EQ(sink.error_count(), errors) << text::render(sink);
  return out;
}

TEST(Elaborate, TheNetworkIsNamedAfterItsModuleOrItsFile) {
  EXPECT_EQ(network("node a is A with nend").name, "forager");
  EXPECT_EQ(network("modulename = robot-1;").name, "robot-1");
}

TEST(Elaborate, HistoricDatabaseNodesAreParametersWithTwoNames) {
  const flow::Network n = network(
      "node speed is DATABASE_DOUBLE with key = {\"base_velocity\"}; initial = 5; nend\n"
      "node again is DATABASE_DOUBLE with key = {\"base_velocity\"}; initial = 5; nend\n"
      "node mode is DATABASE_BOOLEAN with initial = {true}; key = \"mode\"; nend\n"
      "node count is DATABASE_INT with key = {\"count\"}; initial = 7; nend\n"
      "node drive is Drive with speed = speed; nend\n");
  ASSERT_EQ(n.parameters.size(), 3U);
  EXPECT_EQ(n.parameters[0].name, "base_velocity");
  EXPECT_EQ(n.parameters[0].type, "double");
  EXPECT_EQ(n.parameters[0].other_names, (std::vector<std::string>{"speed", "again"}));
  EXPECT_EQ(n.parameters[1].type, "bool");
  EXPECT_TRUE(n.parameters[1].other_names.empty()) << "the node has the key's name already";
  EXPECT_EQ(n.parameters[2].initial.text, "7");
  ASSERT_EQ(n.nodes.size(), 1U);
}

TEST(Elaborate, PublicNodesAreWatchedAndRemoteOnesLeftOut) {
  const flow::Network n =
      network("public node a is A with nend\nnode b is B with nend\nremote node m:c is C\n", 1);
  ASSERT_EQ(n.nodes.size(), 2U);
  EXPECT_TRUE(n.nodes[0].is_public);
  EXPECT_FALSE(n.nodes[1].is_public);
}

}  // namespace
}  // namespace mlab::cnl
