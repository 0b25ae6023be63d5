#pragma once

#include <cstdint>
#include <expected>
#include <filesystem>
#include <string>

// Files that nobody but their owner may read.
namespace mlab::keys {

/// Makes the folder and those above it that are missing; the folder itself gets mode 0700.
/// @errors  a sentence with the path
std::expected<void, std::string> make_private_folder(const std::filesystem::path& folder);

/// Writes the whole file, mode 0600, or leaves what was there: the text goes to a new file beside it, which
/// then takes its name.
/// @errors  a sentence with the path
std::expected<void, std::string> write_private(const std::filesystem::path& file, const std::string& text);

/// @errors  a sentence with the path: it is missing, no file, can't be read, or is larger than any of ours
std::expected<std::string, std::string> read_file(const std::filesystem::path& file);

/// Nothing where only its owner, who is who runs this (or root), may read the file; else a sentence.
std::expected<void, std::string> check_private(const std::filesystem::path& file);

}  // namespace mlab::keys
