#include "mlab/preflight/gate.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

namespace mlab::preflight {
namespace {

std::vector<std::string> real_vehicles(const Checklist& checklist) {
  std::vector<std::string> out;
  for (const CheckedVehicle& one : checklist.vehicles) {
    if (!one.session.empty() && !one.is_simulated) out.push_back(one.name);
  }
  return out;
}

std::string how_signed(const Signature& signature) {
  std::string out = fmt::format("the pre-flight checklist was signed by {}", signature.by);
  for (const Acceptance& one : signature.accepted)
    out += fmt::format("; `{}` has failed, and was accepted: {}", one.item, one.because);
  return out;
}

}  // namespace

Checklist Gate::look(const run::Crew& crew) const {
  return assemble(crew, parts_.fleet, parts_.look(hosts_of(*crew.mission)), parts_.version);
}

std::expected<SignedChecklist, std::string> Gate::sign(const run::Crew& crew, Signature signature) const {
  SignedChecklist out = {look(crew), std::move(signature)};
  out.signature.at = parts_.wall_clock();
  if (std::string why = why_not_signed(out.checklist, out.signature); !why.empty())
    return std::unexpected(std::move(why));
  if (std::string why = parts_.store.keep(out); !why.empty())
    return std::unexpected("what was signed can't be kept: " + why);
  return out;
}

std::expected<SignedChecklist, std::string> Gate::held(const run::Crew& crew) const {
  return parts_.store.find(look(crew), parts_.wall_clock());
}

std::string Gate::why_not_start(const run::Crew& crew) {
  std::shared_ptr<Permit> permit;
  {
    const std::scoped_lock lock(mutex_);
    permit = permit_;
  }
  if (!permit || permit->is_given()) return "";
  if (!parts_.unchecked.empty()) {
    let_pass(*permit, hosts_of(*crew.mission),
             {"the vehicles were not checked before the mission: " + parts_.unchecked, "", true});
    return "";
  }
  const Checklist now = look(crew);
  if (!now.is_needed()) {
    let_pass(*permit, {}, {});
    return "";
  }
  const auto found = parts_.store.find(now, parts_.wall_clock());
  if (found) {
    let_pass(*permit, real_vehicles(now), {how_signed(found->signature), json_of(*found)});
    return "";
  }
  const std::vector<std::string> names = real_vehicles(now);
  return fmt::format(
      "the mission moves {} `{}`, and there is no signed pre-flight checklist that holds: {}. Make one: {}",
      names.size() == 1 ? "the vehicle" : "the vehicles", fmt::join(names, "`, `"), found.error(),
      parts_.how);
}

void Gate::let_pass(Permit& permit, std::vector<std::string> vehicles, Passed passed) {
  const std::scoped_lock lock(mutex_);
  if (permit.is_given()) return;
  permit.give(std::move(vehicles));
  passed_ = std::move(passed);
}

std::shared_ptr<Permit> Gate::new_permit() {
  const std::scoped_lock lock(mutex_);
  permit_ = std::make_shared<Permit>();
  passed_ = {};
  return permit_;
}

std::vector<VehicleFacts> Gate::held_back(const std::vector<std::string>& names) const {
  std::shared_ptr<const Permit> permit;
  {
    const std::scoped_lock lock(mutex_);
    permit = permit_;
  }
  if (!permit || !parts_.glance) return {};
  std::vector<std::string> held;
  std::ranges::copy_if(names, std::back_inserter(held),
                       [&](const std::string& name) { return !permit->lets_pass(name); });
  if (held.empty()) return {};
  std::vector<VehicleFacts> out = parts_.glance(held);
  std::erase_if(out, [](const VehicleFacts& one) { return one.is_simulated; });  // nothing stands before them
  return out;
}

bool Gate::has_let_pass() const {
  const std::scoped_lock lock(mutex_);
  return permit_ && permit_->is_given();
}

Gate::Passed Gate::passed() const {
  const std::scoped_lock lock(mutex_);
  return passed_;
}

}  // namespace mlab::preflight
