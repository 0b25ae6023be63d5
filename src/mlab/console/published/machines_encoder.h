#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "mlab/console.pb.h"
#include "mlab/console/machine_watch.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// Who is in the fleet of the run's robots, looked at once a second.
class MachineBoard {
 public:
  /// @param watch  null: the robots are no fleet's
  explicit MachineBoard(std::shared_ptr<MachineWatch> watch) : watch_(std::move(watch)) {}

  bool is_there() const { return watch_ != nullptr; }
  /// @param wall  the time [s]
  /// @param run   whose robots are looked for on the machines; null: there is none
  /// @return  another number where something is to be told
  std::uint64_t look(double wall, const run::MissionRun* run);
  /// As it was looked at last.
  const Machines& told() const { return told_; }

 private:
  std::shared_ptr<MachineWatch> watch_;
  double looked_ = -1e9;  // [s]
  std::uint64_t revision_ = 0;
  Machines told_;
  std::string told_bytes_;
};

}  // namespace mlab::console
