#include "mlab/designer/session/project_texts.h"

#include <unistd.h>

#include <set>
#include <system_error>

#include <fmt/core.h>

namespace mlab::designer {
namespace {

bool is_in_a_language(const std::string& path) {
  return path.ends_with(".cdl") || path.ends_with(".cnl") || path.ends_with(".mdl") ||
         path.ends_with(".odl") || path.ends_with(".ovl");
}

std::optional<assist::Text> text_of(const std::string& name, std::string content) {
  auto source = std::make_shared<const text::Source>(name, std::move(content));
  const auto language = assist::language_of(*source);
  if (!language) return std::nullopt;
  return assist::Text{std::move(source), *language};
}

}  // namespace

void ProjectTexts::find(const std::string& folder, int depth, std::vector<std::string>& out) {
  const auto entries = desk_.project().list(folder);
  if (!entries || entries->empty()) return;
  if (depth > documents::ProjectFolder::kMaxDepth) {
    is_cut_ = true;
    return;
  }
  is_cut_ = is_cut_ || entries->size() == documents::ProjectFolder::kMostEntries;
  for (const documents::ProjectFolder::Entry& entry : *entries) {
    if (!entry.is_folder && !is_in_a_language(entry.path)) continue;
    if (out.size() == kMostFiles) {
      is_cut_ = true;
      return;
    }
    if (entry.is_folder)
      find(entry.path, depth + 1, out);
    else
      out.push_back(entry.path);
  }
}

std::string ProjectTexts::left_out() const {
  if (!is_cut_) return "";
  return fmt::format("files more than {} folders deep, or beyond the first {}, were not looked at",
                     documents::ProjectFolder::kMaxDepth, kMostFiles);
}

const ProjectTexts::File& ProjectTexts::file(const std::string& path) {
  const std::string disk_path = desk_.project().disk_path(path);
  std::error_code missing;
  const auto time = std::filesystem::last_write_time(disk_path, missing);
  const std::uintmax_t size = missing ? 0 : std::filesystem::file_size(disk_path, missing);
  const auto known = files_.find(path);
  if (known != files_.end() && known->second.time == time && known->second.size == size) return known->second;
  File& out = files_[path];
  out = {time, size, std::nullopt};
  if (text::Result<std::string> content = desk_.project().read(path))
    out.text = text_of(disk_path, std::move(*content));
  return out;
}

// Unsaved work on a configuration that is not open just now.
std::optional<assist::Text> ProjectTexts::kept_of(const std::string& path) const {
  if (!path.ends_with(".cdl")) return std::nullopt;
  const std::optional<documents::Drafts::Draft> draft = desk_.drafts().find(path);
  return draft ? text_of(desk_.project().disk_path(path), draft->text) : std::nullopt;
}

std::vector<assist::Text> ProjectTexts::all() {
  std::vector<assist::Text> out;
  std::set<std::string> open;
  for (const OpenConfiguration* one : desk_.all()) {
    if (!one->is_writable) continue;
    out.push_back({one->model->source(), assist::Language::kConfiguration});
    open.insert(one->path);
  }
  std::vector<std::string> paths;
  is_cut_ = false;
  if (!desk_.project().folder().empty()) find("", 0, paths);
  for (const std::string& path : paths) {
    if (open.contains(path)) continue;
    std::optional<assist::Text> text = kept_of(path);
    if (!text) text = file(path).text;
    if (text) out.push_back(std::move(*text));
  }
  const std::set<std::string> there(paths.begin(), paths.end());
  std::erase_if(files_, [&](const auto& one) { return !there.contains(one.first); });
  return out;
}

assist::Surroundings ProjectTexts::surroundings() {
  assist::Surroundings out = desk_.surroundings();
  out.project = [this] { return all(); };
  out.fixed = [this](const std::string& name) { return why_fixed(name); };
  return out;
}

std::string ProjectTexts::why_fixed(const std::string& source_name) const {
  const std::string path = desk_.document_of(source_name);
  if (const OpenConfiguration* one = desk_.find(path)) return one->is_writable ? "" : "is read only";
  if (path.empty() || path.find(':') != std::string::npos) return "is not in the project";
  if (::access(desk_.project().disk_path(path).c_str(), W_OK) != 0) return "is read only";
  if (drafts_.find(path)) return "has unsaved changes in the console";
  return "";
}

}  // namespace mlab::designer
