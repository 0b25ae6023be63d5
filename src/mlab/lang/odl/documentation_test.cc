// The examples of the language's page are parsed, so that it does not promise what is not so.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/odl/map_info.h"
#include "mlab/lang/odl/odl.h"
#include "mlab/lang/odl/parser.h"
#include "mlab/text/testing/golden.h"

namespace mlab::odl {
namespace {

std::string page() {
  return text::testing::read_all(base::source_folder() + "/docs/languages/odl.md");
}

std::vector<text::SourcePtr> examples(const std::string& language) {
  std::vector<text::SourcePtr> out;
  const std::string text = page();
  const std::string fence = "\n```" + language + "\n";
  for (std::size_t at = text.find(fence); at != std::string::npos; at = text.find(fence, at + 1)) {
    const std::size_t begin = at + fence.size();
    out.push_back(std::make_shared<const text::Source>(
        "odl.md", text.substr(begin, text.find("\n```", begin) + 1 - begin)));
  }
  return out;
}

TEST(OdlPage, HasExamplesThatParseWithoutAComplaint) {
  const auto found = examples("odl");
  EXPECT_EQ(found.size(), 4U);
  for (const text::SourcePtr& source : found) {
    text::Diagnostics sink;
    overlay::Overlay overlay;
    const bool is_whole = source->text().find("CONTROL MEASURES:") != std::string_view::npos;
    apply(is_whole ? parse(source, sink) : parse_features(source, sink), overlay, sink, Companions::kIgnore);
    EXPECT_EQ(text::render(sink), "");
    EXPECT_FALSE(overlay.measures.empty());
  }
}

TEST(OdlPage, HasAMapInfoFileThatParses) {
  for (const text::SourcePtr& source : examples("mapinfo")) {
    text::Diagnostics sink;
    EXPECT_TRUE(parse_map_info(source, sink)) << text::render(sink);
  }
  EXPECT_EQ(examples("mapinfo").size(), 1U);
}

TEST(OdlPage, NamesEveryStatement) {
  const std::string text = page();
  for (const Word& word : words()) EXPECT_NE(text.find(word.spelling), std::string::npos) << word.spelling;
}

}  // namespace
}  // namespace mlab::odl
