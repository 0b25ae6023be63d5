#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/lang/mdl/token.h"

namespace mlab::mdl {
namespace {

struct Seen {
  TokenKind kind;
  std::string text;
  friend bool operator==(const Seen&, const Seen&) = default;
};

std::vector<Seen> tokens(const std::string& text) {
  text::Diagnostics sink;
  const auto source = std::make_shared<const text::Source>("test", text);
  std::vector<Seen> out;
  for (const Token& token : lex(source, sink).tokens) {
    if (token.kind != TokenKind::kEnd) out.push_back({token.kind, std::string(source->text(token.span))});
  }
  return out;
}

TokenKind only_kind(const std::string& text) {
  const std::vector<Seen> seen = tokens(text);
  return seen.size() == 1 && seen[0].text == text ? seen[0].kind : TokenKind::kEnd;
}

TEST(MdlLexer, TellsNumbersFromLabelsTimesAndDates) {
  for (const char* number : {"12", "-12", ".5", "-.5", "1.5", "1e3", "1.5e-3", "2E+05", "-1.", "1.e5"}) {
    EXPECT_EQ(only_kind(number), TokenKind::kNumber) << number;
  }
  for (const char* label : {"0.", "2a.", "10b2.", "10."})
    EXPECT_EQ(only_kind(label), TokenKind::kLabel) << label;
  for (const char* time : {"1:30", "12:30", "12:30:15", "+12:30", "+5", "+1:30:00", "+500"}) {
    EXPECT_EQ(only_kind(time), TokenKind::kTime) << time;
  }
  for (const char* date : {"1-02-95", "12-25-95"}) EXPECT_EQ(only_kind(date), TokenKind::kDate) << date;
}

TEST(MdlLexer, TellsNamesFromFiles) {
  for (const char* name : {"a", "AA-AA1", "x_1*", "abc--x", "StartPlace*", "MISSION"}) {
    EXPECT_EQ(only_kind(name), TokenKind::kName) << name;
  }
  for (const char* file :
       {"3d", "democ.ovl", "./robot", "/a/b.c~", "97-20.ovl", "0.3--x", "0.UNIT", "12-25-95x"}) {
    EXPECT_EQ(only_kind(file), TokenKind::kFile) << file;
  }
}

TEST(MdlLexer, TakesTheLongestMatch) {
  EXPECT_EQ(
      tokens("10:30:5"),
      (std::vector<Seen>{{TokenKind::kTime, "10:30"}, {TokenKind::kColon, ":"}, {TokenKind::kNumber, "5"}}));
  EXPECT_EQ(tokens("-5-3"), (std::vector<Seen>{{TokenKind::kNumber, "-5"}, {TokenKind::kNumber, "-3"}}));
  EXPECT_EQ(tokens("a*b"), (std::vector<Seen>{{TokenKind::kName, "a*"}, {TokenKind::kName, "b"}}));
}

TEST(MdlLexer, KnowsKeywordsInAnyLetterCase) {
  EXPECT_EQ(only_kind("moveTo"), TokenKind::kWord);
  EXPECT_EQ(only_kind("Wedge-Left"), TokenKind::kFormation);
  EXPECT_EQ(only_kind("bounding-overwatch"), TokenKind::kTechnique);
  EXPECT_EQ(only_kind("Yes"), TokenKind::kBoolean);
  EXPECT_EQ(only_kind("SHOW-REPELLING-OBSTACLES"), TokenKind::kWord);
  EXPECT_EQ(only_kind("HEADING"), TokenKind::kName);
}

TEST(MdlLexer, FoldsSynonyms) {
  const auto word = [](const char* text) { return find_keyword(text)->word; };
  EXPECT_EQ(word("TELOP"), word_of(mission::Task::kTeleoperate));
  EXPECT_EQ(word("console-db"), Word::kConsoleDatabase);
  EXPECT_EQ(word("ACK"), Word::kAcknowledge);
  EXPECT_EQ(word("MSG"), Word::kMessage);
  EXPECT_EQ(word("SYSTEM-SEED"), Word::kSeed);
  EXPECT_EQ(word("SHOW-ROBOT-TRAILS"), Word::kShowTrails);
  EXPECT_EQ(word("SHOW-MILITARY-STYLE"), Word::kUseMilitaryStyle);
}

TEST(MdlLexer, WantsTheWordsOfAHeaderOnOneLineAndItsColonAttached) {
  EXPECT_EQ(only_kind("MISSION  \tNAME"), TokenKind::kMissionName);
  EXPECT_EQ(only_kind("command list:"), TokenKind::kCommandList);
  EXPECT_EQ(only_kind("Immediate Command:"), TokenKind::kImmediateCommand);
  EXPECT_EQ(tokens("MISSION\nNAME").size(), 2U);
  EXPECT_EQ(tokens("COMMAND LIST :").size(), 3U);
  EXPECT_EQ(tokens("COMMAND-LIST:").size(), 2U);
  EXPECT_EQ(tokens("COMMAND LIST:0."),
            (std::vector<Seen>{{TokenKind::kCommandList, "COMMAND LIST:"}, {TokenKind::kLabel, "0."}}));
}

TEST(MdlLexer, FindsCommentsWhereATokenMayBegin) {
  EXPECT_EQ(tokens("0.3,-- x").size(), 2U);
  EXPECT_EQ(tokens("0, --0.75").size(), 2U);
  EXPECT_EQ(tokens("a -- b\nc").size(), 2U);
  EXPECT_EQ(tokens("\"a -- b\"").size(), 1U);
}

TEST(MdlLexer, RemembersWhereCommentsAndBlankLinesStand) {
  text::Diagnostics sink;
  const auto source = std::make_shared<const text::Source>("test", "a -- one\n\n-- two  \r\nb\n");
  const Tokens lexed = lex(source, sink);
  ASSERT_EQ(lexed.comments.size(), 2U);
  EXPECT_FALSE(lexed.comments[0].own_line);
  EXPECT_TRUE(lexed.comments[1].own_line);
  EXPECT_TRUE(lexed.comments[1].blank_line_before);
  EXPECT_EQ(source->text(lexed.comments[1].span), "-- two");
  EXPECT_EQ(lexed.comments[1].next_token, 1U);
  EXPECT_TRUE(lexed.tokens[1].first_on_line);
  EXPECT_FALSE(lexed.tokens[1].blank_line_before);
}

TEST(MdlLexer, AcceptsWindowsLineEndsAndAByteOrderMarkInSilence) {
  text::Diagnostics sink;
  EXPECT_EQ(lex(std::make_shared<const text::Source>("test", "\xEF\xBB\xBFQUIT\r\n"), sink).tokens.size(),
            2U);
  EXPECT_EQ(text::render(sink), "");
}

}  // namespace
}  // namespace mlab::mdl
