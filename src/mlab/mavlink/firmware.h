#pragma once

#include <optional>
#include <string>

#include "mlab/mavlink/messages.h"
#include "mlab/vehicle/device.h"

namespace mlab::mavlink {

/// Which firmware a rover has: asked for until it tells, now and then where it does not. For people only:
/// whether it is driven does not depend on it.
class Firmware {
 public:
  using Time = vehicle::Clock::time_point;

  /// Whether it is to be asked now; if so it counts as asked.
  bool is_to_be_asked(Time now);
  void take(const AutopilotVersion& message);
  /// It knows no such question, or does not tell.
  void take(const CommandAck& message);
  /// Another one may be there now.
  void begin_anew() { *this = {}; }

  /// `firmware`, as a check before a mission; never fails.
  vehicle::Check check() const;

 private:
  std::optional<AutopilotVersion> told_;
  std::optional<Time> asked_at_;
  int asked_ = 0;
  bool does_not_tell_ = false;
};

/// `4.5.7`, `4.6.0-rc`, of AutopilotVersion::flight_sw_version.
std::string version_text(std::uint32_t version);

}  // namespace mlab::mavlink
