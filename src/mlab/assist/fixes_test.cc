#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/assist/service.h"
#include "mlab/base/testing/source_folder.h"
#include "mlab/text/testing/golden.h"

namespace mlab::assist {
namespace {

namespace fs = std::filesystem;
using Strings = std::vector<std::string>;

Text text_of(const std::string& path, std::string content) {
  const auto source = std::make_shared<const text::Source>(path, std::move(content));
  return {source, language_of(*source).value_or(Language::kConfiguration)};
}

Surroundings quick() {
  Surroundings out;
  out.checks_code = false;
  return out;
}

std::string mended(const Text& text, const Fix& fix) {
  std::string out;
  std::uint32_t at = 0;
  for (const Splice& splice : fix.splices) {
    out += text.source->text({at, splice.span.begin});
    out += splice.text;
    at = splice.span.end;
  }
  return out + std::string(text.source->text().substr(at));
}

/// Titles of what is offered for the first problem.
Strings mends(const std::string& path, const std::string& content) {
  const Text text = text_of(path, content);
  const text::Diagnostics wrong = problems(text, quick());
  std::vector<std::string> out;
  if (wrong.items().empty()) return {"nothing is wrong"};
  for (const Fix& fix : fixes(text, wrong.items().front(), quick())) out.push_back(fix.title);
  return out;
}

TEST(Fixes, OfferNamesThatWereMeant) {
  EXPECT_EQ(mends("x.cdl", "assemblage A() {\n  Noisee()\n}\n"), Strings{"write `Noise`"});
  EXPECT_EQ(mends("x.cdl", "assemblge A() {\n  Noise()\n}\n"), Strings{"write `assemblage`"});
  EXPECT_EQ(mends("x.mdl", "UNIT <a> ROBOT\nSP s 1 1\nCOMMAND LIST:\n1. UNIT a MOVTO s\n"),
            Strings{"write `MOVETO`"});
  EXPECT_EQ(mends("x.odl", "CONTROL MEASURES:\nOBSTACEL 1 2 3\n"), Strings{"write `OBSTACLE`"});
  EXPECT_EQ(mends("x.odl", "CONTROL MEASURES:\nOBX Pond 330 180 40\n"), Strings{"write `OBJ`"});
}

TEST(Fixes, OfferKeywordsOfEnvironmentChanges) {
  EXPECT_EQ(mends("x.env", "STEPCOUNT 3\nADD OBSTACLE 10 20 2\n"), Strings{"write `STEP_COUNT`"});
  EXPECT_EQ(mends("x.env", "STEP_COUNT 3\nADDD OBSTACLE 10 20 2\n"), Strings{"write `ADD`"});
}

TEST(Fixes, OfferWhatIsMissing) {
  EXPECT_EQ(mends("x.cdl", "assemblage A() {\n  cooperate {\n    1: Noise()\n    1: Noise();\n  }\n}\n"),
            Strings{"insert `;`"});
  EXPECT_EQ(mends("x.cdl", "assemblage A() {\n  cooperate {\n    1: Noise();\n  }\n"), Strings{"insert `}`"});
  EXPECT_EQ(mends("x.cdl", "use \"skills.cdl;\n"), Strings{"insert `\"`"});
  EXPECT_EQ(mends("x.cdl", "assemblage A() {\n  sequence {\n    One: Noise();\n  }\n}\n"),
            Strings{"insert `start`"});
}

TEST(Fixes, OfferUnitsAndRanges) {
  EXPECT_EQ(mends("x.cdl", "assemblage A() {\n  Noise(persistence = 2 m)\n}\n"), Strings{"write `2 s`"});
  const Strings bounds = mends("x.cdl", "assemblage A() {\n  Noise(persistence = -2 s)\n}\n");
  EXPECT_FALSE(bounds.empty());
}

TEST(Fixes, OfferTheNearestBoundWhereANumberLeavesItsRange) {
  EXPECT_EQ(mends("x.env", "STEP_COUNT -3\nADD OBSTACLE 10 20 2\n"), Strings{"write `0`"});
  const std::string mission = "UNIT <a> ROBOT\nSP s 1 1\nCOMMAND LIST:\n1. UNIT a START s\n";
  EXPECT_EQ(mends("x.mdl", "SET ZOOM-FACTOR 500\n" + mission), Strings{"write `400`"});
}

TEST(Fixes, OfferToLeaveOutWhatHasNoUse) {
  EXPECT_EQ(mends("x.cdl", "assemblage A() {\n  let unused = Noise();\n  Noise()\n}\n"),
            Strings{"remove `let unused`"});
  EXPECT_EQ(mends("x.cdl", "assemblage A(a: gain = 1, b: gain = 1) {\n  cooperate { a: Noise(); }\n}\n"),
            Strings{"remove `b`"});
}

// The law, over everything that any language has to say.
TEST(Fixes, AMendMakesItsProblemGoAway) {
  const fs::path languages = fs::path(base::source_folder()) / "src/mlab/lang";
  std::size_t wrong_count = 0;
  std::size_t mended_count = 0;
  std::map<std::string, int> offered_kinds;
  for (const auto& [folder, ending] : {std::pair{"cdl", ".cdl"}, std::pair{"cnl", ".cnl"},
                                       std::pair{"mdl", ".mdl"}, std::pair{"odl", ".odl"}}) {
    for (const fs::path& path : text::testing::golden_files(languages / folder / "testdata", ending)) {
      const std::string all = text::testing::read_all(path);
      const std::string comment = std::string(folder) == "mdl" || std::string(folder) == "odl" ? "--" : "//";
      const Text text = text_of(path.string(), all.substr(0, all.find(comment + " EXPECTED\n")));
      const text::Diagnostics wrong = problems(text, quick());
      for (const text::Diagnostic& problem : wrong.items()) {
        ++wrong_count;
        const std::vector<Fix> all_fixes = fixes(text, problem, quick());
        if (!all_fixes.empty()) ++mended_count;
        if (!all_fixes.empty()) ++offered_kinds[problem.kind];
        for (const Fix& fix : all_fixes) {
          const Text after = text_of(path.string(), mended(text, fix));
          std::int64_t at = problem.place.span.begin;
          for (const Splice& splice : fix.splices) {
            if (splice.span.begin < problem.place.span.begin)
              at += static_cast<std::int64_t>(splice.text.size()) - (splice.span.end - splice.span.begin);
          }
          const text::Diagnostics left = problems(after, quick());
          for (const text::Diagnostic& rest : left.items()) {
            EXPECT_FALSE(rest.kind == problem.kind && rest.message == problem.message &&
                         rest.place.span.begin == at)
                << path << ": " << fix.title << " leaves " << text::render(rest);
          }
        }
      }
    }
  }
  std::string kinds;
  for (const auto& [kind, count] : offered_kinds) kinds += kind + " " + std::to_string(count) + ", ";
  RecordProperty("problems", static_cast<int>(wrong_count));
  RecordProperty("mended", static_cast<int>(mended_count));
  EXPECT_GT(wrong_count, 250U);
  EXPECT_GT(mended_count, 70U) << "of " << wrong_count << ": " << kinds;
}

}  // namespace
}  // namespace mlab::assist
