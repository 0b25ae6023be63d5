#pragma once

#include <string>

#include <fmt/format.h>

namespace mlab::text {

/// A length of time for people: `14 s`, `3 min`, `5 h`.
inline std::string age(double seconds) {
  if (seconds < 120.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 7200.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.0f} h", seconds / 3600.0);
}

}  // namespace mlab::text
