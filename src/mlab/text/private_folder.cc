#include "mlab/text/private_folder.h"

#include <cstddef>
#include <system_error>

#include <fmt/format.h>

#include "mlab/text/shown.h"

namespace mlab::text {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kLongestPath = 1000;

}  // namespace

std::expected<void, std::string> make_private_folder(const fs::path& folder) {
  const std::string name = shown(folder.string(), kLongestPath);
  std::error_code failure;
  const bool is_new = fs::create_directories(folder, failure);
  if (failure)
    return std::unexpected(fmt::format("the folder `{}` can't be made: {}", name, failure.message()));
  fs::permissions(folder, fs::perms::owner_all, failure);
  if (!failure) return {};
  std::error_code left;
  if (is_new) fs::remove(folder, left);
  return std::unexpected(
      fmt::format("the folder `{}` can't be kept from others: {}", name, failure.message()));
}

}  // namespace mlab::text
