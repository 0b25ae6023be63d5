#include "mlab/mavlink/firmware.h"

#include <algorithm>
#include <chrono>
#include <string_view>

#include <fmt/format.h>

#include "mlab/mavlink/ardupilot.h"
#include "mlab/text/shown.h"

namespace mlab::mavlink {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kFirstQuestions{1000};  // between two of them
constexpr milliseconds kLaterQuestions{10000};
// After so many without an answer it is said that it does not tell; each may get lost.
constexpr int kEnoughQuestions = 5;

// FIRMWARE_VERSION_TYPE; what is between two of them belongs to the lower.
std::string_view kind_of(std::uint32_t number) {
  if (number == 255) return "";
  if (number >= 192) return "-rc";
  if (number >= 128) return "-beta";
  return number >= 64 ? "-alpha" : "-dev";
}

}  // namespace

std::string version_text(std::uint32_t version) {
  return fmt::format("{}.{}.{}{}", version >> 24U, version >> 16U & 0xffU, version >> 8U & 0xffU,
                     kind_of(version & 0xffU));
}

bool Firmware::is_to_be_asked(Time now) {
  const bool is_new = asked_ < kEnoughQuestions && !does_not_tell_;
  if (told_ || (asked_at_ && now - *asked_at_ < (is_new ? kFirstQuestions : kLaterQuestions))) return false;
  asked_at_ = now;
  ++asked_;
  return true;
}

void Firmware::take(const AutopilotVersion& message) {
  told_ = message;
}

void Firmware::take(const CommandAck& message) {
  const auto result = static_cast<Result>(message.result);
  if (message.command == kRequestMessage && asked_ > 0)
    does_not_tell_ = result == Result::kDenied || result == Result::kUnsupported || result == Result::kFailed;
}

vehicle::Check Firmware::check() const {
  using enum vehicle::CheckResult;
  const bool is_patient = asked_ < kEnoughQuestions && !does_not_tell_;
  if (!told_)
    return {"firmware", kUnknown, is_patient ? "has not told its version yet" : "does not tell its version",
            ""};
  const std::string revision = text::shown(text_of(told_->flight_custom_version), 8);
  return {"firmware", kPass,
          fmt::format("is ArduPilot {}{}", version_text(told_->flight_sw_version),
                      revision.empty() ? "" : fmt::format(", revision {}", revision)),
          ""};
}

}  // namespace mlab::mavlink
