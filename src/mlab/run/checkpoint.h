#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "mlab/binding/binding.h"
#include "mlab/fleet/fleet_state.h"
#include "mlab/run/run_state.h"

namespace mlab::run {

/// A run between two cycles, from where it can go on. Cheap to copy, never changed, and any thread may hold
/// it; missions and programs live as long as it does.
class Checkpoint {
 public:
  std::uint64_t cycle() const { return all_->run.cycle; }
  double time() const { return all_->run.time(); }  ///< [s]
  /// That it takes up, about; without what it shares with others.
  std::size_t bytes() const { return bytes_; }

 private:
  friend class MissionRun;
  /// In this order: robots' memories point into crews.
  struct All {
    RunState run;
    fleet::FleetCheckpoint fleet;
    std::shared_ptr<const binding::Binding::Kept> bodies;
    std::uint64_t seed = 0;
  };
  explicit Checkpoint(std::shared_ptr<const All> all);

  std::shared_ptr<const All> all_;
  std::size_t bytes_ = 0;
};

}  // namespace mlab::run
