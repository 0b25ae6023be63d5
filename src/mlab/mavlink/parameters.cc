#include "mlab/mavlink/parameters.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace mlab::mavlink {
namespace {

using std::chrono::milliseconds;

// Of the time from the last command to where it stands: how long that is repeated and is on its way, and how
// long it brakes once it has let go of the last set-point [s].
constexpr double kRepeating = 0.5;
constexpr double kBraking = 0.5;
// Slow radios carry a few questions a second beside all else.
constexpr milliseconds kBetweenQuestions{100};
constexpr milliseconds kAnswersWithin{500};
constexpr milliseconds kWrittenWithin{1000};
constexpr milliseconds kKnownFor{30000};

std::string range_of(const Wanted& wanted) {
  return wanted.low == wanted.high ? fmt::format("{}", wanted.low)
                                   : fmt::format("{} to {}", wanted.low, wanted.high);
}

}  // namespace

Parameters::Parameters(std::uint8_t self, double standstill) {
  const double guided = std::max(standstill - kRepeating - kBraking, 0.1);
  for (const Wanted& one : std::initializer_list<Wanted>{
           {"FS_GCS_ENABLE", "", 1, 2, true, "it has to act by itself when it hears us no more"},
           {"FS_ACTION", "", 2, 2, true, "its failsafes have to let it stand (2, HOLD), not drive somewhere"},
           {"FS_TIMEOUT", "", 1, 5, true, "it must not wait for us any longer"},
           {"SYSID_MYGCS", "MAV_GCS_SYSID", static_cast<double>(self), static_cast<double>(self), true,
            "it has to count our heartbeats, not somebody else's"},
           {"GUID_TIMEOUT", "", 0.1, guided, true, "it has to stand so soon after the last set-point"},
           {"FS_EKF_ACTION", "", 1, 1, true, "it has to stand when it does not know where it is"},
           {"FS_CRASH_CHECK", "", 1, 2, false, "it should not push on where it is stuck"}})
    rows_.push_back({one, {}, false, {}, {}});
}

void Parameters::take(const ParamValue& message, Time /*now*/) {
  const std::string_view name = text_of(message.param_id);
  if (!std::isfinite(message.param_value) || name.empty()) return;
  for (Row& row : rows_) {
    if (name != row.wanted.name && name != row.wanted.other_name) continue;
    row.is_other_name = name != row.wanted.name;
    // Its number has seven digits, and ours of a limit more.
    row.value = std::round(static_cast<double>(message.param_value) * 1e4) / 1e4;
  }
}

void Parameters::begin_anew() {
  for (Row& row : rows_) {
    row.value.reset();
    row.asked_at.reset();
    row.written_at.reset();
  }
}

std::optional<std::string_view> Parameters::to_ask(Time now) {
  if (asked_at_ && now - *asked_at_ < kBetweenQuestions) return std::nullopt;
  Row* next = nullptr;  // of those that are due the one that waits the longest
  for (Row& row : rows_) {
    if (row.asked_at && now - *row.asked_at < (row.value ? kKnownFor : kAnswersWithin)) continue;
    if (next == nullptr || row.asked_at < next->asked_at) next = &row;
  }
  if (next == nullptr) return std::nullopt;
  // Which of two names it has is found by asking for both in turns.
  if (!next->value && next->asked_at && !next->wanted.other_name.empty())
    next->is_other_name = !next->is_other_name;
  next->asked_at = asked_at_ = now;
  return next->name();
}

std::optional<Parameters::Write> Parameters::to_write(Time now) {
  for (Row& row : rows_) {
    const bool is_wrong = row.wanted.is_needed && row.value && !row.is_right();
    if (!is_wrong || (row.written_at && now - *row.written_at < kWrittenWithin)) continue;
    row.written_at = now;
    return Write{row.name(), std::clamp(*row.value, row.wanted.low, row.wanted.high)};
  }
  return std::nullopt;
}

std::vector<ParameterCheck> Parameters::checks() const {
  std::vector<ParameterCheck> out;
  for (const Row& row : rows_) {
    out.push_back({std::string(row.name()), row.value, range_of(row.wanted), std::string(row.wanted.why),
                   row.wanted.is_needed, row.is_right()});
  }
  return out;
}

std::string Parameters::problem() const {
  for (const Row& row : rows_) {
    if (!row.wanted.is_needed || row.is_right()) continue;
    if (!row.value) return fmt::format("has not told its parameter {} yet", row.name());
    return fmt::format(
        "has {} at {}, and {}: set it to {} with a ground station (QGroundControl, `param set {} {}`)",
        row.name(), *row.value, row.wanted.why, range_of(row.wanted), row.name(),
        std::clamp(*row.value, row.wanted.low, row.wanted.high));
  }
  return {};
}

}  // namespace mlab::mavlink
