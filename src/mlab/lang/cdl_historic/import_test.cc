#include "mlab/lang/cdl_historic/import.h"

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/cdl/print/print.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/text/testing/golden.h"

/// The procedures of the component library, which stands above this module and is linked to its tests only.
std::span<const mlab::flow::Behavior* const> mlab_library_behaviors();

namespace mlab::cdl_historic {
namespace {

namespace golden = text::testing;
const std::filesystem::path kFolder =
    std::filesystem::path(base::source_folder()) / "src/mlab/lang/cdl_historic";

class HistoricImport : public ::testing::Test {
 protected:
  HistoricImport() {
    procedures_.add(mlab_library_behaviors());
    text::Diagnostics sink;
    const auto source = text::read_source((kFolder / "testdata/library/library.cdl").string());
    library_.push_back(std::make_shared<const cdl::Tree>(cdl::parse(*source, sink)));
    EXPECT_TRUE(sink.items().empty()) << text::render(sink);
    vocabulary_ = std::make_unique<Vocabulary>(procedures_, library_);
  }

  flow::Library procedures_;
  std::vector<std::shared_ptr<const cdl::Tree>> library_;
  std::unique_ptr<Vocabulary> vocabulary_;
};

TEST_F(HistoricImport, GivesTheConfigurationAndTheDiagnosticsThatStandAtTheEndOfEachFile) {
  for (const auto& path : golden::golden_files(kFolder / "testdata", ".cdl")) {
    golden::check_golden(path, "//", [&](const text::SourcePtr& source) {
      text::Diagnostics sink;
      const std::string out = import_as_text(source, *vocabulary_, sink);
      return out + "\n" + text::render(sink);
    });
  }
}

TEST_F(HistoricImport, GivesAFileThatReadsAndPrintsTheSameAgain) {
  for (const auto& path : golden::golden_files(kFolder / "testdata", ".cdl")) {
    text::Diagnostics sink;
    const auto source = text::read_source(path.string());
    const cdl::Tree tree = import(*source, *vocabulary_, sink);
    text::Diagnostics again;
    const std::string printed = cdl::print(tree);
    EXPECT_EQ(cdl::print(cdl::parse(std::make_shared<const text::Source>("ours.cdl", printed), again)),
              printed)
        << path;
    EXPECT_TRUE(again.items().empty()) << text::render(again);
  }
}

TEST_F(HistoricImport, EveryKindOfDiagnosticHasAGolden) {
  auto shown = golden::kinds_expected_in(golden::golden_files(kFolder / "testdata", ".cdl"));
  // These take files of megabytes or a library without robots, see below.
  shown.insert({"too-large", "nested-too-deeply", "no-robot-class"});
  const auto said = golden::kinds_said_in(kFolder, {"error(", "warning(", "warn_once("});
  EXPECT_GT(said.size(), 20U);
  for (const std::string& kind : said) {
    EXPECT_TRUE(shown.contains(kind)) << kind;
  }
}

TEST_F(HistoricImport, SaysWhereThereIsNoClassOfRobotsAtAll) {
  const Vocabulary bare(procedures_, {});
  text::Diagnostics sink;
  import(
      std::make_shared<const text::Source>("old.cdl",
                                           "instBP w from movement( bound_to = b:DRIVE() );\n"
                                           "instBP v from vehicle( bound_to = r:MRV2( r:[ w ] ) );\n[ v ]\n"),
      bare, sink);
  ASSERT_EQ(sink.items().size(), 1U) << text::render(sink);
  EXPECT_EQ(sink.items()[0].kind, "no-robot-class");
}

TEST_F(HistoricImport, RefusesSharingThatWritesOutWithoutEnd) {
  std::string text = "instGroup g0 from [ NOISE( persistence = {^T %p} ) ];\n";
  for (int i = 1; i < 40; ++i) {
    const std::string number = std::to_string(i), below = ", g" + std::to_string(i - 1) + " ]";
    text += "instGroup g" + number + " from [ COOP( ";
    for (const std::string member : {"1", "2", "3", "4"})
      text += "members[" + member + "] = [ %p" + number + " = {" + member + "}" + below + ", ";
    text += "weight[1] = {^T %p" + number + "}, weight[2] = {1} ) ];\n";
  }
  text::Diagnostics sink;
  import(std::make_shared<const text::Source>("old.cdl", text + "[ %p = {3}, g39 ]"), *vocabulary_, sink);
  ASSERT_TRUE(sink.has_errors());
  EXPECT_EQ(sink.error_count(), 1U);
}

TEST_F(HistoricImport, FollowsOnlySoManyReferencesIntoTheDepth) {
  std::string text = "instGroup g0 from [ NOOP() ];\n";
  for (int i = 1; i < 5000; ++i) {
    text += "instGroup g" + std::to_string(i) + " from [ g" + std::to_string(i - 1) + " ];\n";
  }
  text::Diagnostics sink;
  import(std::make_shared<const text::Source>("old.cdl", text + "[ g4999 ]"), *vocabulary_, sink);
  ASSERT_FALSE(sink.items().empty());
  EXPECT_EQ(sink.items()[0].kind, "nested-too-deeply");
}

}  // namespace
}  // namespace mlab::cdl_historic
