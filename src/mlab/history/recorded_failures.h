#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "mlab/fleet/fleet.h"
#include "mlab/history/history.h"

namespace mlab::history {

/// Has programs fail where they failed in a run that was recorded. Keeps nothing of a moment.
class RecordedFailures final : public fleet::KnownFailures {
 public:
  /// @param history  may grow
  /// @param cycle    how many have run, the one that is being computed included
  RecordedFailures(std::shared_ptr<const History> history, std::function<std::uint64_t()> cycle)
      : history_(std::move(history)), cycle_(std::move(cycle)) {}

  const std::string* at_start(base::RobotId robot, std::uint32_t start) const override {
    return history_->why_not_started(cycle_(), robot.value, start);
  }
  bool are_any() const override {
    const std::uint64_t cycle = cycle_();
    const auto at = history_->failed().lower_bound({cycle, 0, 0});
    return at != history_->failed().end() && at->first.cycle == cycle;
  }
  const std::string* in_cycle(base::RobotId robot) const override {
    return history_->why_failed(cycle_(), robot.value);
  }

 private:
  std::shared_ptr<const History> history_;
  std::function<std::uint64_t()> cycle_;
};

}  // namespace mlab::history
