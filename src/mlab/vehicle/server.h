#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "mlab/vehicle.pb.h"
#include "mlab/vehicle/device.h"
#include "mlab/vehicle/pose_history.h"

namespace mlab::vehicle {

/// A command that answers a report older than this is not carried out: its vehicle stands [s].
inline constexpr double kCommandPatience = 0.5;
/// A run of which nothing has been heard for so long drives the vehicle no more; another one may [s].
inline constexpr double kSessionPatience = 2.0;

/// The side of a vehicle's process: lets one run at a time drive a device, as long as its commands are live.
/// A vehicle that somebody has taken (a pilot, another ground station) is left to him, but for the emergency
/// stop; one that was taken while it was driven also when he lets go of it, until a robot gets it as its body
/// anew. Who has taken it is the device's to say. It knows nothing of what carries messages, nor what time it
/// is.
class Server {
 public:
  /// @param device      outlives this
  /// @param is_stopped  an emergency stop holds
  Server(Device& device, std::function<bool()> is_stopped);

  /// Takes a command that has come; anything may.
  void hear(const std::string& sender, const std::string& body, Clock::time_point now);
  /// Whoever that was drives it no more.
  void lose(const std::string& sender);
  /// Drives the device, or has it stand. To be called at least every 50 ms.
  void work(Clock::time_point now);
  /// What is to be said now.
  std::string report(Clock::time_point now);

  bool is_driven() const { return session_ != 0; }
  /// Why the device stands though a run drives it; empty: it does not.
  const std::string& standing() const { return standing_; }

 private:
  static constexpr std::size_t kRemembered = 64;  // reports: those of the last seconds

  /// How old what a report told is by now [s]; nothing that is younger than kCommandPatience where it is not
  /// known any more.
  double age_of(std::uint64_t report, Clock::time_point now) const;
  std::string why_it_stands(Readiness readiness, Clock::time_point now) const;
  bool is_left_alone(Readiness readiness, Clock::time_point now) const;
  void notice_taking(Readiness readiness);
  void stand(std::string why, Clock::time_point now);
  void drive(Readiness readiness, Clock::time_point now);

  Device& device_;
  std::function<bool()> is_stopped_;
  std::uint64_t reported_ = 0;                            // number of the last report
  std::array<Clock::time_point, kRemembered> told_at_{};  // by number
  std::uint64_t session_ = 0;                             // of the run that drives; 0: none
  std::string driver_;                                    // who sends for it
  Clock::time_point heard_;                               // of that run
  wire::VehicleCommand newest_;                           // of that run
  std::uint64_t carried_out_ = 0;                         // number of its last one that was
  Command command_;                                       // that was made of it
  std::string standing_;
  std::pair<std::uint64_t, std::uint32_t> engaged_by_;  // session and engagement of the newest command
  bool has_driven_ = false;                             // under that engagement, while it was ready
  bool is_taken_ = false;                               // somebody else has taken it since; it is left to him
  std::optional<Clock::time_point> driven_;             // last
  PoseHistory poses_;
  wire::VehicleReport message_;
};

}  // namespace mlab::vehicle
