#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/odl/map_info.h"
#include "mlab/lang/odl/odl.h"
#include "mlab/text/testing/golden.h"

namespace mlab::odl {
namespace {

namespace golden = text::testing;
const std::filesystem::path kFolder = std::filesystem::path(base::source_folder()) / "src/mlab/lang/odl";

// Goldens name files beside them, so the tests run in their folder.
class OdlGolden : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::current_path(kFolder / "testdata"); }
  void TearDown() override { std::filesystem::current_path(before_); }

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
};

TEST_F(OdlGolden, OverlaysGetTheDiagnosticsThatStandAtTheirEnd) {
  for (const auto& path : golden::golden_files(".", ".odl")) {
    golden::check_golden(path, "--", [](const text::SourcePtr& source) {
      text::Diagnostics sink;
      overlay::Overlay overlay;
      apply(parse(source, sink), overlay, sink);
      return text::render(sink);
    });
  }
}

TEST_F(OdlGolden, MapInfoFilesGetTheDiagnosticsThatStandAtTheirEnd) {
  for (const auto& path : golden::golden_files(".", ".mapinfo")) {
    golden::check_golden(path, "#", [](const text::SourcePtr& source) {
      text::Diagnostics sink;
      static_cast<void>(parse_map_info(source, sink));
      return text::render(sink);
    });
  }
}

TEST_F(OdlGolden, EveryKindOfDiagnosticHasOne) {
  auto files = golden::golden_files(".", ".odl");
  for (auto& path : golden::golden_files(".", ".mapinfo")) files.push_back(path);
  const auto said =
      golden::kinds_said_in(kFolder, {"error(", "warning(", "fail(", "fail_expected(", "warn_missing(sink,"});
  EXPECT_GT(said.size(), 15U);
  EXPECT_EQ(said, golden::kinds_expected_in(files));
}

}  // namespace
}  // namespace mlab::odl
