#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/mavlink/messages.h"
#include "mlab/vehicle/device.h"

namespace mlab::mavlink {

/// What one parameter of a vehicle has to be, so that it stands when nobody tells it anything.
struct Wanted {
  std::string_view name;
  std::string_view other_name;  ///< that other versions of the firmware have; may be empty
  double low = 0.0;
  double high = 0.0;
  bool is_needed = true;  ///< else it is good advice
  std::string_view why;
};

/// A parameter as people are shown it before a mission.
struct ParameterCheck {
  std::string name;
  std::optional<double> value;  ///< as the vehicle has told it; nothing: it has not yet
  std::string wanted;           ///< `1`, `1 to 2`
  std::string why;
  bool is_needed = true;
  bool is_right = false;
};

/// Knows which parameters of a vehicle are as a safe mission needs them, and asks for those that it does not
/// know.
class Parameters {
 public:
  using Time = vehicle::Clock::time_point;

  /// @param self        our number as a system, which the vehicle has to count as its ground station's
  /// @param standstill  see vehicle::Limits
  Parameters(std::uint8_t self, double standstill);

  void take(const ParamValue& message, Time now);
  /// Nothing is known any more.
  void begin_anew();

  /// The name that is to be asked for now, if any. To be called often; each is asked for about twice a second
  /// until it is known, and every half minute afterwards.
  std::optional<std::string_view> to_ask(Time now);
  /// What is to be written so that a needed parameter, which is known, is right; if any is not.
  struct Write {
    std::string_view name;
    double value = 0.0;
  };
  std::optional<Write> to_write(Time now);

  std::vector<ParameterCheck> checks() const;
  /// Why the vehicle would not be safe, as a sentence without its subject, with how to mend it; empty: it
  /// would.
  std::string problem() const;

 private:
  struct Row {
    Wanted wanted;
    std::optional<double> value;
    bool is_other_name = false;  // of the two names, the one that is asked for, or that was answered
    std::optional<Time> asked_at;
    std::optional<Time> written_at;

    std::string_view name() const { return is_other_name ? wanted.other_name : wanted.name; }
    bool is_right() const { return value && *value >= wanted.low && *value <= wanted.high; }
  };

  std::vector<Row> rows_;
  std::optional<Time> asked_at_;
};

}  // namespace mlab::mavlink
