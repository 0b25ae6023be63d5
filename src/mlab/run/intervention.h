#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "mlab/base/id.h"

namespace mlab::run {

/// What a person made a robot, or its program, do.
struct InterventionRecord {
  enum class Kind : std::uint8_t { kForce, kHold, kRelease, kReplace };
  std::uint64_t cycle = 0;  ///< that had run; it counts from the next one on
  base::RobotId robot;
  Kind kind = Kind::kForce;
  std::string path;   ///< of the sequence, or of the port; empty: all that were held
  std::string value;  ///< the state, or at what it is held
};
std::string_view name(InterventionRecord::Kind kind);

}  // namespace mlab::run
