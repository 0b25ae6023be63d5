#pragma once

#include <cstddef>
#include <expected>
#include <string>

#include "mlab/flow/program.h"
#include "mlab/robot/wire/mapping.h"
#include "mlab/robot/wire/shared_cycle.h"

namespace mlab::robot_process {

/// The two files that a program shares with its run, as the program sees them.
class SharedFiles {
 public:
  /// @errors  a sentence: the descriptors are not there, or too small
  static std::expected<SharedFiles, std::string> open(int frames, int percepts);

  /// Stays where it is, however the files grow.
  robot_wire::Control& control() { return *reinterpret_cast<robot_wire::Control*>(control_.begin()); }
  std::byte* place(std::size_t index, std::size_t size) {
    return frames_.begin() + robot_wire::kFirstPlace + index * size;
  }
  const std::byte* percepts(std::size_t offset) const { return percepts_.begin() + offset; }

  /// Sees the files as long as the run has made them. False: they can't be seen.
  bool grow();

 private:
  SharedFiles() = default;

  robot_wire::Mapping control_;
  robot_wire::Mapping frames_;
  robot_wire::Mapping percepts_;
};

/// Computes every cycle that the run asks for, until its standard input ends.
/// @return  the process's exit status
int serve_shared(SharedFiles& files, const flow::Program& program, int in);

}  // namespace mlab::robot_process
