#include "mlab/console/state_folder.h"

#include <filesystem>
#include <system_error>

#include <fmt/core.h>

#include "mlab/base/hash.h"
#include "mlab/console/enclosed_file.h"

namespace mlab::console {

namespace fs = std::filesystem;

StateFolder::StateFolder(const std::string& folder, std::string_view project) {
  if (folder.empty()) return;
  folder_ = (fs::path(folder) / fmt::format("{:016x}", base::hash_text(project))).string();
  std::error_code cannot;
  fs::create_directories(folder_, cannot);
  fs::permissions(folder_, fs::perms::owner_all, cannot);
}

std::string StateFolder::name_of(std::string_view path, std::string_view extension) {
  return fmt::format("{:016x}{}", base::hash_text(path), extension);
}

bool StateFolder::read(const std::string& name, std::size_t most_bytes, std::string& out) const {
  return !folder_.empty() && EnclosedFolder(folder_, {}).read(name, most_bytes, out).empty();
}

void StateFolder::write(const std::string& name, std::string_view bytes) const {
  if (!folder_.empty()) EnclosedFolder(folder_, {}).write(name, bytes);
}

void StateFolder::remove(const std::string& name) const {
  if (folder_.empty()) return;
  std::error_code cannot;
  fs::remove(fs::path(folder_) / name, cannot);
}

std::vector<std::string> StateFolder::names(std::string_view extension) const {
  std::vector<std::string> out;
  if (folder_.empty()) return out;
  for (EnclosedFolder::Item& item : EnclosedFolder(folder_, {}).items(1000)) {
    if (item.name.ends_with(extension)) out.push_back(std::move(item.name));
  }
  return out;
}

}  // namespace mlab::console
