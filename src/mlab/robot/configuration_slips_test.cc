// Tried as a new user would: one thing at a time misspelt or left out in an example gets one message, at its
// place.

#include <filesystem>
#include <memory>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "mlab/lang/cdl/lexer.h"
#include "mlab/robot/configuration_file.h"
#include "mlab/text/testing/golden.h"

namespace mlab::robot {
namespace {

const std::filesystem::path kExample =
    std::filesystem::path(MLAB_SOURCE_DIR) / "src/mlab/lang/cdl/testdata/examples/forager.cdl";

text::Diagnostics checked(const std::string& text) {
  text::Diagnostics sink;
  check_configuration(std::make_shared<const text::Source>("forager.cdl", text), {}, sink);
  return sink;
}

// What is wrong with the answer to a slip at `offset`; empty where nothing is.
std::string judged(const std::string& text, std::uint32_t offset) {
  const text::Diagnostics sink = checked(text);
  const text::Source source("forager.cdl", text);
  const std::uint32_t line = source.line_column(offset).line;
  const std::string shown =
      "line " + std::to_string(line) + ": " + std::string(source.line(line)) + "\n" + text::render(sink);
  if (sink.items().size() > 1) return "more than one message for " + shown;
  if (sink.items().empty()) return "";
  const text::Place& place = sink.items()[0].place;
  const std::uint32_t said = place.source->line_column(place.span.begin).line;
  const std::uint32_t distance = said > line ? said - line : line - said;
  if (distance <= 1) return "";
  for (const text::Note& note : sink.items()[0].notes) {
    if (note.place.source->line_column(note.place.span.begin).line == line) return "";
  }
  // A name that is declared wrongly is unknown where it is used.
  for (const std::string& hint : sink.items()[0].hints) {
    if (hint.find("did you mean") != std::string::npos) return "";
  }
  return "far away from " + shown;
}

TEST(ASlipInTheForageExample, IsNotThereInTheExampleItself) {
  const text::Diagnostics sink = checked(text::testing::read_all(kExample));
  EXPECT_TRUE(sink.items().empty()) << text::render(sink);
}

TEST(ASlipInTheForageExample, GetsOneMessageWhenAWordIsLeftOut) {
  const std::string text = text::testing::read_all(kExample);
  int silent = 0;
  for (const cdl::Token& token : cdl::lex(text).tokens) {
    if (token.kind == cdl::Token::Kind::kEnd) continue;
    std::string without = text;
    without.replace(token.span.begin, token.span.end - token.span.begin, " ");
    EXPECT_EQ(judged(without, token.span.begin), "");
    silent += checked(without).items().empty() ? 1 : 0;
  }
  EXPECT_LT(silent, 40) << "what may be left out: units, `restart`, a `not`, the sign of a default";
}

TEST(ASlipInTheForageExample, GetsOneMessageWhenANameIsMisspelt) {
  const std::string text = text::testing::read_all(kExample);
  for (const cdl::Token& token : cdl::lex(text).tokens) {
    if (token.kind != cdl::Token::Kind::kName) continue;
    std::string wrong = text;
    const std::uint32_t middle = (token.span.begin + token.span.end) / 2;
    wrong.insert(middle, 1, 'q');
    EXPECT_EQ(judged(wrong, token.span.begin), "");
  }
}

}  // namespace
}  // namespace mlab::robot
