#include "mlab/lang/odl/lexer.h"

#include <cmath>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace mlab::odl {
namespace {

// The tokens as text, one letter for the kind before each: `#1 wPP s"x"`.
std::string lexed(const std::string& text) {
  const auto source = std::make_shared<const text::Source>("t", text);
  std::vector<Token> tokens;
  std::vector<Comment> comments;
  text::Diagnostics sink;
  lex(source, tokens, comments, sink);
  std::string out;
  for (const Token& t : tokens) {
    if (t.kind == TokenKind::kEnd) break;
    constexpr std::string_view kLetters = "#wfsh";
    if (!out.empty()) out += ' ';
    out += kLetters[static_cast<std::size_t>(t.kind)];
    out += source->text(t.span);
  }
  for (const Comment& c : comments) out += fmt::format("|{}", source->text(c.span));
  out += std::string(sink.warning_count(), '!');
  return out;
}

TEST(OdlLexer, TakesTheLongestMatch) {
  EXPECT_EQ(lexed("12 .5 1.5 605. -3 +4 1e5 1e+5 1E-3 -.5"),
            "#12 #.5 #1.5 #605. #-3 #+4 #1e5 #1e+5 #1E-3 #-.5");
  EXPECT_EQ(lexed("1.2.3 3d a.raw - 1e"), "f1.2.3 f3d fa.raw f- f1e");
  EXPECT_EQ(lexed("1+2"), "#1 #+2");
  EXPECT_EQ(lexed("abc* abc*d a1_b-c"), "wabc* wabc* wd wa1_b-c");
  EXPECT_EQ(lexed("LD/LC ldlc"), "wLD/LC wldlc");
}

TEST(OdlLexer, StartsACommentOnlyWhereATokenMayStart) {
  EXPECT_EQ(lexed("a -- b \t\nc"), "wa wc|-- b");
  EXPECT_EQ(lexed("abc--x"), "wabc--x");
  EXPECT_EQ(lexed("0.3--x"), "f0.3--x");
  EXPECT_EQ(lexed("0, --0.75"), "#0|--0.75!");
  EXPECT_EQ(lexed("0.3,-- x"), "#0.3|-- x!");
  EXPECT_EQ(lexed("-----------\nPP"), "wPP|-----------");
  EXPECT_EQ(lexed("\"a -- b\""), "s\"a -- b\"");
}

TEST(OdlLexer, KnowsTheHeaderByItsAttachedColon) {
  EXPECT_EQ(lexed("control \t Measures:"), "hcontrol \t Measures:");
  EXPECT_EQ(lexed("CONTROL MEASURES :"), "wCONTROL wMEASURES!");
  EXPECT_EQ(lexed("CONTROL\nMEASURES:"), "wCONTROL wMEASURES!");
}

TEST(OdlLexer, SkipsStrayCharactersWithOneWarningForEachRun) {
  EXPECT_EQ(lexed("PP a (1, 2), 4;"), "wPP wa #1 #2 #4!!!!");
  EXPECT_EQ(lexed("12*"), "#12!");
  EXPECT_EQ(lexed("/*****/"), "!");
}

TEST(OdlLexer, TakesDosLineEndsAndAByteOrderMarkAsWhiteSpace) {
  EXPECT_EQ(lexed("\xef\xbb\xbfPP\r\na 1 -- c\r\n"), "wPP wa #1|-- c");
  EXPECT_EQ(lexed("a\rb"), "wa wb!");
}

TEST(OdlLexer, EndsAnOpenStringWithItsLine) {
  EXPECT_EQ(lexed("\"abc\nd \"\""), "s\"abc wd s\"\"");
}

TEST(OdlNumberValue, IsInfiniteWhereADoubleCannotHoldIt) {
  EXPECT_EQ(number_value("+605."), 605.0);
  EXPECT_EQ(number_value("-1.5e+2"), -150.0);
  EXPECT_TRUE(std::isinf(number_value("1e999")));
}

}  // namespace
}  // namespace mlab::odl
