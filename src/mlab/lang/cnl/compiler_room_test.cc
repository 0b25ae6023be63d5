#include "mlab/lang/cnl/compiler_room.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "mlab/cell/means.h"
#include "mlab/lang/cnl/compiler_process.h"

namespace mlab::cnl {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSecret = "the_secret_word";

/// A project beside a secret.
class CompilerRoomTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::canonical(fs::path(::testing::TempDir())) /
              ("mlab_room_" + std::to_string(getpid()) + "_" + name);
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "project" / ".hidden");
    fs::create_directories(folder_ / "project" / "parts");
    put("secret.h", std::string(kSecret) + "\n");
    put("project/gain.h", "#pragma once\ninline constexpr double kGain = 2;\n");
    put("project/parts/more.h", "inline constexpr double kMore = 3;\n");
    put("project/.hidden/key.h", std::string(kSecret) + "\n");
    put("project/.env.h", std::string(kSecret) + "\n");
    fs::create_symlink(folder_ / "secret.h", folder_ / "project" / "link.h");
    fs::create_symlink(folder_, folder_ / "project" / "up");
    fs::create_symlink("gain.h", folder_ / "project" / "same.h");
  }
  void TearDown() override { fs::remove_all(folder_); }

  void put(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  struct CompileResult {
    bool is_made = false;
    std::string all;  ///< what the compiler said and wrote
  };
  CompileResult compile(const std::string& text, cell::Wall wall,
                        ProjectPart part = ProjectPart::kAll) const {
    const fs::path own = folder_ / "own";
    fs::remove_all(own);
    fs::create_directory(own);
    put("own/text.cc", text);
    const CompilerRoom room{wall, {{}, {path("project")}, part}, own.string()};
    const std::string object = (own / "code.o").string();
    const ProcessResult result =
        run_process({"g++", "-iquote" + path("project"), "-c", path("own/text.cc"), "-o", object}, room, {});
    CompileResult out{result.end == ProcessResult::End::kExited && result.status == 0, result.output};
    std::ifstream made(object, std::ios::binary);
    out.all.append(std::istreambuf_iterator<char>(made), {});
    return out;
  }

  fs::path folder_;
};

TEST_F(CompilerRoomTest, OpensOfAProjectNothingHiddenAndNoLinkThatLeadsOut) {
  std::vector<std::string> files = project_files(path("project"));
  std::ranges::sort(files);
  EXPECT_EQ(files, (std::vector<std::string>{path("project/gain.h"), path("project/gain.h"),
                                             path("project/parts")}));
}

TEST_F(CompilerRoomTest, OpensOfAHomeFolderOnlyTheSourcesThatLieInIt) {
  put("project/notes.txt", "x");
  const char* before = std::getenv("HOME");
  const std::string home = before ? before : "";
  setenv("HOME", path("project").c_str(), 1);
  std::vector<std::string> files = project_files(path("project"));
  std::vector<std::string> above = project_files(folder_.string());
  setenv("HOME", home.c_str(), 1);
  std::ranges::sort(files);
  EXPECT_EQ(files, (std::vector<std::string>{path("project/gain.h"), path("project/gain.h")}));
  EXPECT_EQ(above, std::vector<std::string>{path("secret.h")});
}

TEST_F(CompilerRoomTest, OpensOfAProjectThatOthersWriteIntoNothingButSources) {
  put("project/town.odl", "#error written by somebody else\n");
  put("project/parts/plan.cdl", "#error written by somebody else\n");
  fs::create_symlink("town.odl", folder_ / "project" / "town.h");
  std::vector<std::string> files = project_files(path("project"), ProjectPart::kSources);
  std::ranges::sort(files);
  EXPECT_EQ(files, (std::vector<std::string>{path("project/gain.h"), path("project/gain.h"),
                                             path("project/parts/more.h")}));
  for (const char* file : {"m.mdl", "m.odl", "m.ovl", "m.cdl"}) EXPECT_FALSE(is_source(file)) << file;
  const auto wall = cell::choose_wall(cell::means());
  if (!wall) GTEST_SKIP() << wall.error();
  for (const std::string file : {"town.odl", "parts/plan.cdl", "town.h"}) {
    const std::string text = "#include \"" + file + "\"\n";
    const CompileResult made = compile(text, *wall, ProjectPart::kSources);
    EXPECT_EQ(made.all.find("written by somebody else"), std::string::npos) << made.all;
    EXPECT_FALSE(made.is_made);
    const CompileResult twin = compile(text, *wall);
    EXPECT_NE(twin.all.find("written by somebody else"), std::string::npos) << "does not bite: " << twin.all;
  }
  const CompileResult good =
      compile("#include \"gain.h\"\n#include \"parts/more.h\"\ndouble x = kGain + kMore;\n", *wall,
              ProjectPart::kSources);
  EXPECT_TRUE(good.is_made) << good.all;
}

TEST_F(CompilerRoomTest, CompilesWithTheHeadersOfTheSystemAndOfTheProject) {
  const auto wall = cell::choose_wall(cell::means());
  if (!wall) GTEST_SKIP() << wall.error();
  const CompileResult made = compile(
      "#include <cmath>\n#include <vector>\n#include \"gain.h\"\n#include \"parts/more.h\"\n#include "
      "\"same.h\"\n"
      "double f() { return std::sqrt(kGain) + kMore; }\n",
      *wall);
  EXPECT_TRUE(made.is_made) << made.all;
}

// Each way by which a text can name a file that is none of the project's.
TEST_F(CompilerRoomTest, NoTrickBringsTheWordsOfAForeignFile) {
  const auto wall = cell::choose_wall(cell::means());
  if (!wall) GTEST_SKIP() << wall.error();
  const std::string secret = path("secret.h");
  const std::vector<std::string> tricks = {
      "#include \"" + secret + "\"\n", "#include <" + secret + ">\n", "%:include \"" + secret + "\"\n",
      "#define FILE \"" + secret + "\"\n#include FILE\n", "#import \"" + secret + "\"\n",
      "#include \"../secret.h\"\n", "#include \"link.h\"\n", "#include \"up/secret.h\"\n",
      "#include \".env.h\"\n", "#include \".hidden/key.h\"\n", "#inc\\\nlude \"" + secret + "\"\n",
      "/* */ # /* */ include \"" + secret + "\"\n",
      "#if __has_include(\"" + secret + "\")\n#include \"" + secret + "\"\n#endif\nint x = 0;\n",
      "asm(\".incbin \\\"" + secret + "\\\"\");\n", "asm(\".include \\\"" + secret + "\\\"\");\n",
      "asm(R\"(.inc)\" \"bin \\\"" + secret + "\\\"\");\n",
      "void f() { asm volatile(\".incbin \\\"" + secret + "\\\"\"); }\n",
      // The compiler shows the line that a mistake stands in.
      "#line 1 \"" + secret + "\"\nmistake;\n"};
  for (const std::string& trick : tricks) {
    const CompileResult made = compile(trick, *wall);
    EXPECT_EQ(made.all.find(kSecret), std::string::npos) << trick << made.all;
    const CompileResult twin = compile(trick, cell::Wall::kNone);
    EXPECT_NE(twin.all.find(kSecret), std::string::npos) << "does not bite: " << trick << twin.all;
  }
}

TEST_F(CompilerRoomTest, ACompilerWritesOnlyIntoItsOwnFolderAndKnowsNothingOfOurEnvironment) {
  const auto wall = cell::choose_wall(cell::means());
  if (!wall) GTEST_SKIP() << wall.error();
  fs::create_directory(folder_ / "own");
  put("compiler", "#!/bin/sh\necho x > " + path("made") + "\necho y > $TMPDIR/made\nenv\n");
  fs::permissions(folder_ / "compiler", fs::perms::owner_all);
  setenv("MLAB_TEST_SECRET", kSecret, 1);
  const ProcessResult result = run_process({path("compiler")}, {*wall, {}, path("own")}, {});
  unsetenv("MLAB_TEST_SECRET");
  EXPECT_FALSE(fs::exists(folder_ / "made")) << result.output;
  EXPECT_TRUE(fs::exists(folder_ / "own" / "made")) << result.output;
  EXPECT_EQ(result.output.find(kSecret), std::string::npos) << result.output;
}

}  // namespace
}  // namespace mlab::cnl
