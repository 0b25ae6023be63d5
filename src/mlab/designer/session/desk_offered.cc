// The files beside open configurations, which they could use.

#include <algorithm>
#include <filesystem>
#include <set>

#include <fmt/core.h>

#include "mlab/designer/session/desk.h"
#include "mlab/text/utf8.h"

namespace mlab::designer {
namespace {

constexpr std::size_t kMostBeside = 50;                 // files of one folder
constexpr std::uintmax_t kLargestBeside = 256U << 10U;  // [bytes]

// The project's folders, as ProjectFolder names them: empty for the project's own.
std::string folder_beside(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

bool is_offerable(const std::string& path) {
  return (path.ends_with(".cdl") || path.ends_with(".cnl")) &&
         path.find_first_of("\"\\:\n\r") == std::string::npos;
}

std::string stamp_of(const std::string& disk_path) {
  std::error_code missing;
  const auto time = std::filesystem::last_write_time(disk_path, missing).time_since_epoch().count();
  const auto size = missing ? 0 : std::filesystem::file_size(disk_path, missing);
  return missing || size > kLargestBeside ? "" : fmt::format("{} {}", time, size);
}

}  // namespace

void Desk::look_beside() {
  std::set<std::string> folders;
  for (const auto& [path, one] : open_) {
    if (one->is_writable) folders.insert(folder_beside(path));
  }
  std::set<std::string> names;
  if (!folders.empty() && project_.is_file(kProjectLibrary)) names.insert(kProjectLibrary);
  for (const std::string& folder : folders) {
    const auto entries = project_.list(folder);
    std::size_t count = 0;
    for (std::size_t i = 0; entries && i < entries->size() && count < kMostBeside; ++i) {
      const documents::ProjectFolder::Entry& entry = (*entries)[i];
      if (entry.is_folder || !is_offerable(entry.path)) continue;
      names.insert(entry.path);
      ++count;
    }
  }
  const std::size_t before = beside_.size();
  std::erase_if(beside_, [&](const auto& one) { return !names.contains(one.first); });
  if (beside_.size() != before) ++beside_number_;
  for (const std::string& name : names) {
    Beside& one = beside_[name];
    // As it stands in the editor, where it is open.
    const OpenConfiguration* open = find(name);
    std::string stamp =
        open != nullptr ? fmt::format("open {}", open->drawn_revision) : stamp_of(project_.disk_path(name));
    if (one.stamp == stamp && !stamp.empty()) continue;
    if (stamp.empty() && one.model == nullptr) continue;
    one.stamp = std::move(stamp);
    one.model = open != nullptr ? open->drawn : one.stamp.empty() ? nullptr : model_beside(name);
    ++beside_number_;
  }
}

std::shared_ptr<const Model> Desk::model_beside(const std::string& name) {
  const std::string disk_path = project_.disk_path(name);
  std::string content;
  std::string source = disk_path;
  if (name.ends_with(".cnl")) {
    content = fmt::format("use \"{}\";\n", std::filesystem::path(disk_path).filename().string());
    source += ".use.cdl";
  } else {
    const text::Result<std::string> read = project_.read(name);
    if (!read) return nullptr;
    content = text::as_utf8(*read);
  }
  return std::make_shared<const Model>(
      std::make_shared<const text::Source>(std::move(source), std::move(content)), environment());
}

std::vector<Offered> Desk::offered(const OpenConfiguration& one) const {
  std::vector<Offered> out;
  if (!one.is_writable) return out;
  const std::string folder = folder_beside(one.path);
  const std::filesystem::path here = std::filesystem::path(one.model->source()->name()).parent_path();
  for (const auto& [name, beside] : beside_) {
    const bool is_near = name == kProjectLibrary || folder_beside(name) == folder;
    if (!is_near || name == one.path || beside.model == nullptr) continue;
    const std::string disk_path = project_.disk_path(name);
    if (!can_use(*one.drawn, disk_path, *beside.model)) continue;
    out.push_back({name, std::filesystem::path(disk_path).lexically_relative(here).string(), beside.model});
  }
  return out;
}

}  // namespace mlab::designer
