#include <algorithm>
#include <string>

#include <fmt/core.h>

#include "mlab/preflight/preflight.h"

namespace mlab::preflight {
namespace {

constexpr double kClockSlack = 60.0;  // so far ahead it may have been signed, as clocks are set [s]

const Item* item_of(const Checklist& checklist, const std::string& id) {
  const auto at = std::ranges::find(checklist.items, id, &Item::id);
  return at == checklist.items.end() ? nullptr : &*at;
}

bool is_blank(const std::string& text) {
  return text.find_first_not_of(" \t\n") == std::string::npos;
}

const Acceptance* acceptance_of(const Signature& signature, const std::string& id) {
  const auto at = std::ranges::find(signature.accepted, id, &Acceptance::item);
  return at == signature.accepted.end() ? nullptr : &*at;
}

std::string what_failed(const Item& item) {
  return fmt::format("{}{}: {}", item.vehicle.empty() ? "" : fmt::format("`{}`, ", item.vehicle), item.name,
                     item.is);
}

std::string minutes_words(double seconds) {
  return fmt::format("{:.0f} minutes", seconds / 60.0);
}

// Why the vehicles are not those that were signed for; empty: they are.
std::string why_other_vehicles(const Checklist& then, const Checklist& now) {
  for (const CheckedVehicle& one : now.vehicles) {
    const auto at = std::ranges::find(then.vehicles, one.name, &CheckedVehicle::name);
    if (at == then.vehicles.end()) return fmt::format("it says nothing of the vehicle `{}`", one.name);
    if (one.session.empty() && !at->session.empty())
      return fmt::format("the vehicle `{}` is not there any more", one.name);
    if (at->session != one.session || at->is_simulated != one.is_simulated)
      return fmt::format("the process of the vehicle `{}` was started anew since", one.name);
  }
  for (const CheckedVehicle& one : then.vehicles) {
    if (std::ranges::find(now.vehicles, one.name, &CheckedVehicle::name) == now.vehicles.end())
      return fmt::format("`{}` is no vehicle of the mission any more", one.name);
  }
  return "";
}

}  // namespace

std::string why_not_signed(const Checklist& checklist, const Signature& signature) {
  if (is_blank(signature.by)) return "it is signed with a name, and there is none";
  for (const Acceptance& one : signature.accepted) {
    const Item* const item = item_of(checklist, one.item);
    if (item == nullptr) return fmt::format("there is no item `{}` that could be accepted", one.item);
    if (item->result != CheckResult::kFail)
      return fmt::format("`{}` has not failed, so there is nothing to accept", one.item);
    if (is_blank(one.because)) return fmt::format("`{}` is accepted without a reason", one.item);
  }
  for (const Item& one : checklist.items) {
    if (one.result == CheckResult::kFail && acceptance_of(signature, one.id) == nullptr)
      return fmt::format("`{}` has failed: {}", one.id, what_failed(one));
  }
  for (const ManualItem& one : checklist.manual) {
    if (std::ranges::find(signature.confirmed, one.id) == signature.confirmed.end())
      return fmt::format("`{}` is not confirmed: {}", one.id, one.text);
  }
  return "";
}

std::string why_it_does_not_hold(const SignedChecklist& checklist, const Checklist& now, double at) {
  const Signature& signature = checklist.signature;
  const Checklist& then = checklist.checklist;
  if (then.mission != now.mission) return fmt::format("it is of the mission `{}`", then.mission);
  if (then.fleet != now.fleet) return fmt::format("it is of the fleet `{}`", then.fleet);
  if (std::string why = why_not_signed(then, signature); !why.empty()) return why;
  const double age = at - signature.at;
  if (!(age <= kHoldsFor))
    return fmt::format("{} signed it {} ago, and it holds for {}", signature.by, minutes_words(age),
                       minutes_words(kHoldsFor));
  if (age < -kClockSlack) return "it was signed at a time that is yet to come: this machine's clock was set";
  if (then.digest != now.digest) return "the mission, or a file that it is made from, was changed since";
  if (std::string why = why_other_vehicles(then, now); !why.empty()) return why;
  if (then.manual != now.manual) return "other things are to be confirmed now";
  for (const Item& one : now.items) {
    if (one.result == CheckResult::kFail && acceptance_of(signature, one.id) == nullptr)
      return fmt::format("`{}` has failed since: {}", one.id, what_failed(one));
  }
  return "";
}

}  // namespace mlab::preflight
