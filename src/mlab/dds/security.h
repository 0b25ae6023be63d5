#pragma once

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
};

}  // namespace mlab::dds
