#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "mlab/robot/program/program_runner.h"

namespace mlab::robot {

/// Everywhere that programs of a run can run. Which place a program needs is decided here, and nowhere else.
class ProgramRunners {
 public:
  /// @param seed       of the run: names the robots' random numbers
  /// @param processes  for each program that needs some, at most, >= 1
  /// @param elsewhere  runs all programs that can be built elsewhere; null: they run here
  ProgramRunners(std::uint64_t seed, int processes, std::unique_ptr<ProgramRunner> elsewhere = nullptr);

  /// Null: nothing here answers to the program's name.
  ProgramRunner* runner_of(const RobotProgram& program) const;

  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }

 private:
  std::vector<std::unique_ptr<ProgramRunner>> all_;  // in this process, in cells, executables, elsewhere
};

}  // namespace mlab::robot
