// Tried as a new user would: one thing at a time misspelt, mistyped or left out in the forage examples gets
// one message, at its place, that says how to mend it.

#include <filesystem>
#include <memory>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/cdl/syntax/lexer.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/text/testing/golden.h"

namespace mlab::robot {
namespace {

text::Diagnostics checked(const std::string& text) {
  text::Diagnostics sink;
  check_configuration(std::make_shared<const text::Source>("forager.cdl", text), {}, sink);
  return sink;
}

// Whether a reader knows then what to do: what is expected, what it would have to be, or where else to look.
bool says_how_to_mend(const text::Diagnostic& said) {
  return !said.hints.empty() || !said.label.empty() || !said.notes.empty() ||
         said.message.find("expected") != std::string::npos ||
         said.message.find("takes") != std::string::npos || said.message.find("has no ") != std::string::npos;
}

// What is wrong with the answer to a slip at `offset`; empty where nothing is.
std::string judged(const std::string& text, std::uint32_t offset) {
  const text::Diagnostics sink = checked(text);
  const text::Source source("forager.cdl", text);
  const std::uint32_t line = source.line_column(offset).line;
  const std::string shown =
      "line " + std::to_string(line) + ": " + std::string(source.line(line)) + "\n" + text::render(sink);
  // A parenthesis that never opened leaves a brace that does not close.
  const bool is_bracket = sink.items().size() == 2 && sink.items()[1].kind == "unclosed-block";
  if (sink.items().size() > 1 && !is_bracket) return "more than one message for " + shown;
  if (sink.items().empty()) return "";
  if (!says_how_to_mend(sink.items()[0])) return "no word of how to mend " + shown;
  const text::Place& place = sink.items()[0].place;
  const std::uint32_t said = place.source->line_column(place.span.begin).line;
  const std::uint32_t distance = said > line ? said - line : line - said;
  if (distance <= 1) return "";
  for (const text::Note& note : sink.items()[0].notes) {
    if (note.place.source->line_column(note.place.span.begin).line == line) return "";
  }
  // A parameter whose only use is left out is told where it is declared, and an assemblage whose name is
  // misspelt leaves its calls to the library's of that name.
  const std::string& kind = sink.items()[0].kind;
  const std::string_view slip = source.line(line);
  if (kind == "unused-parameter" || slip.starts_with("assemblage Acqquire")) return "";
  // A name that is declared wrongly is unknown where it is used.
  for (const std::string& hint : sink.items()[0].hints) {
    if (hint.find("did you mean") != std::string::npos) return "";
  }
  return "far away from " + shown;
}

class ASlipInAForageExample : public testing::TestWithParam<const char*> {
 protected:
  const std::string text_ =
      text::testing::read_all(std::filesystem::path(base::source_folder()) / GetParam());
  const cdl::Tokens tokens_ = cdl::lex(text_);

  std::string word(const cdl::Token& token) const {
    return text_.substr(token.span.begin, token.span.end - token.span.begin);
  }
  std::string with(const cdl::Token& token, const std::string& instead) const {
    std::string out = text_;
    return out.replace(token.span.begin, token.span.end - token.span.begin, instead);
  }
};

TEST_P(ASlipInAForageExample, IsNotThereInTheExampleItself) {
  const text::Diagnostics sink = checked(text_);
  EXPECT_TRUE(sink.items().empty()) << text::render(sink);
}

TEST_P(ASlipInAForageExample, GetsOneMessageWhenAWordIsLeftOut) {
  std::size_t silent = 0;
  for (const cdl::Token& token : tokens_.tokens) {
    if (token.kind == cdl::Token::Kind::kEnd) continue;
    const std::string without = with(token, " ");
    EXPECT_EQ(judged(without, token.span.begin), "") << "without `" << word(token) << "`";
    silent += checked(without).items().empty() ? 1 : 0;
  }
  // What may be left out: units, `restart`, a `not`, the name of an argument at its place, a `;` before `}`.
  EXPECT_LT(silent, tokens_.tokens.size() / 8);
}

TEST_P(ASlipInAForageExample, GetsOneMessageWhenANameIsMisspelt) {
  for (const cdl::Token& token : tokens_.tokens) {
    if (token.kind != cdl::Token::Kind::kName) continue;
    std::string wrong = text_;
    wrong.insert((token.span.begin + token.span.end) / 2, 1, 'q');
    EXPECT_EQ(judged(wrong, token.span.begin), "") << "misspelt `" << word(token) << "`";
  }
}

TEST_P(ASlipInAForageExample, GetsOneErrorWhenANumberIsOfAnotherType) {
  for (const cdl::Token& token : tokens_.tokens) {
    if (token.kind != cdl::Token::Kind::kNumber) continue;
    for (const char* other : {"\"far\"", "Flag"}) {
      const std::string wrong = with(token, other);
      EXPECT_EQ(judged(wrong, token.span.begin), "") << other << " instead of " << word(token);
      EXPECT_TRUE(checked(wrong).has_errors()) << other << " instead of " << word(token);
    }
  }
}

TEST_P(ASlipInAForageExample, GetsOneErrorWhenAUnitIsAnother) {
  const std::set<std::string> units = {"m", "cm", "s", "deg"};
  for (std::size_t i = 1; i < tokens_.tokens.size(); ++i) {
    const cdl::Token& token = tokens_.tokens[i];
    if (tokens_.tokens[i - 1].kind != cdl::Token::Kind::kNumber || !units.contains(word(token))) continue;
    const bool is_length = word(token) == "m" || word(token) == "cm";
    for (const std::string other : {is_length ? "s" : "km", "parsec"}) {
      const std::string wrong = with(token, other);
      EXPECT_EQ(judged(wrong, token.span.begin), "") << other << " instead of " << word(token);
      EXPECT_TRUE(checked(wrong).has_errors()) << other << " instead of " << word(token);
    }
  }
}

// `GetOrderFormation()` gives what no member, trigger or percept of the examples is.
TEST_P(ASlipInAForageExample, GetsOneErrorWhenACallGivesAnotherType) {
  const std::set<std::string> leads = {":", "when", "not", "=", "active"};
  int tried = 0;
  for (std::size_t i = 1; i + 2 < tokens_.tokens.size(); ++i) {
    const bool is_call = tokens_.tokens[i].kind == cdl::Token::Kind::kName &&
                         word(tokens_.tokens[i + 1]) == "(" && word(tokens_.tokens[i + 2]) == ")" &&
                         leads.contains(word(tokens_.tokens[i - 1]));
    if (!is_call) continue;
    const std::string wrong = with(tokens_.tokens[i], "GetOrderFormation");
    EXPECT_EQ(judged(wrong, tokens_.tokens[i].span.begin), "") << "for " << word(tokens_.tokens[i]);
    EXPECT_TRUE(checked(wrong).has_errors()) << "for " << word(tokens_.tokens[i]);
    ++tried;
  }
  EXPECT_GE(tried, 3);
}

INSTANTIATE_TEST_SUITE_P(Of, ASlipInAForageExample,
                         testing::Values("src/mlab/lang/cdl/testdata/examples/forager.cdl",
                                         "missions/forage/forager.cdl"),
                         [](const auto& one) { return one.index == 0 ? "TheLanguage" : "TheMission"; });

}  // namespace
}  // namespace mlab::robot
