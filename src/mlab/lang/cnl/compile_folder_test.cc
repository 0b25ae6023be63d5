#include "mlab/lang/cnl/compile_folder.h"

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace mlab::cnl {
namespace {

namespace fs = std::filesystem;

// The number of a process that is no more.
pid_t ended_process() {
  const pid_t child = fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  return child;
}

TEST(CompileFolder, IsOfOneCompilationAndRemovesThoseOfProcessesThatAreNoMore) {
  const fs::path folder =
      fs::path(::testing::TempDir()) / ("mlab_compile_folder_" + std::to_string(getpid()));
  const auto make = [&](const std::string& name, bool is_old) {
    fs::create_directories(folder / name);
    std::ofstream(folder / name / "text.cc") << "x";
    if (is_old) fs::last_write_time(folder / name, fs::file_time_type::clock::now() - std::chrono::hours(2));
    return folder / name;
  };
  const std::string gone = std::to_string(ended_process());
  const fs::path left = make("walk-12." + gone + ".0", true);
  const fs::path young = make("walk-13." + gone + ".0", false);
  const fs::path living = make("walk-14." + std::to_string(getppid()) + ".0", true);
  const fs::path unlike = make("walk-15." + gone + ".so", true);
  const fs::path made = make_compile_folder(folder.string(), "walk-12");
  EXPECT_TRUE(fs::is_directory(made));
  EXPECT_NE(made, make_compile_folder(folder.string(), "walk-12"));
  EXPECT_FALSE(fs::exists(left));
  for (const fs::path& kept : {young, living, unlike}) EXPECT_TRUE(fs::exists(kept)) << kept;
  fs::remove_all(folder);
}

}  // namespace
}  // namespace mlab::cnl
