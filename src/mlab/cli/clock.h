#pragma once

#include <optional>
#include <string>

namespace mlab::cli {

/// Where the mission's clock stands when the run starts.
struct MissionClock {
  double epoch_seconds = 0.0;  ///< since 1970-01-01 00:00 UTC
  double zone_offset = 0.0;    ///< of the time zone in which times of day are meant, east of UTC [s]
};

/// The wall clock, in the machine's time zone.
MissionClock wall_clock();
/// What it showed, or will show, at a time.
/// @param epoch_seconds  of the years up to 9999
MissionClock wall_clock(double epoch_seconds);
/// `2026-03-01 08:30`, `2026-03-01T08:30:15`; in no particular time zone (offset 0). Nothing where the text
/// is no time.
std::optional<MissionClock> parse_start_time(const std::string& text);
/// `2026-03-01T08:30:15` in the clock's own zone.
std::string print(const MissionClock& clock);

/// Seconds of processor time that this process has used.
double cpu_seconds();
/// Seconds of a clock that never jumps.
double steady_seconds();

}  // namespace mlab::cli
