#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"

namespace mlab {

namespace fs = std::filesystem;

inline const std::string kMissions = base::source_folder() + "/missions/";

inline std::string text_of(const fs::path& file) {
  std::ifstream stream(file);
  return (std::ostringstream() << stream.rdbuf()).str();
}

/// How a command ended, and what it printed where.
struct Outcome {
  int status = -1;
  std::string out;
  std::string err;
};

/// The built command, in a folder of its own for each test, which is gone afterwards.
class Command : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              ("mlab_cli_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  // `before` stands before the command: what is piped into it, `timeout`.
  Outcome mlab(const std::string& arguments, const std::string& before = "") const {
    const std::string line = "cd '" + folder_.string() + "' && XDG_CACHE_HOME='" +
                             (folder_ / "cache").string() + "' && export XDG_CACHE_HOME && " + before + " '" +
                             MLAB_COMMAND + "' " + arguments + " > out.txt 2> err.txt" +
                             (before.empty() ? " < /dev/null" : "");
    // NOLINTNEXTLINE(concurrency-mt-unsafe): a test program has one thread
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(folder_ / "out.txt"),
            text_of(folder_ / "err.txt")};
  }

  fs::path folder_;
};

inline bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline constexpr const char* kMap = "SITE Test\nCONTROL MEASURES:\nPP Here 100 100\nPP There 160 100\n";
inline constexpr const char* kMission =
    "MISSION NAME Test\nOVERLAY map.odl\nUNIT <u> ROBOT\nCOMMAND LIST:\n0. UNIT u START Here\n1. UNIT u "
    "MOVETO There\n";

}  // namespace mlab
