#include "mlab/vehicle/state.h"

#include <algorithm>

namespace mlab::vehicle {
namespace {

binding::VehicleState::Readiness told(Readiness readiness) {
  using Told = binding::VehicleState::Readiness;
  switch (readiness) {
    case Readiness::kAbsent:
      return Told::kAbsent;
    case Readiness::kSilent:
      return Told::kSilent;
    case Readiness::kNotReady:
      return Told::kNotReady;
    case Readiness::kStandby:
      return Told::kStandby;
    case Readiness::kTaken:
      return Told::kTaken;
    case Readiness::kReady:
      return Told::kReady;
    case Readiness::kFaulty:
      return Told::kFaulty;
  }
  return Told::kFaulty;
}

}  // namespace

std::string why_not_ready(const Report& report) {
  if (!report.why.empty()) return report.why;
  if (report.readiness == Readiness::kAbsent) return "has no device";
  if (report.readiness == Readiness::kSilent) return "says nothing to its process";
  return report.readiness == Readiness::kFaulty ? "is faulty" : "is not ready";
}

binding::VehicleState state_of(const Report& report, Clock::time_point now) {
  const auto age = [&](Clock::time_point at) { return std::max(0.0, seconds_between(at, now)); };
  binding::VehicleState out;
  out.readiness = told(report.readiness);
  if (report.readiness != Readiness::kReady) out.why = why_not_ready(report);
  out.is_global = report.is_global;
  if (report.motion) out.motion_age = age(report.motion->at);
  if (report.battery) out.battery = {report.battery->share, report.battery->voltage, age(report.battery->at)};
  for (const Scan& scan : report.scans)
    out.sensors.push_back({scan.sensor, static_cast<std::uint32_t>(scan.distances.size()), scan.farthest,
                           scan.beam_width, age(scan.at)});
  return out;
}

}  // namespace mlab::vehicle
