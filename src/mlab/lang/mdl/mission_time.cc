#include "mlab/lang/mdl/mission_time.h"

#include <charconv>
#include <chrono>
#include <string>
#include <string_view>
#include <utility>
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
    const std::string field(text.substr(0, end));
    if (std::from_chars(field.data(), field.data() + field.size(), value).ec != std::errc{}) value = -1;
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

constexpr const char* kMinutes = "minutes and seconds go from 00 to 59";

TimeReading read_timeout(const Mark& time) {
  const std::vector<int> parts = fields(digits(time), ':');
  const double largest_unit = parts.size() == 3 ? 3600.0 : parts.size() == 2 ? 60.0 : 1.0;
  const std::optional<double> seconds = seconds_of(parts, largest_unit);
  return seconds ? good(Kind::kSinceReached, *seconds) : bad(kMinutes, time.span);
}

TimeReading read_relative(const Mark& time) {
  const std::vector<int> parts = fields(digits(time), ':');
  const std::optional<double> seconds = seconds_of(parts, parts.size() == 1 ? 60.0 : 3600.0);
  return seconds ? good(Kind::kSinceStart, *seconds) : bad(kMinutes, time.span);
}

TimeReading read_time_of_day(const Mark& time) {
  const std::vector<int> clock = fields(digits(time), ':');
  const std::optional<double> seconds = seconds_of(clock, 3600.0);
  if (!seconds || clock[0] > 23) return bad("a time of day goes from 00:00 to 23:59:59", time.span);
  return good(Kind::kOfDay, *seconds);
}

TimeReading on_date(TimeReading of_day, const Mark& date) {
  const std::vector<int> parts = fields(date.text, '-');
  const std::chrono::year_month_day day(std::chrono::year(2000 + parts[2]),
                                        std::chrono::month(static_cast<unsigned>(parts[0])),
                                        std::chrono::day(static_cast<unsigned>(parts[1])));
  if (!day.ok()) return bad("a date is written month-day-year, and the month must have that day", date.span);
  const auto days = std::chrono::sys_days(day).time_since_epoch();
  if (of_day.time) {
    of_day.time->kind = Kind::kAbsolute;
    of_day.time->seconds += static_cast<double>(days.count()) * 86400.0;
  }
  return of_day;
}

TimeReading read_number(const Number& number, bool is_timeout) {
  if (is_timeout && number.value < 0.0) return bad("a time-out is not negative", number.span);
  if (is_timeout) return good(Kind::kSinceReached, number.value);
  return number.value < 0.0 ? good(Kind::kSinceReached, -number.value)
                            : good(Kind::kOfDay, number.value * 60.0);
}

}  // namespace

TimeReading read_moment(const Moment& moment) {
  if (moment.number) return read_number(*moment.number, moment.is_timeout);
  if (!moment.time) return bad("a time is missing", moment.span);
  if (moment.is_timeout) return read_timeout(*moment.time);
  if (is_relative(*moment.time)) {
    if (moment.date) return bad("a date needs a time of day, not a time from the start", moment.time->span);
    return read_relative(*moment.time);
  }
  TimeReading of_day = read_time_of_day(*moment.time);
  return moment.date ? on_date(std::move(of_day), *moment.date) : of_day;
}

}  // namespace mlab::mdl
