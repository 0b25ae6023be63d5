#include "mlab/lsp/workspace.h"

#include <unistd.h>

#include <algorithm>
#include <system_error>

namespace mlab::lsp {
namespace {

namespace fs = std::filesystem;

bool is_ours(const fs::path& path) {
  const std::string ending = path.extension().string();
  return ending == ".mdl" || ending == ".odl" || ending == ".ovl" || ending == ".cnl" || ending == ".cdl";
}

// By names, not by letters: `/work` does not enclose `/workshop`.
bool is_inside(const std::string& path, const std::string& folder) {
  const fs::path inner(path);
  const fs::path outer(folder);
  return std::ranges::mismatch(outer, inner).in1 == outer.end();
}

}  // namespace

std::string normal(const std::string& path) {
  std::error_code failure;
  const fs::path canonical = fs::weakly_canonical(path, failure);
  return failure ? path : canonical.string();
}

void Workspace::look_at(const fs::directory_entry& entry, const text::Files& files) {
  std::error_code failure;
  const auto time = entry.last_write_time(failure);
  const std::uintmax_t size = failure ? 0 : entry.file_size(failure);
  const std::string path = normal(entry.path().string());
  const auto known = files_.find(path);
  if (failure || (known != files_.end() && known->second.time == time && known->second.size == size)) return;
  const auto source = files.read(entry.path().string());
  const auto language = source ? assist::language_of(**source) : std::nullopt;
  if (language) files_[path] = {time, size, {*source, *language}};
}

std::vector<assist::Text> Workspace::texts(const std::set<std::string>& known, const text::Files& files) {
  std::set<std::string> there;
  std::vector<std::string> homes;
  for (const std::string& folder : folders_) homes.push_back(normal(folder));
  const auto is_at_home = [&](const fs::directory_entry& entry, const std::string& path) {
    std::error_code failure;
    return !entry.is_symlink(failure) ||
           std::ranges::any_of(homes, [&](const std::string& home) { return is_inside(path, home); });
  };
  is_cut_ = false;
  for (const std::string& folder : folders_) {
    std::error_code failure;
    fs::recursive_directory_iterator it(folder, fs::directory_options::skip_permission_denied, failure);
    for (; !failure && it != fs::recursive_directory_iterator(); it.increment(failure)) {
      const std::string name = it->path().filename().string();
      const bool is_apart = name.starts_with('.') || name == "node_modules";
      const bool is_deep = it.depth() >= kMostDepth;
      if ((is_apart || is_deep) && it->is_directory(failure)) {
        it.disable_recursion_pending();
        is_cut_ = is_cut_ || (is_deep && !is_apart);
      }
      if (!is_ours(it->path()) || !it->is_regular_file(failure)) continue;
      const std::string path = normal(it->path().string());
      if (there.contains(path) || !is_at_home(*it, path)) continue;
      is_cut_ = is_cut_ || there.size() >= kMostFiles;
      if (there.size() < kMostFiles && there.insert(path).second) look_at(*it, files);
    }
  }
  std::erase_if(files_, [&](const auto& one) { return !there.contains(one.first); });
  std::vector<assist::Text> out;
  for (const auto& [path, file] : files_) {
    if (!known.contains(path)) out.push_back(file.text);
  }
  return out;
}

std::string why_fixed(const std::string& path) {
  std::error_code failure;
  const bool is_writable = !fs::exists(path, failure) || ::access(path.c_str(), W_OK) == 0;
  return is_writable ? "" : "is read only";
}

}  // namespace mlab::lsp
