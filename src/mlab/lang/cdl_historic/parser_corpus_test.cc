#include <cstdlib>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/cdl_historic/parser.h"
#include "mlab/text/testing/golden.h"

namespace mlab::cdl_historic {
namespace {

namespace fs = std::filesystem;

// Real configurations of the historic system, where they are at hand.
fs::path corpus() {
  const char* named = std::getenv("MLAB_CORPUS");  // NOLINT(concurrency-mt-unsafe): nobody sets it here
  return (named != nullptr ? fs::path(named) : fs::path(base::source_folder()) / "../shared/corpus") /
         "configurations";
}

TEST(HistoricParserCorpus, ReadsEveryFileWithoutAWord) {
  if (!fs::is_directory(corpus())) GTEST_SKIP() << "no corpus at " << corpus();
  const auto files = text::testing::golden_files(corpus(), ".cdl");
  EXPECT_FALSE(files.empty());
  for (const fs::path& path : files) {
    const auto source = text::read_source(path.string());
    ASSERT_TRUE(source.has_value()) << path;
    text::Diagnostics sink;
    const Tree tree = parse(*source, sink);
    EXPECT_TRUE(sink.items().empty()) << text::render(sink);
    EXPECT_FALSE(tree.expressions.empty()) << path;
  }
}

}  // namespace
}  // namespace mlab::cdl_historic
