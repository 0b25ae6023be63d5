#pragma once

#include <cstdint>
#include <expected>
#include <filesystem>
#include <string>
#include <utility>

// Files that nobody but their owner may read.
namespace mlab::keys {

/// Writes the whole file, mode 0600, or leaves what was there: the text goes to a new file beside it, which
/// then takes its name.
/// @errors  a sentence with the path
std::expected<void, std::string> write_private(const std::filesystem::path& file, const std::string& text);

/// @errors  a sentence with the path: it is missing, no file, can't be read, or is larger than any of ours
std::expected<std::string, std::string> read_file(const std::filesystem::path& file);

/// Keeps others who ask for the same from a folder, for as long as it is there. Waits until they are done.
class FolderLock {
 public:
  /// @errors  a sentence with the path
  static std::expected<FolderLock, std::string> of(const std::filesystem::path& folder);
  FolderLock(FolderLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

 private:
  explicit FolderLock(int file) : file_(file) {}
  int file_;
};

/// Nothing where only its owner, who is who runs this (or root), may read the file; else a sentence.
std::expected<void, std::string> check_private(const std::filesystem::path& file);

}  // namespace mlab::keys
