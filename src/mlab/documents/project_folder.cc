#include "mlab/documents/project_folder.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "mlab/documents/enclosed_file.h"
#include "mlab/documents/refused.h"
#include "mlab/text/files.h"

namespace mlab::documents {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestPath = 1000;

std::string canonical(const std::string& folder) {
  if (folder.empty()) return "";
  std::error_code missing;
  const fs::path path = fs::weakly_canonical(fs::absolute(folder, missing), missing);
  std::string out = path.string();
  while (out.size() > 1 && out.ends_with('/')) out.pop_back();
  return missing ? "" : out;
}

std::string extension_of(std::string_view path) {
  std::string out = fs::path(path).extension().string();
  std::ranges::transform(out, out.begin(), [](unsigned char c) { return std::tolower(c); });
  return out;
}

std::string kind_of(std::string_view path) {
  const std::string extension = extension_of(path);
  if (extension == ".mdl") return "mission";
  if (extension == ".odl" || extension == ".ovl") return "overlay";
  for (const char* picture : {".png", ".jpg", ".jpeg", ".gif", ".bmp", ".webp", ".svg", ".pgm", ".ppm"}) {
    if (extension == picture) return "picture";
  }
  return "other";
}

// Nothing for a name that could lead anywhere else. Hidden files are none of the console's business.
std::optional<std::vector<std::string>> parts_of(std::string_view path) {
  if (path.size() > kLongestPath || path.find('\0') != std::string_view::npos) return std::nullopt;
  std::vector<std::string> out;
  while (true) {
    const std::size_t slash = path.find('/');
    const std::string_view part = path.substr(0, slash);
    if (part.empty() || part.starts_with('.')) return std::nullopt;
    out.emplace_back(part);
    if (slash == std::string_view::npos) return out;
    path.remove_prefix(slash + 1);
  }
}

template <class List, class Value>
bool holds(const List& list, const Value& value) {
  return std::ranges::find(list, value) != list.end();
}

}  // namespace

ProjectFolder::ProjectFolder(const Settings& settings)
    : project_(canonical(settings.folder)),
      examples_(canonical(settings.examples)),
      writable_(settings.writable),
      writable_kinds_(settings.writable_kinds) {}

std::string ProjectFolder::name() const {
  return fs::path(project_).filename().string();
}

std::optional<ProjectFolder::Location> ProjectFolder::locate(std::string_view path) const {
  std::string root = project_;
  if (path.starts_with(kExampleFiles)) {
    path.remove_prefix(kExampleFiles.size());
    root = examples_;
  }
  if (root.empty()) return std::nullopt;
  auto parts = parts_of(path);
  if (!parts) return std::nullopt;
  return Location{std::move(root), std::move(*parts)};
}

text::Result<std::vector<ProjectFolder::Entry>> ProjectFolder::list(std::string_view folder) const {
  std::string prefix(folder);
  std::string root = project_;
  std::vector<std::string> parts;
  if (folder == kExampleFiles) {
    root = examples_;
  } else if (!folder.empty()) {
    const auto location = locate(folder);
    if (!location) return refused("cannot-read", fmt::format("there is no folder {}", shown(folder)));
    root = location->root;
    parts = location->parts;
    prefix += '/';
  }
  const EnclosedFolder open(root, parts);
  if (!open) return refused("cannot-read", fmt::format("there is no folder {}", shown(folder)));
  std::vector<Entry> out;
  for (const EnclosedFolder::Item& item : open.items(kMostEntries)) {
    if (item.name.starts_with('.')) continue;
    out.push_back({prefix + item.name, item.is_folder, item.is_folder ? "" : kind_of(item.name)});
  }
  std::ranges::sort(out, [](const Entry& a, const Entry& b) {
    return a.is_folder != b.is_folder ? a.is_folder : a.path < b.path;
  });
  return out;
}

std::vector<std::string> ProjectFolder::files(std::string_view folder, std::string_view ending) const {
  std::vector<std::string> out;
  find(folder, ending, 0, out);
  return out;
}

void ProjectFolder::find(std::string_view folder, std::string_view ending, int depth,
                         std::vector<std::string>& out) const {
  const auto entries = list(folder);
  if (!entries || depth > kMaxDepth) return;
  for (const Entry& entry : *entries) {
    if (out.size() >= kMaxFound) return;
    if (entry.is_folder)
      find(entry.path, ending, depth + 1, out);
    else if (extension_of(entry.path) == ending)
      out.push_back(entry.path);
  }
}

bool ProjectFolder::is_file(std::string_view path) const {
  if (path.starts_with(kOutsideFiles)) {
    const std::string file(path.substr(kOutsideFiles.size()));
    std::error_code unreadable;
    return holds(outside_, file) && fs::is_regular_file(file, unreadable);
  }
  const auto location = locate(path);
  return location &&
         EnclosedFolder::of_file(location->root, location->parts).has_file(location->parts.back());
}

// A name with a colon says that it is none of the project, or would say so some day.
bool ProjectFolder::is_writable(std::string_view path) const {
  constexpr std::size_t kLongestName = 240;
  if (!holds(writable_, extension_of(path)) || path.find_first_of(":\\\n\r") != std::string_view::npos)
    return false;
  const auto location = locate(path);
  return location && std::ranges::all_of(location->parts,
                                         [](const std::string& part) { return part.size() <= kLongestName; });
}

text::Result<std::string> ProjectFolder::read(std::string_view path) const {
  if (path.starts_with(kOutsideFiles)) {
    if (!is_file(path)) return refused("cannot-read", fmt::format("there is no file {}", shown(path)));
    const auto source = text::read_source(std::string(path.substr(kOutsideFiles.size())));
    if (!source) return std::unexpected(source.error());
    return std::string((*source)->text());
  }
  const auto location = locate(path);
  if (!location) return refused("cannot-read", fmt::format("{} is not in the project folder", shown(path)));
  std::string out;
  const std::string problem = EnclosedFolder::of_file(location->root, location->parts)
                                  .read(location->parts.back(), text::Source::kMaxBytes, out);
  if (!problem.empty())
    return refused("cannot-read", fmt::format("cannot read {}: {}", shown(path), problem));
  return out;
}

std::string ProjectFolder::beginning(std::string_view path) const {
  if (path.starts_with(kOutsideFiles))
    return is_file(path) ? text::files_on_disk().beginning(std::string(path.substr(kOutsideFiles.size())))
                         : "";
  const auto location = locate(path);
  if (!location) return "";
  std::string out;
  // More than was asked for is a complaint, after the first of it has been read.
  EnclosedFolder::of_file(location->root, location->parts).read(location->parts.back(), 1024, out);
  return out;
}

text::Result<bool> ProjectFolder::write(std::string_view path, std::string_view text) const {
  const auto location = locate(path);
  if (!location || !is_writable(path)) {
    return refused("cannot-write",
                   fmt::format("{} can't be written: only {} inside of the project folder can", shown(path),
                               writable_kinds_));
  }
  const std::string problem =
      EnclosedFolder::of_file(location->root, location->parts, EnclosedFolder::Missing::kMake)
          .write(location->parts.back(), text);
  if (!problem.empty())
    return refused("cannot-write", fmt::format("cannot write {}: {}", shown(path), problem));
  return true;
}

void ProjectFolder::allow_outside(const std::string& disk_path) {
  std::error_code odd;
  std::string path = fs::absolute(disk_path, odd).lexically_normal().string();
  if (!holds(outside_, path)) outside_.push_back(std::move(path));
}

std::optional<std::string> ProjectFolder::name_of(const std::string& disk_path) const {
  std::error_code odd;
  const std::string path = fs::absolute(disk_path, odd).lexically_normal().string();
  for (const auto& [root, prefix] :
       {std::pair(&project_, std::string_view()), std::pair(&examples_, kExampleFiles)}) {
    if (root->empty() || !path.starts_with(*root + '/')) continue;
    std::string name = std::string(prefix) + path.substr(root->size() + 1);
    if (locate(name)) return name;
  }
  if (holds(outside_, path)) return std::string(kOutsideFiles) + path;
  return std::nullopt;
}

std::string ProjectFolder::disk_path(std::string_view path) const {
  if (path.starts_with(kOutsideFiles)) return std::string(path.substr(kOutsideFiles.size()));
  const auto location = locate(path);
  if (!location) return "";
  std::string out = location->root;
  for (const std::string& part : location->parts) out += '/' + part;
  return out;
}

}  // namespace mlab::documents
