#include "layout.h"

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"

namespace mlab::repo {
namespace {

const Tree& project() {
  static const Tree kTree = read_tree(base::source_folder());
  return kTree;
}

TEST(Layout, TheProjectIsRead) {
  EXPECT_NE(find_file(project(), "CMakeLists.txt"), nullptr);
}

TEST(Layout, NoFileNamesAMachineOrARegistry) {
  EXPECT_EQ(machine_traces(project()), Findings{});
}
TEST(Layout, AMachinePathIsFoundAtItsLine) {
  const Findings findings = machine_traces({{"docs/a.md", std::string("one\nsee /ho") + "me/ann/x\n"}});
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].line, 2U);
}

TEST(Layout, NoSourceIsPast600Lines) {
  EXPECT_EQ(long_files(project()), Findings{});
}
TEST(Layout, ASourcePast600LinesIsFound) {
  std::string text;
  for (int i = 0; i < 600; ++i) text += "int x;\n";
  EXPECT_EQ(long_files({{"src/mlab/a/a.cc", text}}), Findings{});
  for (const char* path : {"src/mlab/a/a.cc", "proto/mlab/a.proto", "web/ui/a.css", "web/ui/a.tsx"})
    EXPECT_EQ(long_files({{path, text + "int y;\n"}}).size(), 1U) << path;
}

TEST(Layout, EveryTypeInAHeaderHasAComment) {
  EXPECT_EQ(uncommented_types(project()), Findings{});
}
TEST(Layout, ATypeWithoutACommentIsFound) {
  const std::string body = "  int a;\n  int b;\n  int c;\n  int d;\n  int e;\n};\n";
  const auto count = [](std::string text) {
    return uncommented_types({{"src/mlab/a/a.h", std::move(text)}}).size();
  };
  EXPECT_EQ(count("struct Point {\n" + body), 1U);
  EXPECT_EQ(count("\ntemplate <class T>\nclass List {\n" + body), 1U);
  EXPECT_EQ(count("enum class Kind {\n" + body + "/// Of another.\n"), 1U);
  EXPECT_EQ(count("/// A place [m].\nstruct Point {\n" + body), 0U);
  EXPECT_EQ(count("struct Point {\n  double x = 0.0;  ///< [m]\n" + body), 0U);
  EXPECT_EQ(count("/// Many.\ntemplate <class T>\nclass List {\n" + body), 0U);
  EXPECT_EQ(count("struct Point;\nstruct Name {\n  int a;\n};\n"), 0U);
}

TEST(Layout, EveryModuleHasAReadme) {
  EXPECT_EQ(modules_without_readme(project()), Findings{});
}
TEST(Layout, AModuleWithoutAReadmeIsFound) {
  EXPECT_EQ(modules_without_readme({{"src/mlab/a/CMakeLists.txt", ""}}).size(), 1U);
  EXPECT_EQ(modules_without_readme({{"src/mlab/a/CMakeLists.txt", ""}, {"src/mlab/a/README.md", "# a\n"}}),
            Findings{});
}

TEST(Layout, NothingComputesWhatOtherProcessorsRoundOtherwise) {
  EXPECT_EQ(unequal_arithmetic(project()), Findings{});
}
TEST(Layout, AFunctionThatOtherProcessorsRoundOtherwiseIsFound) {
  const std::string text =
      "double f(double x) { return std::sqrt(x); }\ndouble g(double x) { return std::cbrt(x); }\n";
  const Findings findings = unequal_arithmetic(
      {{"src/mlab/geom/a.h", text}, {"src/mlab/geom/a_test.cc", text}, {"tests/cli/a.cc", text}});
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].path, "src/mlab/geom/a.h");
  EXPECT_EQ(findings[0].line, 2U);
}

TEST(Layout, EveryHeaderIsGuarded) {
  EXPECT_EQ(unguarded_headers(project()), Findings{});
}
TEST(Layout, AnUnguardedHeaderIsFound) {
  EXPECT_EQ(unguarded_headers({{"src/mlab/a/a.h", "int x;\n"}}).size(), 1U);
}

}  // namespace
}  // namespace mlab::repo
