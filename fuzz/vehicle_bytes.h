#pragma once

// What the fuzzers of devices share: a line that says what they want, and what has to hold of any report.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "mlab/vehicle/device.h"
#include "mlab/vehicle/stream.h"

namespace mlab::fuzz {

/// An open line whose other end says the bytes given to it.
class SaidLine final : public vehicle::Stream {
 public:
  const std::string& name() const override { return name_; }
  bool is_open() const override { return true; }
  const std::string& why() const override { return why_; }
  std::uint64_t openings() const override { return 1; }
  std::span<const std::byte> read(vehicle::Clock::time_point) override {
    read_ = std::exchange(said, {});
    return std::as_bytes(std::span(read_));
  }
  bool write(std::span<const std::byte>, vehicle::Clock::time_point) override { return true; }
  void begin_anew(vehicle::Clock::time_point) override {}

  std::string said;

 private:
  std::string read_;
  const std::string name_ = "fuzz";
  const std::string why_;
};

inline void require(bool holds) {
  if (!holds) std::abort();
}

inline void check_report(const vehicle::Report& report, vehicle::Clock::time_point now) {
  if (report.readiness == vehicle::Readiness::kReady)
    require(report.motion.has_value() && report.why.empty());
  if (report.motion.has_value()) {
    const vehicle::Motion& motion = *report.motion;
    require(motion.at <= now && now - motion.at <= std::chrono::seconds(1));
    require(std::isfinite(motion.pose.position.x) && std::isfinite(motion.pose.position.y) &&
            std::isfinite(motion.pose.heading) && std::isfinite(motion.speed) &&
            std::isfinite(motion.turn_rate));
  }
  if (report.battery.has_value()) require(report.battery->share >= 0.0 && report.battery->share <= 1.0);
  for (const vehicle::Scan& scan : report.scans) {
    require(scan.at <= now && now - scan.at <= std::chrono::seconds(1));
    for (const float distance : scan.distances) {
      require(!(distance < scan.nearest - 1e-3) &&
              (std::isinf(distance) || !(distance > scan.farthest + 1e-3)));
    }
  }
}

/// Lets a device hear pieces of what is said, and drive and stop meanwhile.
/// @param next  the next piece; empty: it was the last one
template <class Next>
void talk_to(vehicle::Device& device, SaidLine& line, Next&& next) {
  vehicle::Clock::time_point now{std::chrono::hours(1)};
  for (int i = 0; i < 2000; ++i) {
    line.said = next();
    if (line.said.empty()) break;
    now += std::chrono::milliseconds(50);
    device.work(now);
    check_report(device.report(now), now);
    for (const vehicle::Check& one : device.checks(now)) require(!one.name.empty() && !one.is.empty());
    if (i % 5 == 4) device.stop(now);
    if (i % 3 == 0) device.drive({0.1, 1e300}, now);
  }
  now += std::chrono::seconds(3);
  line.said.clear();
  device.work(now);
  require(device.report(now).readiness != vehicle::Readiness::kReady &&
          !device.report(now).motion.has_value());
}

}  // namespace mlab::fuzz
