#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "mlab/robot/program/program_runner.h"

namespace mlab::robot {

/// Everywhere that programs of a run can run. Which place a program needs is decided here, and nowhere else.
class ProgramRunners {
 public:
  /// @param seed       of the run: names the robots' random numbers
  /// @param processes  for each program that needs some, at most, >= 1
  ProgramRunners(std::uint64_t seed, int processes);

  /// Null: nothing here answers to the program's name.
  ProgramRunner* runner_of(const RobotProgram& program) const;

  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }

 private:
  std::array<std::unique_ptr<ProgramRunner>, 3> all_;
};

}  // namespace mlab::robot
