#pragma once

#include <string>

#include "mlab/keys/certificates.h"

// What DDS Security wants to be told of a fleet, as XML; it counts once it is signed.
namespace mlab::keys {

/// What is protected: everything is encrypted, and nobody takes part who has not proved who he is.
std::string governance();

/// What an identity may do: write and read the topics of its fleet, and nothing else.
/// @param subject  of its certificate
std::string permissions(const std::string& subject, const std::string& fleet, const Validity& validity);

}  // namespace mlab::keys
