#pragma once

#include <expected>
#include <filesystem>
#include <string>

namespace mlab::text {

/// Makes the folder and those above it that are missing; the folder itself gets mode 0700, also where it was
/// there. One that can't be kept from others is not left behind where it was not there before.
/// @errors  a sentence with the path
std::expected<void, std::string> make_private_folder(const std::filesystem::path& folder);

}  // namespace mlab::text
