#include "mlab/lang/mdl/mission_time.h"

#include <charconv>
#include <chrono>
#include <string_view>
#include <vector>

#include <fmt/core.h>

namespace mlab::mdl {
namespace {

using Kind = mission::MissionTime::Kind;

// The numbers between the separators. The lexer lets only digits and separators through.
std::vector<int> fields(std::string_view text, char separator) {
  std::vector<int> out;
  while (true) {
    const std::size_t end = std::min(text.find(separator), text.size());
    int value = 0;
    if (std::from_chars(text.data(), text.data() + end, value).ec != std::errc{}) value = -1;
    out.push_back(value);
    if (end == text.size()) return out;
    text.remove_prefix(end + 1);
  }
}

TimeReading good(Kind kind, double seconds) {
  return {mission::MissionTime{kind, seconds}, {}, {}};
}
TimeReading bad(std::string problem, text::Span span) {
  return {std::nullopt, std::move(problem), span};
}

bool is_relative(const Mark& time) {
  return time.text.starts_with('+');
}
std::string_view digits(const Mark& time) {
  return std::string_view(time.text).substr(is_relative(time) ? 1 : 0);
}

// `parts` from the largest unit to the smallest, each but the first below 60.
std::optional<double> seconds_of(const std::vector<int>& parts, double largest_unit) {
  double seconds = 0.0;
  double unit = largest_unit;
  for (std::size_t i = 0; i < parts.size(); ++i, unit /= 60.0) {
    if (parts[i] < 0 || (i > 0 && parts[i] > 59)) return std::nullopt;
    seconds += parts[i] * unit;
  }
  return seconds;
}

TimeReading read_timeout(const Moment& moment) {
  if (moment.number) {
    if (moment.number->value < 0.0) return bad("a time-out is not negative", moment.number->span);
    return good(Kind::kSinceReached, moment.number->value);
  }
  const std::vector<int> parts = fields(digits(*moment.time), ':');
  const double largest_unit = parts.size() == 3 ? 3600.0 : parts.size() == 2 ? 60.0 : 1.0;
  const std::optional<double> seconds = seconds_of(parts, largest_unit);
  if (!seconds) return bad("minutes and seconds go from 00 to 59", moment.time->span);
  return good(Kind::kSinceReached, *seconds);
}

TimeReading read_relative(const Moment& moment) {
  if (moment.date) return bad("a date needs a time of day, not a time from the start", moment.time->span);
  const std::vector<int> parts = fields(digits(*moment.time), ':');
  const std::optional<double> seconds = seconds_of(parts, parts.size() == 1 ? 60.0 : 3600.0);
  if (!seconds) return bad("minutes and seconds go from 00 to 59", moment.time->span);
  return good(Kind::kSinceStart, *seconds);
}

TimeReading read_clock(const Moment& moment) {
  const std::vector<int> clock = fields(digits(*moment.time), ':');
  const std::optional<double> seconds = seconds_of(clock, 3600.0);
  if (!seconds || clock[0] > 23) return bad("a time of day goes from 00:00 to 23:59:59", moment.time->span);
  if (!moment.date) return good(Kind::kOfDay, *seconds);
  const std::vector<int> date = fields(moment.date->text, '-');
  const std::chrono::year_month_day day(std::chrono::year(2000 + date[2]),
                                        std::chrono::month(static_cast<unsigned>(date[0])),
                                        std::chrono::day(static_cast<unsigned>(date[1])));
  if (!day.ok())
    return bad("a date is written month-day-year, and the month must have that day", moment.date->span);
  const auto days = std::chrono::sys_days(day).time_since_epoch();
  return good(Kind::kAbsolute, static_cast<double>(days.count()) * 86400.0 + *seconds);
}

}  // namespace

TimeReading read_moment(const Moment& moment) {
  if (moment.is_timeout) return read_timeout(moment);
  if (moment.number) {
    const double value = moment.number->value;
    return value < 0.0 ? good(Kind::kSinceReached, -value) : good(Kind::kOfDay, value * 60.0);
  }
  return is_relative(*moment.time) ? read_relative(moment) : read_clock(moment);
}

}  // namespace mlab::mdl
