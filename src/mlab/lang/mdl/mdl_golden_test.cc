#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/testing/societies.h"
#include "mlab/text/testing/golden.h"

namespace mlab::mdl {
namespace {

namespace golden = text::testing;
const std::filesystem::path kFolder = std::filesystem::path(base::source_folder()) / "src/mlab/lang/mdl";

// Goldens name overlays beside them, so the tests run in their folder.
class MdlGolden : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::current_path(kFolder / "testdata"); }
  void TearDown() override { std::filesystem::current_path(before_); }

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
};

TEST_F(MdlGolden, MissionsGetTheDiagnosticsThatStandAtTheirEnd) {
  for (const auto& path : golden::golden_files(".", ".mdl")) {
    golden::check_golden(path, "--", [](const text::SourcePtr& source) {
      text::Diagnostics sink;
      LoadOptions options;
      options.societies = mdl::testing::known_society;
      const auto mission = check_mission(source, "", sink, options);
      EXPECT_EQ(mission == nullptr, sink.has_errors());
      return text::render(sink);
    });
  }
}

TEST_F(MdlGolden, TypedCommandsGetTheDiagnosticsThatStandBelowThem) {
  text::Diagnostics none;
  const auto mission = load_mission("good.mdl", none);
  ASSERT_NE(mission, nullptr);
  for (const auto& path : golden::golden_files(".", ".typed")) {
    golden::check_golden(path, "--", [&](const text::SourcePtr& source) {
      text::Diagnostics sink;
      const auto typed = parse_immediate(std::string(source->text()), *mission, sink);
      EXPECT_EQ(!typed.has_value(), sink.has_errors());
      return text::render(sink);
    });
  }
}

TEST_F(MdlGolden, EveryKindOfDiagnosticHasOne) {
  auto files = golden::golden_files(".", ".mdl");
  for (auto& path : golden::golden_files(".", ".typed")) files.push_back(path);
  const auto said =
      golden::kinds_said_in(kFolder, {"error(", "warning(", "note(", "fail(", "complain(", "warn_once("});
  EXPECT_GT(said.size(), 50U);
  auto shown = golden::kinds_expected_in(files);
  shown.insert("too-many-points");  // takes an overlay of megabytes: see limits_test.cc
  // What is wrong with settings from outside stands in no mission: see settings_test.cc.
  shown.insert({"no-formation", "not-a-number", "unknown-overlay", "unknown-word", "which-overlay"});
  for (const std::string& kind : said) EXPECT_TRUE(shown.contains(kind)) << kind;
}

}  // namespace
}  // namespace mlab::mdl
