#include "mlab/cell/keep_first.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace mlab::cell {
namespace {

namespace fs = std::filesystem;

class KeepFirst : public ::testing::Test {
 protected:
  KeepFirst() { fs::create_directories(folder_); }
  ~KeepFirst() override { fs::remove_all(folder_); }
  KeepFirst(const KeepFirst&) = delete;
  KeepFirst& operator=(const KeepFirst&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string written(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
    return path(name);
  }
  std::string read(const std::string& name) const {
    std::ostringstream out;
    out << std::ifstream(path(name)).rdbuf();
    return out.str();
  }

 private:
  fs::path folder_ = fs::temp_directory_path() / fmt::format("mlab_keep_first_{}", getpid());
};

TEST_F(KeepFirst, TheFirstOneStays) {
  EXPECT_FALSE(keep_first(written("a", "first"), path("name")));
  EXPECT_FALSE(keep_first(written("b", "second"), path("name")));
  EXPECT_EQ(read("name"), "first");
}

TEST_F(KeepFirst, TellsWhyTheNameCannotBeGiven) {
  EXPECT_EQ(keep_first(written("a", "first"), path("no/such/folder")), std::errc::no_such_file_or_directory);
}

}  // namespace
}  // namespace mlab::cell
