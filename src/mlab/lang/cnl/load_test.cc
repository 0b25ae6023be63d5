#include "mlab/lang/cnl/load.h"

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace mlab::cnl {
namespace {

namespace fs = std::filesystem;

class LoadTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              ("mlab_load_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "part");
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  Tree read(const std::string& name) {
    return load(*text::read_source((folder_ / name).string()), sink_, &files_);
  }
  static std::string names(const Tree& tree) {
    std::string out;
    for (const Procedure* procedure : items_of<Procedure>(tree)) out += procedure->name.text + " ";
    for (const NodeDecl* node : items_of<NodeDecl>(tree)) out += node->node.name + " ";
    return out;
  }

  fs::path folder_;
  text::Diagnostics sink_;
  std::vector<std::string> files_;
};

std::string procedure(const std::string& name) {
  return "procedure int " + name + " with\nheader\nbody\npend\n";
}

TEST_F(LoadTest, IncludedFilesStandInThePlaceOfTheirInclude) {
  write("main.cnl", "#include \"part/first.cnl\"\n" + procedure("B") + "#include \"nodes.cnl\"\n");
  write("part/first.cnl", "#include \"deep.cnl\"\n" + procedure("A"));
  write("part/deep.cnl", procedure("Deep"));  // relative to the file that includes it
  write("nodes.cnl", "node a is A with nend\n");
  EXPECT_EQ(names(read("main.cnl")), "Deep A B a ");
  EXPECT_EQ(sink_.items().size(), 0U) << text::render(sink_);
  EXPECT_EQ(files_.size(), 3U);
}

TEST_F(LoadTest, AFileIsReadOnceHoweverOftenItIsIncluded) {
  write("main.cnl", "#include \"common.cnl\"\n#include \"other.cnl\"\n#include \"part/../common.cnl\"\n");
  write("other.cnl", "#include \"common.cnl\"\n");
  write("common.cnl", procedure("A"));
  EXPECT_EQ(names(read("main.cnl")), "A ");
  EXPECT_EQ(sink_.items().size(), 0U) << text::render(sink_);
}

TEST_F(LoadTest, FilesThatIncludeEachOtherTooDeeplyAreRefused) {
  constexpr int kFiles = kMaxIncludeDepth + 10;
  for (int i = 0; i < kFiles; ++i) {
    write("f" + std::to_string(i) + ".cnl", "#include \"f" + std::to_string(i + 1) + ".cnl\"\n");
  }
  read("f0.cnl");
  ASSERT_EQ(sink_.error_count(), 1U);
  EXPECT_EQ(sink_.items()[0].kind, "include-too-deep");
}

TEST_F(LoadTest, ADeclarationInAnIncludedFileBehindANodeIsSaidToBeLate) {
  write("main.cnl", "node a is A with nend\n#include \"late.cnl\"\n");
  write("late.cnl", procedure("A"));
  read("main.cnl");
  ASSERT_EQ(sink_.error_count(), 1U);
  EXPECT_EQ(sink_.items()[0].kind, "declaration-after-node");
}

TEST(LooksLikeCnl, TellsItFromTheOtherLanguages) {
  EXPECT_TRUE(looks_like_cnl("// robot\nprocedure Vector A with\n"));
  EXPECT_TRUE(looks_like_cnl("#include \"a.cnl\"\nnode a is B with nend\n"));
  EXPECT_TRUE(looks_like_cnl("type <bool,\"boolean\">;"));
  EXPECT_TRUE(looks_like_cnl("modulename = robot;"));
  EXPECT_TRUE(looks_like_cnl("init\n#include <vector>\niend\n"));
  EXPECT_TRUE(looks_like_cnl("parameter double [m/s] speed = 5;"));
  EXPECT_FALSE(looks_like_cnl("MISSION NAME \"demo\"\nUNIT a ROBOT\n"));
  EXPECT_FALSE(looks_like_cnl("SITE lab\nCONTROL MEASURES:\nAA a 1 2\n"));
  EXPECT_FALSE(looks_like_cnl("/* CDL */ defArchitecture AuRA;\ninstBinding robot from x( ... );\n"));
  EXPECT_FALSE(looks_like_cnl(""));
  EXPECT_FALSE(looks_like_cnl(std::string(200'000, '|')));
}

}  // namespace
}  // namespace mlab::cnl
