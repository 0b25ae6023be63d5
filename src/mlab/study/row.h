#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace mlab::study {

/// What is counted or measured of each run.
enum class Number : std::uint8_t {
  kDuration,
  kStepsDone,
  kDistance,
  kContacts,
  kFormationError,
  kWorstFormationError,
  kOutOfFormation,
  kPathRatio,
  kDeliveries,
  kFailsafes,
  kFaults,
};
struct NumberInfo {
  Number number;
  std::string_view name;  ///< in conditions: `duration`
  std::string_view unit;  ///< empty: none
  std::string_view help;
  bool is_compared;  ///< shown for each combination, and compared in pairs
};
inline constexpr std::array<NumberInfo, 11> kNumbers = {{
    {Number::kDuration, "duration", "s", "simulated time until the end of the run", true},
    {Number::kStepsDone, "steps_done", "", "steps of the mission that are done", false},
    {Number::kDistance, "distance", "m", "driven by all robots together", true},
    {Number::kContacts, "contacts", "", "how often robots met something solid", true},
    {Number::kFormationError, "formation_error", "m",
     "mean distance of robots from their stations, over all robots and cycles with a formation to keep; "
     "empty "
     "where there were none",
     true},
    {Number::kWorstFormationError, "formation_error_max", "m", "the largest such distance", false},
    {Number::kOutOfFormation, "out_of_formation", "",
     "share of these robot-cycles farther away than the robot's `formation_slop`", true},
    {Number::kPathRatio, "path_ratio", "",
     "what robots drove in formation, divided by what it would have been if their unit's centre had gone "
     "straight "
     "from order to order",
     true},
    {Number::kDeliveries, "deliveries", "", "objects that were brought into baskets", false},
    {Number::kFailsafes, "failsafes", "", "how often a failsafe acted or ended", false},
    {Number::kFaults, "faults", "", "robots that stand because of a fault", false},
}};
consteval bool are_in_order() {
  for (std::size_t i = 0; i < kNumbers.size(); ++i) {
    if (static_cast<std::size_t>(kNumbers[i].number) != i) return false;
  }
  return true;
}
static_assert(are_in_order());

/// As tables head it: `duration_s`.
std::string column(const NumberInfo& info);
/// Whether the table has a column of this name, whatever is set.
bool is_table_column(std::string_view name);

/// Which run of a batch.
struct RunKey {
  std::uint32_t version = 0;      ///< 0: the mission, 1: what it is compared with
  std::uint32_t combination = 0;  ///< of listed values
  std::uint32_t run = 0;          ///< from 0 on: the seed is the first one plus this

  friend auto operator<=>(const RunKey&, const RunKey&) = default;
};

/// What is kept of a run.
struct Row {
  RunKey key;
  std::uint64_t seed = 0;
  bool success = false;
  std::string outcome;  ///< as in the report: `done`, `failed`, ...; `not run` where it could not be
  std::string cause;    ///< of a failure, the same for runs that failed alike; else empty
  std::string message;  ///< what was said of it in this run
  std::array<double, kNumbers.size()> numbers{};  ///< not a number: there was nothing to measure

  Row() { numbers.fill(std::numeric_limits<double>::quiet_NaN()); }
  double& operator[](Number number) { return numbers[static_cast<std::size_t>(number)]; }
  double operator[](Number number) const { return numbers[static_cast<std::size_t>(number)]; }
};

}  // namespace mlab::study
