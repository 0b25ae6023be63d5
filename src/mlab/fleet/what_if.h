#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "mlab/fleet/failsafes.h"
#include "mlab/geom/pose.h"

namespace mlab::fleet {

/// What somebody wants to know of a robot's failsafes: what if this were so? All of it begins at the same
/// moment, while the robot drives ahead and its program wants to go on like that.
struct WhatIf {
  /// By condition, of those that have an AFTER: for so long it is so [s]; 0: it isn't.
  using Lasting = std::array<double, mission::kFailsafeConditions.size()>;
  Lasting lasting{};
  double speed = 1.0;  ///< with which it drives, as far as its body can, and wants to go on [m/s], >= 0
  /// It is near to a fence; else it is where it is.
  struct AtFence {
    std::size_t row = 0;        ///< of the table; OUTSIDE
    double depth = 0.0;         ///< of its middle: how far inside the line, beyond it less than 0 [m]
    double bearing = 0.0;       ///< its heading, counter-clockwise from straight out [rad]
    bool begins_there = false;  ///< it is started there; else it has come there
  };
  std::optional<AtFence> fence = std::nullopt;

  double lasts(mission::FailsafeCondition condition) const {
    return lasting[static_cast<std::size_t>(condition)];
  }

  static constexpr double kMostSeconds = 600.0;                   ///< of each condition
  static constexpr double kMostSpeed = 50.0;                      ///< [m/s]
  static constexpr double kMostDepth = 1000.0;                    ///< to either side [m]
  static constexpr double kMostBearing = 2.0 * std::numbers::pi;  ///< to either side [rad]
  static constexpr double kMostSettling = 60.0;  ///< so long it is watched afterwards, and to a fence [s]
  static constexpr std::size_t kMostCycles = 20'000;
};

/// Something that happens to a row.
struct WhatIfEvent {
  enum class What : std::uint8_t {
    kMet,       ///< its condition has held for long enough
    kNotMet,    ///< and does not hold any longer
    kActs,      ///< what it says is done from now on
    kGivesWay,  ///< to one of higher rank
    kIsOver,    ///< what it says is no longer done
    kLetsIn,    ///< the robot began outside of its fence
  };
  double time = 0.0;  ///< since the conditions began [s]
  std::size_t row = 0;
  What what = What::kMet;

  friend bool operator==(const WhatIfEvent&, const WhatIfEvent&) = default;
};

/// What would come of it, on ground on which nothing is in the way.
struct WhatIfOutcome {
  std::vector<WhatIfEvent> events;  ///< in the order of time; the first kMostEvents
  std::vector<RowStanding> rows;    ///< at the end
  std::vector<double> most_used;  ///< by row: of what it takes, the most that was used up at any time, 0 .. 1
  double seconds = 0.0;           ///< so long it was watched
  bool is_cut = false;            ///< it would have gone on, but that would have been too much work
  geom::Pose from;
  geom::Pose to;                ///< at the end
  double speed = 0.0;           ///< at the end [m/s]
  std::optional<double> stood;  ///< since then it stands, until the end [s]
  bool has_stopped = false;     ///< its program has ended, by STOP
  /// With a fence: the least distance between body and line on the way, and the last one; beyond it less than
  /// 0 [m].
  double least_room = 0.0;
  double last_room = 0.0;

  static constexpr std::size_t kMostEvents = 100;
};

/// Tries the failsafes of a robot, by the code that guards it in a run, cycle for cycle. Nothing but the
/// outcome comes of it.
///
/// @param robot  what is known of it; its pose counts where there is no fence, and tells which side of one
/// @param dt     of a cycle [s], > 0
/// @errors  a sentence that says what is expected
std::expected<WhatIfOutcome, std::string> what_if(const Failsafes& failsafes, const Situation& robot,
                                                  const WhatIf& conditions, double dt);

}  // namespace mlab::fleet
