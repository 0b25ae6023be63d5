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
  /// @param recorded   says what programs answered of which no more is known; null: there are none
  ProgramRunners(std::uint64_t seed, int processes, std::unique_ptr<ProgramRunner> elsewhere = nullptr,
                 std::unique_ptr<ProgramRunner> recorded = nullptr);

  /// Null: nothing here answers to the program's name.
  ProgramRunner* runner_of(const RobotProgram& program) const;

  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }

 private:
  std::vector<std::unique_ptr<ProgramRunner>> all_;
  ProgramRunner* in_process_ = nullptr;
  ProgramRunner* hosted_ = nullptr;
  ProgramRunner* executables_ = nullptr;
  ProgramRunner* elsewhere_ = nullptr;  // null: there is none; likewise
  ProgramRunner* recorded_ = nullptr;
};

}  // namespace mlab::robot
