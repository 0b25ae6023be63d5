#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace mlab::dds {

/// The files by which a participant proves who it is, and knows who else belongs to its fleet (DDS Security).
/// They are read when it is opened, not later: what changes in them counts for the next one.
struct Security {
  std::string authority;    ///< certificate of who has signed the others, PEM
  std::string certificate;  ///< PEM
  std::string key;          ///< its private key, PEM
  std::string governance;   ///< what is protected, S/MIME
  std::string permissions;  ///< what the certificate's owner may do, S/MIME
  std::string withdrawn;    ///< list of certificates that are no longer good (CRL), PEM
  std::int64_t end = 0;     ///< till when the certificate is good [s since 1970]; 0: nobody has looked
};

/// How long the certificate is good yet, by the machine's clock, but for a moment in which a participant can
/// take leave; 0: it has run out. Cyclone ends its half of a participant then: all others are gone for it,
/// and making a reader or a writer in it is a crash (0.10.2). It reckons from when the participant was
/// opened, and does not follow a clock that is set meanwhile.
std::chrono::seconds time_left(const Security& security);

}  // namespace mlab::dds
