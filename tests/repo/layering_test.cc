#include "layering.h"

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"

namespace mlab::repo {
namespace {

TEST(Layering, NoModuleIncludesOneAboveIt) {
  EXPECT_EQ(upward_includes(read_tree(base::source_folder())), Findings{});
}

TEST(Layering, AnUpwardIncludeIsFoundAtItsLine) {
  const Tree tree = {{"src/mlab/geom/pose.h",
                      "#pragma once\n#include \"mlab/base/id.h\"\n#include \"mlab/flow/frame.h\"\n"}};
  const Findings findings = upward_includes(tree);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0],
            (Finding{"src/mlab/geom/pose.h", 3, "`geom` must not include `flow`, which stands above it"}));
}

TEST(Layering, ArrowsMayBeFollowedOverSeveralModules) {
  const Tree tree = {
      {"src/mlab/fleet/fleet.cc", "#include \"mlab/base/id.h\"\n#include \"mlab/lang/cnl/parser.h\"\n"}};
  EXPECT_EQ(upward_includes(tree), Findings{});
}

TEST(Layering, LanguagesDoNotKnowEachOtherUnlessAnArrowSaysSo) {
  const Tree tree = {{"src/mlab/lang/cnl/parser.cc", "#include \"mlab/lang/odl/parser.h\"\n"},
                     {"src/mlab/lang/mdl/parser.cc", "#include \"mlab/lang/odl/parser.h\"\n"}};
  const Findings findings = upward_includes(tree);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].path, "src/mlab/lang/cnl/parser.cc");
}

TEST(Layering, WhatAModuleKeepsToItselfNobodyAboveItAndNoHeaderOfItKnows) {
  const std::string line = "#include \"mlab/sim/simulator.h\"\n";
  EXPECT_EQ(upward_includes({{"src/mlab/simulated/run.cc", line}}), Findings{});
  EXPECT_EQ(
      upward_includes({{"src/mlab/simulated/run.h", line}, {"src/mlab/console/run/alarms.cc", line}}).size(),
      2U);
}

TEST(Layering, MessagesBelongToTheModuleThatSpeaksByThem) {
  const Tree tree = {{"src/mlab/console/server/server.cc", "#include \"mlab/console_map.pb.h\"\n"},
                     {"src/mlab/console/session.cc", "#include \"mlab/console_map.pb.h\"\n"},
                     {"src/mlab/designer/session/desk.cc", "#include \"mlab/misc.pb.h\"\n"}};
  const Findings findings = upward_includes(tree);
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].message, "`console/server` must not include `console`, which stands above it");
  EXPECT_EQ(findings[1].message, "`designer` must not include `misc.pb.h`, which stands above it");
}

TEST(Layering, TheCommandMayIncludeEverything) {
  EXPECT_EQ(upward_includes({{"src/mlab/cli/main.cc", "#include \"mlab/fleet/fleet.h\"\n"}}), Findings{});
}

TEST(Gate, OnlyTheCommandDecidesWhatCodeMayDo) {
  EXPECT_EQ(foreign_permissions(read_tree(base::source_folder())), Findings{});
}

TEST(Gate, ADecisionElsewhereIsFoundAtItsLine) {
  const std::string line = "auto p = cell::Permission::decide(grounds, means);\n";
  const Tree tree = {{"src/mlab/console/session.cc", "\n" + line}, {"src/mlab/cli/permission.cc", line}};
  const Findings findings = foreign_permissions(tree);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].path, "src/mlab/console/session.cc");
}

TEST(Layering, TheLibraryKnowsWhatProceduresAreWrittenAgainstAndItsTestsMore) {
  const std::string line = "#include \"mlab/robot/program/configuration_file.h\"\n";
  const Tree tree = {{"library/robots/robots.cc", line},
                     {"library/robots/standard_test.cc", line},
                     {"library/testing/network.h", line}};
  const Findings findings = upward_includes(tree);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].path, "library/robots/robots.cc");
}

TEST(Layering, CodeForTestsIsUsedByTestsAlone) {
  EXPECT_EQ(tests_in_the_product(read_tree(base::source_folder())), Findings{});
  const std::string line = "#include \"mlab/text/testing/golden.h\"\n";
  const Tree tree = {{"src/mlab/text/source.cc", line},
                     {"src/mlab/text/source_test.cc", line},
                     {"src/mlab/flow/testing/behaviors.h", line},
                     {"fuzz/odl_fuzz.cc", line}};
  const Findings findings = tests_in_the_product(tree);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].path, "src/mlab/text/source.cc");
}

TEST(Layering, AModuleWithoutAPlaceIsFound) {
  EXPECT_EQ(upward_includes({{"src/mlab/misc/misc.h", "#pragma once\n"}}).size(), 1U);
}

}  // namespace
}  // namespace mlab::repo
