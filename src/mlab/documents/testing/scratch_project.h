#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <unistd.h>

#include <gtest/gtest.h>

namespace mlab::documents::testing {

/// A project, examples and a state folder in a folder of their own, which goes with this.
class ScratchProject {
 public:
  ScratchProject() {
    static int count = 0;
    root_ = std::filesystem::temp_directory_path() /
            ("mlab_scratch_" + std::to_string(::getpid()) + "_" + std::to_string(++count));
    std::filesystem::remove_all(root_);
    for (const char* folder : {"project", "examples", "state", "elsewhere"})
      std::filesystem::create_directories(root_ / folder);
  }
  ~ScratchProject() {
    std::error_code gone;
    std::filesystem::remove_all(root_, gone);
  }
  ScratchProject(const ScratchProject&) = delete;
  ScratchProject& operator=(const ScratchProject&) = delete;

  /// `project/a.mdl` below the folder.
  std::filesystem::path path(const std::string& name) const { return root_ / name; }
  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(path(name).parent_path());
    std::ofstream(path(name), std::ios::binary) << text;
  }
  std::string read(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

 private:
  std::filesystem::path root_;
};

}  // namespace mlab::documents::testing
