#include <chrono>

#include "mlab/preflight/preflight.h"
#include "mlab/vehicle/state.h"

namespace mlab::preflight {

std::optional<binding::VehicleState> state_of(const VehicleFacts& facts) {
  if (!facts.is_there || !facts.report) return std::nullopt;
  const std::chrono::duration<double> since(facts.report_age);
  const auto now = facts.arrived + std::chrono::duration_cast<vehicle::Clock::duration>(since);
  binding::VehicleState out = vehicle::state_of(*facts.report, now);
  out.name = facts.name;
  out.kind = facts.kind;
  out.age = facts.report_age;
  out.driver =
      facts.is_driven ? binding::VehicleState::Driver::kAnotherRun : binding::VehicleState::Driver::kNobody;
  out.is_stopped = facts.is_stopped;
  return out;
}

}  // namespace mlab::preflight
