#pragma once

#include <cstdint>
#include <span>

#include "mlab/mission/mission.h"
#include "mlab/text/diagnostic.h"

namespace mlab::mdl {

/// Warns of robots that are started outside of a fence of theirs: they would only drive back. The work is
/// bounded.
class FenceCheck {
 public:
  FenceCheck(const mission::Mission& mission, text::Diagnostics& diagnostics)
      : mission_(mission), diagnostics_(diagnostics) {}

  /// @param start   a START
  /// @param robots  that it starts, in their order; all of them robots of the mission
  void check(const mission::UnitCommand& start, std::span<const mission::Robot* const> robots);

 private:
  void check(const mission::UnitCommand& start, std::span<const mission::Robot* const> robots,
             const mission::Failsafe& failsafe);

  const mission::Mission& mission_;
  text::Diagnostics& diagnostics_;
  std::uint64_t visits_ = 0;
};

}  // namespace mlab::mdl
