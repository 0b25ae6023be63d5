#include "comments.h"

#include <string>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"

namespace mlab::repo {
namespace {

std::size_t count(const std::string& text) {
  return stray_parameters({{"src/mlab/a/a.h", text}}).size();
}

TEST(Comments, EachParameterIsOfTheDeclarationBelow) {
  EXPECT_EQ(stray_parameters(read_tree(base::source_folder())), Findings{});
}
TEST(Comments, AParameterThatIsNotBelowIsFound) {
  const Findings findings = stray_parameters(
      {{"src/mlab/a/a.h", "/// Far.\n/// @param far  [m]\n/// @param near  [m]\nvoid f(double near);\n"}});
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].line, 2U);
  EXPECT_NE(findings[0].message.find("`@param far`"), std::string::npos) << findings[0].message;
}
TEST(Comments, AParameterOfTheNextDeclarationIsFound) {
  EXPECT_EQ(count("  /// @param reach  [m]\n  bool is(int robot) const;\n  void note(double reach);\n"), 1U);
  EXPECT_EQ(count("/// @param make  how\nusing Make = int (*)();\n\nvoid f(Make make);\n"), 1U);
  EXPECT_EQ(count("/// @param so  far\nvoid f() {\n  int so = 1;\n}\n"), 1U);
}
TEST(Comments, APartOfANameIsNotTheName) {
  EXPECT_EQ(count("/// @param reach  [m]\nvoid f(double my_reach, double reaches);\n"), 1U);
  EXPECT_EQ(count("/// @param  \nvoid f(double reach);\n"), 1U);
}
TEST(Comments, ParametersOfLongDeclarationsAreFine) {
  EXPECT_EQ(
      count("/// @param a, b  both\n/// @param c one blank\ntemplate <class T>\nvoid f(T a, int b = g(0),\n"
            "       int c = {});\n"),
      0U);
  EXPECT_EQ(count("/// @param a  one\nvoid f(\n    int,  // a comment; with a sign\n    int a);\n"), 0U);
}

}  // namespace
}  // namespace mlab::repo
