#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/cnl/check.h"
#include "mlab/lang/cnl/elaborate.h"
#include "mlab/lang/cnl/load.h"
#include "mlab/lang/cnl/native_module.h"
#include "mlab/text/testing/golden.h"

namespace mlab::cnl {
namespace {

namespace golden = text::testing;
const std::filesystem::path kFolder = std::filesystem::path(base::source_folder()) / "src/mlab/lang/cnl";

// Goldens name files beside them, so the tests run in their folder.
class CnlGolden : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::current_path(before_); }

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
};

TEST_F(CnlGolden, FilesGetTheDiagnosticsThatStandAtTheirEnd) {
  std::filesystem::current_path(kFolder / "testdata");
  for (const auto& path : golden::golden_files(".", ".cnl")) {
    golden::check_golden(path, "//", [](const text::SourcePtr& source) {
      text::Diagnostics sink;
      const Tree tree = load(source, sink);
      check_declarations(tree, sink);
      elaborate(tree, sink);
      return text::render(sink);
    });
  }
}

TEST_F(CnlGolden, ErrorsOfTheCppCompilerAreAtTheAuthorsPlaces) {
#if !defined(__GNUC__) || defined(__clang__) || __GNUC__ != 12
  GTEST_SKIP() << "the expected messages are those of g++ 12";
#endif
  std::filesystem::current_path(kFolder / "testdata/cpp");
  NativeOptions options;
  options.wall = cell::choose_wall(cell::means()).value_or(cell::Wall::kNone);
  options.include_folders = {base::source_folder() + "/src"};
  options.limits.time = 3000.0;  // a busy machine is no mistake
  options.cache_folder = ::testing::TempDir() + "mlab_golden_cache";
  for (const auto& path : golden::golden_files(".", ".cnl")) {
    golden::check_golden(path, "//", [&](const text::SourcePtr& source) {
      text::Diagnostics sink;
      const Tree tree = load(source, sink);
      check_declarations(tree, sink);
      EXPECT_FALSE(sink.has_errors()) << text::render(sink);
      check_native(tree, options, sink);
      return text::render(sink);
    });
  }
  std::filesystem::remove_all(options.cache_folder);
}

TEST_F(CnlGolden, EveryKindOfDiagnosticHasOne) {
  auto files = golden::golden_files(kFolder / "testdata", ".cnl");
  for (auto& path : golden::golden_files(kFolder / "testdata/cpp", ".cnl")) files.push_back(path);
  auto said = golden::kinds_said_in(kFolder, {"error(", "warning(", "duplicate(", "failed(", "kind = "});
  // What the machine may lack has tests of its own: native_module_test.cc, load_test.cc.
  for (const char* kind :
       {"no-compiler", "compiler-limit", "compiler-failed", "cannot-write", "include-too-deep"}) {
    EXPECT_EQ(said.erase(kind), 1U) << kind;
  }
  EXPECT_GT(said.size(), 40U);
  EXPECT_EQ(said, golden::kinds_expected_in(files));
}

}  // namespace
}  // namespace mlab::cnl
