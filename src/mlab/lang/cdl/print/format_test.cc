#include "mlab/lang/cdl/print/format.h"

#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace mlab::cdl {
namespace {

std::string formatted(const std::string& text) {
  text::Diagnostics sink;
  const auto out = format(std::make_shared<const text::Source>("a.cdl", text), sink);
  EXPECT_TRUE(out) << text::render(sink);
  if (!out) return "";
  EXPECT_EQ(laid_out(*out), *out) << "formatting again changes something";
  return *out;
}

TEST(CdlFormat, LaysOutBlocksAndKeepsComments) {
  EXPECT_EQ(
      formatted("// top\n\n\n/// Help.\nassemblage  Wander( curious:gain=.8 , near:double[m]=50cm in 0..1e3 "
                ")->Vector{ // why\n"
                "let o=sense(range=2m); // two\nlet other = 3; // three\ncooperate{curious:Noise( );\n\n\n"
                "// before\n1:(Probe(o)); /* last */\n// end\n}}\n// bottom"),
      "// top\n"
      "\n"
      "/// Help.\n"
      "assemblage Wander(curious: gain = .8, near: double [m] = 50 cm in 0 .. 1e3) -> Vector {  // why\n"
      "  let o = sense(range = 2 m);  // two\n"
      "  let other = 3;               // three\n"
      "  cooperate {\n"
      "    curious: Noise();\n"
      "\n"
      "    // before\n"
      "    1: (Probe(o)); /* last */\n"
      "    // end\n"
      "  }\n"
      "}\n"
      "// bottom\n");
}

TEST(CdlFormat, SetsTransitionsInBelowTheirState) {
  EXPECT_EQ(formatted("assemblage A() { sequence {\nstart B: C();\nwhen not (D() or E()) goto F;\n"
                      "// why\nwhen G() goto B restart; final F: sequence { start X: Y(); }; } }"),
            "assemblage A() {\n"
            "  sequence {\n"
            "    start B: C();\n"
            "      when not (D() or E()) goto F;\n"
            "      // why\n"
            "      when G() goto B restart;\n"
            "    final F: sequence { start X: Y(); };\n"
            "  }\n"
            "}\n");
}

TEST(CdlFormat, KeepsAShortBlockOnItsLine) {
  EXPECT_EQ(formatted("class A { body { radius=0.3m; } }"), "class A { body { radius = 0.3 m; } }\n");
  EXPECT_EQ(formatted("class A { body { radius=0.3m; }\n}"), "class A {\n  body { radius = 0.3 m; }\n}\n");
}

TEST(CdlFormat, BreaksLongListsOfArgumentsBehindACommaAndKeepsTheAuthorsBreaks) {
  EXPECT_EQ(formatted("assemblage A() { Something(first = 1,\nsecond = 2, third = 3); }\n"),
            "assemblage A() {\n  Something(first = 1,\n            second = 2, third = 3);\n}\n");
  const std::string name(30, 'x');
  EXPECT_EQ(formatted("assemblage A() {\n let y = F(" + name + " = 1, " + name + " = 2, " + name +
                      " = 3, z = 4); y }"),
            "assemblage A() {\n  let y = F(" + name + " = 1, " + name + " = 2,\n            " + name +
                " = 3, z = 4);\n  y\n}\n");
}

TEST(CdlFormat, PutsHelpOfParametersBehindThem) {
  EXPECT_EQ(formatted("robot R(a: gain = 1,  ///< one\nlonger: gain = 2  ///< two\n) is C { movement = a; }"),
            "robot R(a: gain = 1,      ///< one\n"
            "        longer: gain = 2  ///< two\n"
            ") is C { movement = a; }\n");
}

TEST(CdlFormat, LeavesAFileWithErrorsAlone) {
  text::Diagnostics sink;
  EXPECT_FALSE(format(std::make_shared<const text::Source>("a.cdl", "assemblage"), sink));
  EXPECT_TRUE(sink.has_errors());
}

}  // namespace
}  // namespace mlab::cdl
