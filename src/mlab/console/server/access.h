#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "mlab/console/server/http.h"

namespace mlab::console {

/// Who may ask. A page of another site that runs in the operator's browser can reach this machine: it knows
/// no token, and it is known by the names that it uses.
class Access {
 public:
  struct Place {
    std::string address;   ///< that is listened to
    std::string hostname;  ///< of this machine
    std::uint16_t port = 0;
    bool is_encrypted = false;
  };
  Access(std::string token, Place place);

  /// The request names this server as its own pages do. Where an attacker's domain name leads here (DNS
  /// rebinding) it names that domain instead. An address in digits can't be led anywhere.
  bool is_for_us(std::string_view host) const;
  /// It comes from a page of this server, or from no page at all.
  bool is_from_us(const HttpRequest& request) const;
  /// `?token=T`, or `Authorization: Bearer T`.
  bool has_token(const HttpRequest& request) const;

  const std::string& token() const { return token_; }
  /// What the pages of this server may connect to.
  std::string socket_origin(std::string_view host) const;

 private:
  std::string token_;
  Place place_;
};

}  // namespace mlab::console
