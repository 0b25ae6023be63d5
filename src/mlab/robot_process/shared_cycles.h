#pragma once

#include <cstddef>
#include <expected>
#include <string>

#include "mlab/flow/program.h"
#include "mlab/robot_wire/shared_cycle.h"

namespace mlab::robot_process {

/// The two files that a program shares with its run, as the program sees them.
class SharedFiles {
 public:
  /// @errors  a sentence: the descriptors are not there, or too small
  static std::expected<SharedFiles, std::string> open(int frames, int percepts);

  SharedFiles(SharedFiles&& other) noexcept;
  SharedFiles& operator=(SharedFiles&&) = delete;
  SharedFiles(const SharedFiles&) = delete;
  SharedFiles& operator=(const SharedFiles&) = delete;
  ~SharedFiles();

  /// Stays where it is, however the files grow.
  robot_wire::Control& control() { return *control_; }
  std::byte* place(std::size_t index, std::size_t size) {
    return frames_ + robot_wire::kFirstPlace + index * size;
  }
  const std::byte* percepts(std::size_t offset) const { return percepts_ + offset; }

  /// Sees the files as long as the run has made them. False: they can't be seen.
  bool grow();

 private:
  SharedFiles() = default;

  robot_wire::Control* control_ = nullptr;
  std::byte* frames_ = nullptr;
  std::size_t frames_size_ = 0;
  std::byte* percepts_ = nullptr;
  std::size_t percepts_size_ = 0;
};

/// Computes every cycle that the run asks for, until its standard input ends.
/// @return  the process's exit status
int serve_shared(SharedFiles& files, const flow::Program& program, int in);

}  // namespace mlab::robot_process
