#include "mlab/console/published/preflight_encoder.h"

#include "mlab/console/published/overview.h"

namespace mlab::console {
namespace {

using preflight::CheckResult;

Preflight::Result told(CheckResult result) {
  switch (result) {
    case CheckResult::kPass:
      return Preflight::PASS;
    case CheckResult::kWarn:
      return Preflight::WARN;
    case CheckResult::kFail:
      return Preflight::FAIL;
    case CheckResult::kUnknown:
      return Preflight::UNKNOWN;
  }
  return Preflight::UNKNOWN;
}

}  // namespace

void encode_checklist(const preflight::Checklist& checklist, Preflight& out) {
  for (const preflight::CheckedVehicle& vehicle : checklist.vehicles) {
    Preflight::Vehicle& one = *out.add_vehicles();
    one.set_name(clean(vehicle.name));
    one.set_kind(clean(vehicle.kind));
    one.set_version(clean(vehicle.version));
    one.set_is_there(!vehicle.session.empty());
    one.set_is_simulated(vehicle.is_simulated);
    one.mutable_robots()->Assign(vehicle.robots.begin(), vehicle.robots.end());
  }
  for (const preflight::Item& item : checklist.items) {
    Preflight::Item& one = *out.add_items();
    one.set_id(clean(item.id));
    one.set_vehicle(clean(item.vehicle));
    one.set_name(clean(item.name));
    one.set_result(told(item.result));
    one.set_is(clean(item.is));
    one.set_expected(clean(item.expected));
  }
  for (const preflight::ManualItem& item : checklist.manual) {
    Preflight::Manual& one = *out.add_manual();
    one.set_id(clean(item.id));
    one.set_text(clean(item.text));
  }
}

void encode_signature(const preflight::Signature& signature, Preflight& out) {
  out.set_signed_by(clean(signature.by));
  out.set_signed_at(signature.at);
  for (const preflight::Acceptance& accepted : signature.accepted) {
    Preflight::Acceptance& one = *out.add_accepted();
    one.set_item(clean(accepted.item));
    one.set_because(clean(accepted.because));
  }
}

}  // namespace mlab::console
