#include "mlab/cli/clock.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>

#include <fmt/core.h>

namespace mlab::cli {

MissionClock wall_clock() {
  return wall_clock(static_cast<double>(std::time(nullptr)));
}

MissionClock wall_clock(double epoch_seconds) {
  const auto whole = static_cast<std::time_t>(std::floor(epoch_seconds));
  std::tm local{};
  localtime_r(&whole, &local);
  return {epoch_seconds, static_cast<double>(local.tm_gmtoff)};
}

std::optional<MissionClock> parse_start_time(const std::string& text) {
  int year = 0;
  int month = 0;
  int day = 0;
  int hour = 0;
  int minute = 0;
  int second = 0;
  char separator = 0;
  int used = 0;
  const auto is_whole = [&] { return static_cast<std::size_t>(used) == text.size(); };
  const char* const s = text.c_str();
  if (std::sscanf(s, "%4d-%2d-%2d%c%2d:%2d:%2d%n", &year, &month, &day, &separator, &hour, &minute, &second,
                  &used) < 7 ||
      !is_whole()) {
    second = 0;
    if (std::sscanf(s, "%4d-%2d-%2d%c%2d:%2d%n", &year, &month, &day, &separator, &hour, &minute, &used) <
            6 ||
        !is_whole())
      return std::nullopt;
  }
  const std::chrono::year_month_day date{std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(day))};
  const bool is_time = hour >= 0 && hour < 24 && minute >= 0 && minute < 60 && second >= 0 && second < 60;
  if (!date.ok() || !is_time || (separator != ' ' && separator != 'T')) return std::nullopt;
  const auto days = std::chrono::sys_days(date).time_since_epoch();
  return MissionClock{static_cast<double>(days.count()) * 86400.0 + hour * 3600.0 + minute * 60.0 + second,
                      0.0};
}

std::string print(const MissionClock& clock) {
  const auto seconds = static_cast<std::time_t>(std::floor(clock.epoch_seconds + clock.zone_offset));
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}", parts.tm_year + 1900, parts.tm_mon + 1,
                     parts.tm_mday, parts.tm_hour, parts.tm_min, parts.tm_sec);
}

double cpu_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec) * 1e-9;
}

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace mlab::cli
