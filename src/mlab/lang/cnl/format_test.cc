#include "mlab/lang/cnl/format.h"

#include <filesystem>
#include <memory>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/cnl/testing/meaning.h"

namespace mlab::cnl {
namespace {

using testing::meaning;

text::SourcePtr source(std::string text) {
  return std::make_shared<const text::Source>("a.cnl", std::move(text));
}

std::string formatted(const std::string& text) {
  text::Diagnostics sink;
  const auto out = format(source(text), sink);
  EXPECT_TRUE(out) << text::render(sink);
  return out.value_or("");
}

TEST(Format, LaysOutDeclarationsAndLeavesCodeAlone) {
  EXPECT_EQ(
      formatted(
          "/// Help.\nprocedure  Vector [ m ]A pure alias OLD(x=goal,y = none) with Vector goal; // one\n"
          "double[m]radius=5 in 0..1e6 ; ///< two\nheader   int n=0;\n\n   odd (  indent );\n "
          "body\n\toutput=goal ;  \n"
          "pend   \n\n\nnode a is A|to the goal|with goal={1,2} ;nend\n\n\n\n// the end"),
      "/// Help.\n"
      "procedure Vector [ m ] A\n"
      "  pure\n"
      "  alias OLD (x = goal, y = none)\n"
      "with\n"
      "  Vector goal;                        // one\n"
      "  double [m] radius = 5 in 0 .. 1e6;  ///< two\n"
      "header\n"
      "  int n=0;\n\n   odd (  indent );\n"
      "body\n"
      "\toutput=goal ;  \n"
      "pend\n\n"
      "node a is A |to the goal| with goal = {1,2}; nend\n"
      "\n"
      "// the end\n");
}

TEST(Format, KeepsANodeOnOneLineOnlyWhereItsAuthorDidAndItFits) {
  EXPECT_EQ(formatted("node a is A with x=1; y=2; nend"), "node a is A with x = 1; y = 2; nend\n");
  EXPECT_EQ(formatted("node a is A with x=1;\ny=2; nend"), "node a is A with\n  x = 1;\n  y = 2;\nnend\n");
  EXPECT_EQ(formatted("node a is A with\nnend"), "node a is A with nend\n");
  EXPECT_EQ(formatted("node a is A with x=1; /* why */ y=2; nend"),
            "node a is A with\n  x = 1; /* why */ y = 2;\nnend\n");
  EXPECT_EQ(formatted("node a is A with\nv = b;  gain = 1;\nv = c;  gain = 2;\nnend"),
            "node a is A with\n  v = b; gain = 1;\n  v = c; gain = 2;\nnend\n");
  std::string links;
  for (int i = 0; i < 30; ++i) links += " input = 1;";
  const std::string out = formatted("node a is A with" + links + " nend");
  EXPECT_EQ(std::count(out.begin(), out.end(), '\n'), 2 + 30 / 8 + 1) << out;
}

TEST(Format, LaysOutOperatorsAndParameters) {
  EXPECT_EQ(
      formatted(
          "parameter double[m/s]speed=5 in 0 .. 9;///< how fast\n"
          "sequence job of Vector with start state A is a; when not t goto B restart; final state B is "
          "{0,0};nend\n"
          "select s of Vector by task with case 1,2:a;otherwise:b;nend delay d of Vector with value=s;nend"),
      "parameter double [m/s] speed = 5 in 0 .. 9;  ///< how fast\n"
      "sequence job of Vector with\n"
      "  start state A is a;\n"
      "    when not t goto B restart;\n"
      "  final state B is {0,0};\n"
      "nend\n"
      "select s of Vector by task with\n"
      "  case 1, 2: a;\n"
      "  otherwise: b;\n"
      "nend\n"
      "delay d of Vector with value = s; nend\n");
}

TEST(Format, RefusesWhatCannotBeRead) {
  text::Diagnostics sink;
  EXPECT_FALSE(format(source("node a is"), sink));
  EXPECT_TRUE(sink.has_errors());
}

TEST(Format, PrintsTheLibraryStablyAndKeepsItsMeaning) {
  const std::filesystem::path root(base::source_folder());
  std::size_t files = 0;
  for (const char* folder : {"library", "src/mlab/lang/cnl/testdata/run"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      if (entry.path().extension() != ".cnl") continue;
      ++files;
      const std::string text((*text::read_source(entry.path().string()))->text());
      const std::string once = formatted(text);
      EXPECT_EQ(formatted(once), once) << entry.path();
      EXPECT_EQ(meaning(source(once)), meaning(source(text))) << entry.path();
    }
  }
  EXPECT_GT(files, 20U);
}

// Source text out of pieces that fit together, with white space and comments in between.
std::string random_space() {
  static const std::vector<std::string> kSpaces = {
      " ", "\n", "\t", "  \n\n\n ", " // note\n", " /* block */ ", "\n/* a\n b */\n", "\n/// doc\n"};
  return *rc::gen::weightedOneOf<std::string>(
      {{6, rc::gen::just<std::string>(" ")}, {2, rc::gen::elementOf(kSpaces)}});
}
std::string joined(const std::vector<std::string>& tokens) {
  std::string out;
  for (const std::string& token : tokens) out += token + random_space();
  return out;
}
std::string random_item() {
  static const std::vector<std::vector<std::string>> kPieces = {
      {"node", "a", "is", "B", "with", "nend"},
      {"public", "node", "a", "is", "B", "|text|", "with", "x", "=", "(.5)", ";", "y", "=", "{1, 2}", ";",
       "nend"},
      {"parameter", "double", "[m/s]", "p", "=", "5", "in", "0", "..", "10", ";"},
      {"type", "<", "bool", ",", "\"boolean\"", ">", ";"},
      {"modulename", "=", "robot", ";"},
      {"external", "procedure", "int", "E", "with", "int", "x", ";", "pend"},
      {"procedure", "Vector",
       "[m]",       "P",
       "pure",      "alias",
       "OLD",       "[deg]",
       "(",         "a",
       "[deg]",     "=",
       "x",         ",",
       "b",         "=",
       "none",      ")",
       "senses",    "robots",
       "within",    "x",
       "with",      "list",
       "int",       "x",
       ";",         "double",
       "[m]",       "y",
       "=",         "5",
       "in",        "0",
       "..",        "1",
       ";",         "\nheader\n  int n; // c\n\nbody\n  f(\"}\");\n pend\n"},
      {"sequence", "s", "of", "Vector", "with", "start", "state", "A", "is", "a", ";", "when", "not", "t",
       "goto", "A", "restart", ";", "nend"},
      {"select", "s", "of", "Vector", "by", "t", "with", "case", "1", ",", "2", ":", "a", ";", "otherwise",
       ":", "b", ";", "nend"},
      {"delay", "d", "of", "Vector", "with", "value", "=", "a", ";", "nend"},
      {"init\n#include <vector>\n  struct X { };\niend\n"},
      {"\n#include \"other.cnl\"\n"},
  };
  return joined(*rc::gen::elementOf(kPieces));
}

RC_GTEST_PROP(Format, MeansTheSameAndIsStable, ()) {
  std::string text;
  const int items = *rc::gen::inRange(0, 6);
  for (int i = 0; i < items; ++i) text += random_item();
  text::Diagnostics sink;
  const auto once = format(source(text), sink);
  RC_ASSERT(once.has_value());
  const std::string first = once.value_or("");
  text::Diagnostics again;
  const auto twice = format(source(first), again);
  RC_ASSERT(twice.has_value());
  RC_ASSERT(twice.value_or("") == first);
  RC_ASSERT(meaning(source(first)) == meaning(source(text)));
}

}  // namespace
}  // namespace mlab::cnl
