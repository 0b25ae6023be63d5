#include "mlab/dds/domain_number.h"

#include <atomic>
#include <bitset>
#include <mutex>

namespace mlab::dds {
namespace {

constexpr std::uint32_t kFirstUnsecured = 1000;

struct Secured {
  std::mutex mutex;
  std::bitset<DomainNumber::kMaxSecured + 1> are_used;
};

/// Never destroyed: participants may live as long as the process.
Secured& secured() {
  static auto* const kSecured = new Secured;
  return *kSecured;
}

std::uint32_t free_one() {
  Secured& all = secured();
  const std::lock_guard lock(all.mutex);
  for (std::uint32_t one = 1; one <= DomainNumber::kMaxSecured; ++one) {
    if (all.are_used[one]) continue;
    all.are_used[one] = true;
    return one;
  }
  return 0;
}

std::uint32_t next_one() {
  static std::atomic<std::uint32_t> next = kFirstUnsecured;
  return next++;
}

}  // namespace

DomainNumber::DomainNumber(bool is_secured) : value_(is_secured ? free_one() : next_one()) {}

DomainNumber::~DomainNumber() {
  if (value_ == 0 || value_ > kMaxSecured) return;
  const std::lock_guard lock(secured().mutex);
  secured().are_used[value_] = false;
}

}  // namespace mlab::dds
