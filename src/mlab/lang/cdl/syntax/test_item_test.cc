// Tests of components, as a text and as a tree.

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/lang/cdl/lower/tests.h"
#include "mlab/lang/cdl/print/changes.h"
#include "mlab/lang/cdl/print/format.h"
#include "mlab/lang/cdl/print/print.h"
#include "mlab/lang/cdl/syntax/parser.h"

namespace mlab::cdl {
namespace {

constexpr const char* kTest = R"(/// Why.
test "comes" of Come([1 m, 2 m]) as come on Cart {
  let before = delay(come);
  given self(at = [1 m, 0 m], heading = 90 deg);
  /// Somebody stands there.
  given robot([2 m, 0 m]);
  expect come;
  expect (come or before) and not come;
  expect within 5 cycles: state Coming;
  expect for 2 s: no state Come.Waiting;
  expect no action PickUp;
  after 1 cycle;
  given no robot;
  expect for 3 cycles: length(come) > 2 m/s;
}
)";

text::SourcePtr source_of(const std::string& text) {
  return std::make_shared<const text::Source>("a.cdl", text);
}

Tree tree_of(const std::string& text) {
  text::Diagnostics sink;
  Tree tree = parse(source_of(text), sink);
  EXPECT_TRUE(sink.items().empty()) << text::render(sink);
  return tree;
}

TEST(CdlTest, IsPrintedAsItIsWritten) {
  const Tree tree = tree_of(kTest);
  EXPECT_EQ(print(tree), kTest);
  ASSERT_EQ(tests_of(tree).size(), 1U);
  EXPECT_EQ(tests_of(tree).front()->steps.size(), 10U);
  EXPECT_EQ(subject_name(*tests_of(tree).front()).text, "come");
}

TEST(CdlTest, HasALayout) {
  text::Diagnostics sink;
  const std::string untidy =
      "test \"a\"  of F( ) on G{ given   x(at=[1 m,2 m]) ;// c\n expect(it); expect within 5 cycles:state A "
      "; }";
  EXPECT_EQ(format(source_of(untidy), sink).value_or(""),
            "test \"a\" of F() on G {\n  given x(at = [1 m, 2 m]);  // c\n  expect (it);\n"
            "  expect within 5 cycles: state A;\n}\n");
}

TEST(CdlTest, MayTestWhatIsPutTogetherThere) {
  const std::string text =
      "test \"x\" of cooperate { 1: A(); 2: B(); } on Cart {\n  expect it;\n}\n\n"
      "test \"y\" of sequence {\n  start C: D();\n} {\n  expect state C;\n}\n";
  text::Diagnostics sink;
  EXPECT_EQ(format(source_of(text), sink).value_or(text::render(sink)), text);
  ASSERT_EQ(tests_of(tree_of(text)).size(), 2U);
  EXPECT_EQ(tests_of(tree_of(text)).front()->class_name.text, "Cart");
}

TEST(CdlTest, KeepsEverythingElseWhenAStepIsChanged) {
  const std::string text =
      "test \"a\" of F() {\n  given x( at = [1,2] ); // here\n  expect it;\n  after 5   cycles; // why\n}\n";
  const Tree tree = tree_of(text);
  const auto& test = std::get<cdl::Test>(tree.items.front());
  Changes changes(tree);
  changes.replace(*test.steps[1].condition, parse_value(source_of("it > 3")));
  EXPECT_EQ(changes.done().text,
            "test \"a\" of F() {\n  given x( at = [1,2] ); // here\n  expect it > 3;\n  after 5   cycles; // "
            "why\n}\n");
}

TEST(CdlTest, WordsOfTestsAreNamesElsewhereAndInConditions) {
  const std::string text =
      "assemblage test(given: gain, expect: gain) {\n  let after = Noise();\n  let no = after;\n"
      "  cooperate {\n    given * expect: no;\n  }\n}\n\n"
      "test \"x\" of test(1, 2) {\n  let state = 1;\n  let within = 2;\n  let no = 3;\n  let action = 4;\n"
      "  expect state < 3;\n  expect within > 3;\n  expect no > 3;\n  expect action > 3;\n}\n";
  EXPECT_EQ(print(tree_of(text)), text);
}

TEST(CdlTest, TellsWhichWordsCouldFollow) {
  using Words = std::vector<std::string>;
  const auto next = [](const std::string& text) { return read_as_written(source_of(text)).next_words; };
  EXPECT_EQ(next("test \"x\" of F() "), (Words{"as", "active", "and", "or", "on"}));
  EXPECT_EQ(next("test \"x\" of F() { "), (Words{"let", "given", "after", "expect"}));
  EXPECT_EQ(next("test \"x\" of F() { given "), (Words{"no"}));
  EXPECT_EQ(next("test \"x\" of F() { expect "), (Words{"within", "for", "state", "action"}));
  EXPECT_EQ(next("test \"x\" of F() { expect within 3 s: "), (Words{"state", "action"}));
}

TEST(CdlTest, KeepsWhatIsNotWhole) {
  const auto steps = [](const std::string& text) {
    const PartialFile written = read_as_written(source_of("test \"x\" of F() { " + text));
    return std::get<cdl::Test>(written.tree.items.at(0)).steps;
  };
  EXPECT_EQ(steps("given obstacle(at = ").size(), 1U);
  EXPECT_EQ(steps("given obstacle(at = ").front().percept.arguments.size(), 1U);
  EXPECT_EQ(steps("expect ").size(), 1U);
  EXPECT_TRUE(std::holds_alternative<Hole>(steps("expect ").front().condition->what));
  EXPECT_EQ(steps("expect state ").front().kind, TestStep::Kind::kExpect);
  EXPECT_EQ(steps("expect within ").size(), 1U);
  EXPECT_EQ(steps("after \n expect it;").size(), 2U);
}

TEST(CdlTest, SlipsAreToldOnceAndTheRestIsRead) {
  text::Diagnostics sink;
  const Tree tree = parse(source_of("test \"x\" of F() {\n  expect within 5 it;\n  wait 3 s;\n  expect it\n"
                                    "  after;\n  expect it;\n}\ntest y of F() {}\nassemblage A() { B() }\n"),
                          sink);
  EXPECT_EQ(sink.error_count(), 5U) << text::render(sink);
  EXPECT_EQ(tests_of(tree).size(), 1U);
  EXPECT_TRUE(std::holds_alternative<Assemblage>(tree.items.back()));
}

}  // namespace
}  // namespace mlab::cdl
