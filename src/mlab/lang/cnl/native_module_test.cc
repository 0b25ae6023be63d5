#include "mlab/lang/cnl/native_module.h"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/flow/module_file.h"
#include "mlab/flow/program.h"
#include "mlab/lang/cnl/check.h"
#include "mlab/lang/cnl/elaborate.h"
#include "mlab/lang/cnl/load.h"

namespace mlab::cnl {
namespace {

namespace fs = std::filesystem;

class NativeModuleTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              ("mlab_native_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    options_.include_folders = {base::source_folder() + "/src"};
    options_.cache_folder = (folder_ / "cache").string();
    options_.wall = cell::choose_wall(cell::means()).value_or(cell::Wall::kNone);
    options_.limits.time = 3000.0;  // a busy machine is no mistake
  }
  void TearDown() override { fs::remove_all(folder_); }

  Tree tree(const std::string& text) {
    const std::string path = (folder_ / "mine.cnl").string();
    std::ofstream(path) << text;
    Tree out = load(*text::read_source(path), sink_);
    check_declarations(out, sink_);
    EXPECT_FALSE(sink_.has_errors()) << text::render(sink_);
    return out;
  }
  NativeModule compiled(const Tree& mine) {
    auto module = compile_native(mine, options_, sink_);
    EXPECT_TRUE(module) << text::render(sink_);
    return std::move(module).value_or(NativeModule{});
  }
  // What compilers leave in their folders while they work.
  bool has_own_file() const {
    std::error_code gone;
    for (fs::recursive_directory_iterator each(options_.cache_folder, gone), end; !gone && each != end;
         each.increment(gone)) {
      if (each->path().filename() == "own") return true;
    }
    return false;
  }
  /// Loaded into this test, whose code it is.
  static std::span<const flow::Behavior* const> behaviors_of(const NativeModule& module) {
    const auto opened = flow::open_module(module.file);
    EXPECT_TRUE(opened) << opened.error();
    return opened.value_or(std::span<const flow::Behavior* const>());
  }
  std::string first_kind() const { return sink_.items().empty() ? "" : sink_.items()[0].kind; }

  fs::path folder_;
  NativeOptions options_;
  text::Diagnostics sink_;
};

constexpr const char* kSpeed = R"(procedure void Speed with
  double [m/s] v = 1;
header
  int n = 0;
body
  action.velocity.x = v * ++n;
pend
node drive is Speed with v = 2; nend
)";

TEST_F(NativeModuleTest, RunsProceduresThatAMissionBringsAlong) {
  const Tree mine = tree(kSpeed);
  const NativeModule module = compiled(mine);
  EXPECT_TRUE(module.was_compiled);
  flow::Library library;
  library.add(behaviors_of(module));
  const auto program = flow::build_program(elaborate(mine, sink_), library, sink_);
  ASSERT_TRUE(program) << text::render(sink_);
  flow::Frame frame = program->make_frame();
  const percept::Percepts percepts;
  percept::Action action;
  for (int i = 0; i < 3; ++i) program->step(frame.data(), percepts, action, 1, 1);
  EXPECT_EQ(action.velocity.x, 6.0);
}

TEST_F(NativeModuleTest, TakesWhatDidNotChangeFromTheCache) {
  ASSERT_TRUE(compile_native(tree(kSpeed), options_, sink_));
  const NativeModule again = compiled(tree(kSpeed));
  EXPECT_FALSE(again.was_compiled);
  const NativeModule changed = compiled(tree(std::string(kSpeed) + "// other text\n"));
  EXPECT_FALSE(changed.was_compiled) << "a comment between declarations does not reach the compiler";
  options_.version = "another";
  const NativeModule other_version = compiled(tree(kSpeed));
  EXPECT_TRUE(other_version.was_compiled);
}

TEST_F(NativeModuleTest, TellsTheCompilersWarningsAgainWhenTheLibraryComesFromTheCache) {
  const char* text = "procedure int Odd with\nheader\n  int unused = 0;\nbody\n  output = 1;\npend\n";
  EXPECT_TRUE(compiled(tree(text)).was_compiled);
  const std::string first = text::render(sink_);
  EXPECT_EQ(sink_.warning_count(), 1U) << first;
  sink_ = {};
  EXPECT_FALSE(compiled(tree(text)).was_compiled);
  EXPECT_EQ(text::render(sink_), first);
}

TEST_F(NativeModuleTest, RefusesExceptionsWhichNobodyWouldCatch) {
  const Tree mine = tree("procedure int Thrower with\nheader\nbody\n  throw 3;\npend\n");
  EXPECT_FALSE(compile_native(mine, options_, sink_));
  EXPECT_EQ(first_kind(), "cpp-error");
  EXPECT_NE(text::render(sink_).find("mine.cnl:4:"), std::string::npos) << text::render(sink_);
}

TEST_F(NativeModuleTest, CompilesAnewWhenAHeaderThatItIncludesHasChanged) {
  const char* text =
      "init\n#include \"gain.h\"\niend\nprocedure double Gain with\nheader\nbody\n  output = kGain;\npend\n";
  std::ofstream(folder_ / "gain.h") << "inline constexpr double kGain = 1;\n";
  const NativeModule first = compiled(tree(text));
  std::ofstream(folder_ / "gain.h") << "inline constexpr double kGain = 22;\n";
  const NativeModule second = compiled(tree(text));
  EXPECT_TRUE(second.was_compiled);
  EXPECT_NE(second.file, first.file);
  double value = 0.0;
  const percept::Percepts percepts;
  const flow::Cycle cycle{&percepts, nullptr, 1, 0, 0};
  flow::Call call;
  call.cycle = &cycle;
  call.frame = reinterpret_cast<std::byte*>(&value);
  behaviors_of(second)[0]->fire(call);
  EXPECT_EQ(value, 22.0);
}

TEST_F(NativeModuleTest, LeavesNothingButTheLibraryInTheCache) {
  ASSERT_TRUE(compile_native(tree(kSpeed), options_, sink_));
  EXPECT_TRUE(check_native(tree(kSpeed), options_, sink_));
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(options_.cache_folder)) {
    ++files;
    EXPECT_TRUE(entry.path().extension() == ".so" || entry.path().extension() == ".d") << entry.path();
  }
  EXPECT_EQ(files, 2U);
}

TEST_F(NativeModuleTest, AModuleNamedLikeAFileOfTheLibraryHasItsOwnProcedures) {
  // This program has a function mlab_cnl_state() of its own.
  const std::string path = (folder_ / "state.cnl").string();
  std::ofstream(path) << "procedure int Alone with\nheader\nbody\n  output = 1;\npend\n";
  const Tree state = load(*text::read_source(path), sink_);
  const NativeModule module = compiled(state);
  const auto behaviors = behaviors_of(module);
  ASSERT_EQ(behaviors.size(), 1U);
  EXPECT_EQ(behaviors[0]->name, "Alone");
}

TEST_F(NativeModuleTest, SaysWhatToInstallWhereThereIsNoCompiler) {
  options_.compiler = "no-such-compiler";
  EXPECT_FALSE(check_native(tree(kSpeed), options_, sink_));
  EXPECT_EQ(first_kind(), "no-compiler");
  EXPECT_NE(text::render(sink_).find("apt-get install g++"), std::string::npos);
}

TEST_F(NativeModuleTest, StopsACompilerThatTakesTooLong) {
  const std::string slow = (folder_ / "slow").string();
  std::ofstream(slow) << "#!/bin/sh\nsleep 60 & wait\n";
  fs::permissions(slow, fs::perms::owner_all);
  options_.compiler = slow;
  options_.limits.time = 0.2;
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(check_native(tree(kSpeed), options_, sink_));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
  EXPECT_EQ(first_kind(), "compiler-limit");
}

TEST_F(NativeModuleTest, StopsACompilerThatNobodyWaitsForAnyMoreAndLetsItTakeItsFilesAway) {
  const std::string slow = (folder_ / "slow").string();
  std::ofstream(slow)
      << "#!/bin/sh\ntrap 'rm $TMPDIR/own; exit 1' TERM\necho x > $TMPDIR/own\nsleep 60 & wait\n";
  fs::permissions(slow, fs::perms::owner_all);
  options_.compiler = slow;
  std::stop_source ends;
  options_.limits.ends = ends.get_token();
  std::thread other([&] {
    while (!has_own_file()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    ends.request_stop();
  });
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(check_native(tree(kSpeed), options_, sink_));
  other.join();
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
  EXPECT_EQ(first_kind(), "compiler-failed");
  EXPECT_FALSE(has_own_file());
  EXPECT_TRUE(fs::is_empty(options_.cache_folder)) << "what it was given is taken away, too";
}

TEST_F(NativeModuleTest, AStoppedCompilerThatDoesNotListenIsKilled) {
  const std::string deaf = (folder_ / "deaf").string();
  std::ofstream(deaf) << "#!/bin/sh\ntrap '' TERM\nwhile true; do sleep 1; done\n";
  fs::permissions(deaf, fs::perms::owner_all);
  options_.compiler = deaf;
  std::stop_source ends;
  ends.request_stop();
  options_.limits.ends = ends.get_token();
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(check_native(tree(kSpeed), options_, sink_));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

TEST_F(NativeModuleTest, StopsACompilerThatWorksTooLong) {
  const std::string busy = (folder_ / "busy").string();
  std::ofstream(busy) << "#!/bin/sh\nwhile true; do :; done\n";
  fs::permissions(busy, fs::perms::owner_all);
  options_.compiler = busy;
  options_.limits.processor_time = 1;
  EXPECT_FALSE(check_native(tree(kSpeed), options_, sink_));
  EXPECT_EQ(first_kind(), "compiler-limit") << text::render(sink_);
}

TEST_F(NativeModuleTest, StopsACompilerThatWantsTooMuchMemory) {
  options_.limits.memory = std::size_t{48} << 20;
  EXPECT_FALSE(check_native(tree(kSpeed), options_, sink_));
  EXPECT_TRUE(first_kind() == "compiler-limit" || first_kind() == "compiler-failed") << text::render(sink_);
}

TEST_F(NativeModuleTest, SaysWhenTheCompilerFailsWithoutAWord) {
  const std::string broken = (folder_ / "broken").string();
  std::ofstream(broken) << "#!/bin/sh\necho 'cannot find the parts of me'\nexit 3\n";
  fs::permissions(broken, fs::perms::owner_all);
  options_.compiler = broken;
  EXPECT_FALSE(compile_native(tree(kSpeed), options_, sink_));
  EXPECT_EQ(first_kind(), "compiler-failed");
  EXPECT_EQ(sink_.items()[0].label, "cannot find the parts of me");
}

TEST_F(NativeModuleTest, SaysWhenTheCacheCannotBeWritten) {
  std::ofstream(folder_ / "file") << "x";
  options_.cache_folder = (folder_ / "file" / "cache").string();
  EXPECT_FALSE(compile_native(tree(kSpeed), options_, sink_));
  EXPECT_EQ(first_kind(), "cannot-write");
}

TEST_F(NativeModuleTest, AFileWithoutProceduresNeedsNoCompiler) {
  options_.compiler = "no-such-compiler";
  const Tree network = tree("external procedure int A with pend\nnode a is A with nend\n");
  EXPECT_FALSE(has_procedures(network));
  EXPECT_TRUE(check_native(network, options_, sink_));
  EXPECT_TRUE(compile_native(network, options_, sink_));
}

}  // namespace
}  // namespace mlab::cnl
