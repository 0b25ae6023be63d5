#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/base/table.h"
#include "mlab/geom/pose.h"
#include "mlab/text/source.h"

namespace mlab::mission {

/// What a failsafe looks for, below all that a robot's program says.
enum class FailsafeCondition : std::uint8_t {
  kOutside,
  kInContact,
  kStuck,
  kLinkLost,
  kPerceptsStale,
  kOperatorAbsent,
  kBattery,
};
/// What becomes of the robot then.
enum class FailsafeAction : std::uint8_t { kHold, kStop, kReturn, kContinue, kReverseInside };

/// When a condition is looked at: it can't come true otherwise.
enum class FailsafeWatch : std::uint8_t { kRunning, kRealTime, kTeleoperated, kVehicle };

/// All that is to be known of a condition. Parser, printer, checks, completion and the documentation take it
/// from here.
struct FailsafeConditionInfo {
  FailsafeCondition condition;
  std::string_view word;         ///< `LINK-LOST`
  bool has_fence = false;        ///< a closed line of the overlay stands behind it
  bool has_share = false;        ///< `BELOW 30%` stands behind it
  bool may_last = false;         ///< AFTER says for how long it has to hold
  double default_seconds = 0.0;  ///< without AFTER [s]
  FailsafeWatch watch = FailsafeWatch::kRunning;
  std::string_view help;  ///< what editors say of the word, and the documentation
};
inline constexpr std::array kFailsafeConditions = {
    FailsafeConditionInfo{.condition = FailsafeCondition::kOutside,
                          .word = "OUTSIDE",
                          .has_fence = true,
                          .help = "the robot is about to leave the area within a closed BOUNDARY, or is "
                                  "outside of it. Whatever the action, it stops before the line from any "
                                  "speed, and beyond it only drives back"},
    FailsafeConditionInfo{.condition = FailsafeCondition::kInContact,
                          .word = "IN-CONTACT",
                          .may_last = true,
                          .help = "its body touches something solid or another body"},
    FailsafeConditionInfo{.condition = FailsafeCondition::kStuck,
                          .word = "STUCK",
                          .may_last = true,
                          .default_seconds = 30.0,
                          .help = "it wants to drive, and has come no half metre further"},
    FailsafeConditionInfo{.condition = FailsafeCondition::kLinkLost,
                          .word = "LINK-LOST",
                          .may_last = true,
                          .default_seconds = 5.0,
                          .watch = FailsafeWatch::kRealTime,
                          .help = "with --real-time: nothing is heard of the program that a machine of the "
                                  "fleet computes for it. It stands after half a second in any case"},
    FailsafeConditionInfo{.condition = FailsafeCondition::kPerceptsStale,
                          .word = "PERCEPTS-STALE",
                          .may_last = true,
                          .default_seconds = 1.0,
                          .watch = FailsafeWatch::kRealTime,
                          .help = "with --real-time: what it does answers percepts that are so old, because "
                                  "they or its answers are long on their way, or don't arrive; of a vehicle "
                                  "also: it has not said for so long where it is. Its program acts on none "
                                  "that came more than half a second ago in any case"},
    FailsafeConditionInfo{.condition = FailsafeCondition::kOperatorAbsent,
                          .word = "OPERATOR-ABSENT",
                          .may_last = true,
                          .default_seconds = 10.0,
                          .watch = FailsafeWatch::kTeleoperated,
                          .help = "under teleoperation: nobody holds the stick, because he let go of it, his "
                                  "console is gone, or nothing comes from there. The stick counts as let go "
                                  "half a second after its last message in any case"},
    FailsafeConditionInfo{.condition = FailsafeCondition::kBattery,
                          .word = "BATTERY",
                          .has_share = true,
                          .may_last = true,
                          .default_seconds = 5.0,
                          .watch = FailsafeWatch::kVehicle,
                          .help =
                              "of a vehicle: less than this share of its battery is left, as it says. Where "
                              "it has not said so for 10 s, or never, that counts as too little. A robot "
                              "whose body is simulated has no battery, and this never holds"},
};
static_assert(base::has_a_row_for_each<kFailsafeConditions, &FailsafeConditionInfo::condition>());

struct FailsafeActionInfo {
  FailsafeAction action;
  std::string_view word;     ///< `REVERSE INSIDE`
  bool needs_fence = false;  ///< nothing but OUTSIDE can have it
  std::string_view help;     ///< as above
};
inline constexpr std::array kFailsafeActions = {
    FailsafeActionInfo{FailsafeAction::kHold, "HOLD", false,
                       "it stands until it is given another order, is steered, or what was wrong is over"},
    FailsafeActionInfo{FailsafeAction::kStop, "STOP", false,
                       "its program ends, as by the mission's STOP; only START begins it again"},
    FailsafeActionInfo{
        FailsafeAction::kReturn, "RETURN", false,
        "it drives to where it was started, straight, and stands there until it is given another "
        "order or is steered"},
    FailsafeActionInfo{FailsafeAction::kContinue, "CONTINUE", false,
                       "it goes on, and the log says what is wrong"},
    FailsafeActionInfo{FailsafeAction::kReverseInside, "REVERSE INSIDE", true,
                       "it drives back from the line until it is three metres away from it, and stands there "
                       "until it is given another order or is steered"},
};
static_assert(base::has_a_row_for_each<kFailsafeActions, &FailsafeActionInfo::action>());

constexpr const FailsafeConditionInfo& info(FailsafeCondition condition) {
  return kFailsafeConditions[static_cast<std::size_t>(condition)];
}
constexpr const FailsafeActionInfo& info(FailsafeAction action) {
  return kFailsafeActions[static_cast<std::size_t>(action)];
}

/// So many rows, at most: each robot is held against each of them in each cycle.
inline constexpr std::size_t kMostFailsafes = 16;

/// A row of a mission's table of failsafes; those before it have the higher rank.
struct Failsafe {
  FailsafeCondition condition = FailsafeCondition::kOutside;
  FailsafeAction action = FailsafeAction::kHold;
  std::string type_name;           ///< whose it is, as written; empty: of all robots
  std::vector<std::string> types;  ///< the same, by the names of robot types: a society has several
  double seconds = 0.0;            ///< for how long the condition has to hold [s]
  double share = 0.0;              ///< BATTERY: below which it holds, of what it takes when full, 0 .. 1
  std::string fence_name;          ///< OUTSIDE: as written
  std::vector<geom::Point> fence;  ///< OUTSIDE: its corners, closed by itself, at least three [m, world]
  text::Place place;               ///< of its first word

  /// They do the same, wherever they stand.
  bool is_same(const Failsafe& other) const {
    return condition == other.condition && action == other.action && seconds == other.seconds &&
           share == other.share && fence == other.fence && types == other.types;
  }
  bool is_of(std::string_view type) const {
    return types.empty() || std::ranges::find(types, type) != types.end();
  }
};

/// As the language writes it: `FAILSAFE LINK-LOST AFTER 5 RETURN`.
std::string words_of(const Failsafe& failsafe);

}  // namespace mlab::mission
