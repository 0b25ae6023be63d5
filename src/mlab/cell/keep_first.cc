#include "mlab/cell/keep_first.h"

#include <filesystem>

namespace mlab::cell {

std::error_code keep_first(const std::string& from, const std::string& name) {
  namespace fs = std::filesystem;
  std::error_code failure;
  fs::create_hard_link(from, name, failure);
  if (failure == std::errc::file_exists) return {};
  // Not every file system has links.
  if (failure) fs::rename(from, name, failure);
  return failure;
}

}  // namespace mlab::cell
