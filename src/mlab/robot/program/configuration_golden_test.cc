#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/text/testing/golden.h"

namespace mlab::robot {
namespace {

namespace golden = text::testing;
// The configurations stand with their language; here is the library whose procedures they name.
const std::filesystem::path kFolder = std::filesystem::path(base::source_folder()) / "src/mlab/lang/cdl";

// Goldens name files beside them, so the tests run in their folder.
class CdlGolden : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::current_path(kFolder / "testdata"); }
  void TearDown() override { std::filesystem::current_path(before_); }

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
};

TEST_F(CdlGolden, FilesGetTheDiagnosticsThatStandAtTheirEnd) {
  for (const auto& path : golden::golden_files(".", ".cdl")) {
    golden::check_golden(path, "//", [](const text::SourcePtr& source) {
      text::Diagnostics sink;
      check_configuration(source, {}, sink);
      return text::render(sink);
    });
  }
}

TEST_F(CdlGolden, EveryKindOfDiagnosticHasOne) {
  auto said = golden::kinds_said_in(kFolder, {"error(", "warning(", "refuse("});
  // Limits have a test of their own: configuration_limits_test.cc; so has what a mission names wrongly:
  // configuration_file_test.cc, and what CNL has no words for: arithmetic_values_test.cc.
  for (const char* kind : {"nested-too-deep", "too-many-nodes", "use-too-deep", "no-robot", "several-robots",
                           "ambiguous-program", "place-in-cnl"})
    EXPECT_EQ(said.erase(kind), 1U) << kind;
  std::set<std::string> expected = golden::kinds_expected_in(golden::golden_files(".", ".cdl"));
  // Units stand in brackets, too.
  std::erase_if(expected, [](const std::string& kind) {
    return kind != "syntax" && kind.find('-') == std::string::npos;
  });
  // Sentences of the grammar G are another language; formula_test.cc has its diagnostics.
  for (const auto& path : golden::golden_files(kFolder / "formula", ".cc")) {
    const std::string text = golden::read_all(path);
    std::erase_if(said, [&](const std::string& kind) {
      return !expected.contains(kind) && text.find('"' + kind + '"') != std::string::npos;
    });
  }
  EXPECT_GT(said.size(), 50U);
  EXPECT_EQ(said, expected);
}

}  // namespace
}  // namespace mlab::robot
