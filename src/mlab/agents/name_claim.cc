#include "mlab/agents/name_claim.h"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <string>

#include <fmt/format.h>

#include "mlab/base/hash.h"

namespace mlab::agents {

NameClaim::NameClaim(std::string_view fleet, std::string_view name) {
  // Both names together may be longer than an address.
  const std::string address =
      fmt::format("mlab-agent-{:016x}", base::hash_text(fmt::format("{}@{}", fleet, name)));
  sockaddr_un own{};
  own.sun_family = AF_UNIX;
  static_assert(sizeof own.sun_path > 1 + 11 + 16);
  std::memcpy(own.sun_path + 1, address.data(), address.size());  // behind a zero: abstract
  descriptor_ = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (descriptor_ < 0) return;
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + address.size());
  is_taken_ = ::bind(descriptor_, reinterpret_cast<const sockaddr*>(&own), size) != 0 && errno == EADDRINUSE;
}

NameClaim::~NameClaim() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace mlab::agents
