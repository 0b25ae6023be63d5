#pragma once

#include <cstdint>
#include <string>

namespace mlab::vehicle {

/// What came out when something was looked at.
enum class CheckResult : std::uint8_t {
  kPass,
  kWarn,     ///< it can be driven with that, and somebody should know
  kFail,     ///< it should not be driven with that
  kUnknown,  ///< nobody can say
};

/// Something of a vehicle that was looked at before a mission. For people; nothing in it is made up.
struct Check {
  std::string name;  ///< `parameter FS_ACTION`, `watchdog`
  CheckResult result = CheckResult::kUnknown;
  std::string is;  ///< what is, as a sentence without its subject: `is 0`, `has not told it yet`
  std::string
      expected;  ///< what it should be, likewise: `2: its failsafes have to let it stand`; may be empty

  friend bool operator==(const Check&, const Check&) = default;
};

}  // namespace mlab::vehicle
