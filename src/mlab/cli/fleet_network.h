#pragma once

#include <expected>
#include <string>

#include "mlab/cli/commands.h"
#include "mlab/dds/network.h"

namespace mlab::cli {

inline std::string fleet_of(const std::string& named) {
  return named.empty() ? "default" : named;
}

/// Where agents of this user keep what outlives them; empty where there is no such place.
std::string agents_folder();
/// One of their files, for each name in each fleet on this machine; empty as above.
std::string kept_file(const std::string& fleet, const std::string& name, const char* what);

/// Where the keys of a secured fleet are on this machine, by the rules of XDG; it may be missing. Empty where
/// there is no such place.
std::string keys_folder(const std::string& fleet);

/// Folder of the identity that the options name; empty where the fleet is not secured.
std::string identity_folder(const NetworkOptions& options);

/// @errors  a sentence: with --secure, an identity that can't be used
std::expected<dds::Network, std::string> network_of(const NetworkOptions& options);

}  // namespace mlab::cli
