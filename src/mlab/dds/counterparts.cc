#include "mlab/dds/counterparts.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "mlab/dds/participant_core.h"
#include "mlab/text/shown.h"

namespace mlab::dds {
namespace {

constexpr std::size_t kMaxMismatches = 20;
constexpr std::ptrdiff_t kKeptOfThoseGone = 256;

std::string_view policy_called(std::uint32_t policy) {
  switch (policy) {
    case DDS_RELIABILITY_QOS_POLICY_ID:
      return "reliability";
    case DDS_DURABILITY_QOS_POLICY_ID:
      return "durability";
    case DDS_LIVELINESS_QOS_POLICY_ID:
      return "liveliness";
    default:
      return "quality of service";
  }
}

}  // namespace

std::optional<Counterparts::Counterpart> Counterparts::find(dds_instance_handle_t handle) const {
  const auto found = all_.find(handle);
  if (found == all_.end()) return std::nullopt;
  return found->second;
}

Counterparts::Counterpart Counterparts::add(dds_instance_handle_t handle,
                                            const dds_builtintopic_endpoint_t& endpoint) {
  forget_some();
  const std::string kind = kind_in(endpoint.qos);
  const auto [at, is_new] = all_.try_emplace(handle);
  at->second.participant = guid_of(endpoint.participant_key);
  at->second.fits = kind == info(kind_).name;
  if (is_new && !at->second.fits)
    note(fmt::format("{} {} `{}` as `{}`: here it is `{}`", at->second.participant.text(), does_, topic_,
                     text::shown(kind), info(kind_).name));
  return at->second;
}

void Counterparts::set_there(dds_instance_handle_t handle, bool is_there) {
  const auto found = all_.find(handle);
  if (found != all_.end()) found->second.is_there = is_there;
}

void Counterparts::set_silent(dds_instance_handle_t handle, bool is_silent) {
  const auto found = all_.find(handle);
  if (found != all_.end()) found->second.is_silent = is_silent;
}

void Counterparts::set_joining(dds_instance_handle_t handle, bool is_joining) {
  const auto found = all_.find(handle);
  if (found != all_.end()) found->second.is_joining = is_joining;
}

void Counterparts::add_incompatible(std::uint32_t policy) {
  note(fmt::format("somebody {} `{}` in a way that does not go with `{}`: {}", does_, topic_,
                   info(kind_).name, policy_called(policy)));
}

std::vector<Guid> Counterparts::participants() const {
  std::vector<Guid> found;
  for (const auto& [handle, one] : all_) {
    if (one.fits && one.is_there && !one.is_silent && !one.is_joining) found.push_back(one.participant);
  }
  return found;
}

void Counterparts::note(std::string mismatch) {
  const bool is_known = std::ranges::find(mismatches_, mismatch) != mismatches_.end();
  if (mismatches_.size() < kMaxMismatches && !is_known) mismatches_.push_back(std::move(mismatch));
}

void Counterparts::forget_some() {
  const auto is_gone = [](const auto& one) { return !one.second.is_there; };
  if (std::ranges::count_if(all_, is_gone) < kKeptOfThoseGone) return;
  std::erase_if(all_, is_gone);
}

}  // namespace mlab::dds
