#pragma once

#include <cstdint>

namespace mlab::dds {

/// Cyclone's number for a domain of this process, which no other domain here has; outside it means nothing.
class DomainNumber {
 public:
  /// Cyclone's access control knows no higher ones.
  static constexpr std::uint32_t kMaxSecured = 230;

  /// @param is_secured  it has to be one that governance and permissions can name: 1 to kMaxSecured
  explicit DomainNumber(bool is_secured);
  DomainNumber(const DomainNumber&) = delete;
  DomainNumber& operator=(const DomainNumber&) = delete;
  ~DomainNumber();

  /// 0: more than kMaxSecured would be in use.
  std::uint32_t value() const { return value_; }

 private:
  std::uint32_t value_ = 0;
};

}  // namespace mlab::dds
