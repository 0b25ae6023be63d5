#include "mlab/lang/cdl_historic/standing.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "mlab/lang/cdl/syntax/parser.h"

namespace mlab::cdl_historic {
namespace {

std::string standing_in(const std::string& text) {
  text::Diagnostics sink;
  const cdl::Tree tree = cdl::parse(std::make_shared<const text::Source>("ours.cdl", text), sink);
  EXPECT_FALSE(sink.has_errors()) << text::render(sink);
  return said_of(standing_robots(tree));
}

const std::string kEmpty = "assemblage Dock(speed: gain = 1) -> Vector;\nassemblage Near() -> bool;\n";

TEST(Standing, IsWhoIsDrivenByNothing) {
  EXPECT_EQ(standing_in(kEmpty + "robot R { movement = Dock(); } robot S { movement = Noise(); }"),
            "R (no Dock)");
  EXPECT_EQ(standing_in(kEmpty + "robot R { let d = Dock(); movement = d; }"), "R (no Dock)");
  EXPECT_EQ(standing_in(kEmpty + "assemblage Go() { cooperate { 1: Dock(); 0.5: Stand(); } } "
                                 "robot R { movement = Go(); }"),
            "R (no Dock)");
  EXPECT_EQ(standing_in(kEmpty + "robot R { movement = Stand(); }"), "") << "that was meant";
}

TEST(Standing, IsNobodyWhomSomethingElseMoves) {
  EXPECT_EQ(standing_in(kEmpty + "robot R { movement = cooperate { 1: Dock(); 1: Noise(); }; }"), "");
  EXPECT_EQ(
      standing_in(kEmpty + "robot R { movement = sequence { start A: Noise(); when Near() goto A; }; }"), "")
      << "a trigger moves nothing";
}

TEST(Standing, NamesTheStatesInWhichARobotStands) {
  EXPECT_EQ(
      standing_in(
          kEmpty +
          "robot R { movement = sequence { start A: Noise(); when Near() goto B; B: sequence { "
          "start C: Dock(); when Near() goto D; D: Noise(); when Near() goto C; }; final E: Dock(); }; }"),
      "R in the states B.C, E (no Dock)");
  EXPECT_EQ(standing_in(kEmpty + "robot R { movement = sequence { start A: Stand(); when Near() goto B; "
                                 "final B: Dock(); }; }"),
            "R (no Dock)");
}

TEST(Standing, EndsWhereAssemblagesCallEachOtherInACircle) {
  EXPECT_EQ(standing_in("assemblage A() { B() } assemblage B() { A() } robot R { movement = A(); }"), "");
}

}  // namespace
}  // namespace mlab::cdl_historic
