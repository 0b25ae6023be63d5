#include "mlab/project/project_texts.h"

#include <unistd.h>

#include <set>
#include <system_error>

#include <fmt/core.h>

#include "mlab/documents/refused.h"
#include "mlab/project/library_texts.h"

namespace mlab::project {
namespace {

bool is_in_a_language(std::string_view path) {
  return path.ends_with(".cdl") || path.ends_with(".cnl") || path.ends_with(".mdl") ||
         path.ends_with(".odl") || path.ends_with(".ovl");
}

std::optional<assist::Text> text_of(const std::string& name, std::string content) {
  auto source = std::make_shared<const text::Source>(name, std::move(content));
  const auto language = assist::language_of(*source);
  if (!language) return std::nullopt;
  return assist::Text{std::move(source), *language};
}

assist::Text text_of(const documents::Document& document) {
  const text::SourcePtr& source = document.text.source();
  return {source, assist::language_of(*source).value_or(assist::Language::kConfiguration)};
}

}  // namespace

void ProjectTexts::find(const std::string& folder, int depth, std::vector<std::string>& out) {
  const auto entries = open_.store().project().list(folder);
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
  const std::string disk_path = open_.store().project().disk_path(path);
  std::error_code missing;
  const auto time = std::filesystem::last_write_time(disk_path, missing);
  const std::uintmax_t size = missing ? 0 : std::filesystem::file_size(disk_path, missing);
  const auto known = files_.find(path);
  if (known != files_.end() && known->second.time == time && known->second.size == size) return known->second;
  File& out = files_[path];
  out = {time, size, std::nullopt};
  if (text::Result<std::string> content = open_.store().project().read(path))
    out.text = text_of(disk_path, std::move(*content));
  return out;
}

// Unsaved work on a text that is not open just now.
std::optional<assist::Text> ProjectTexts::kept_of(const std::string& path) const {
  if (!open_.is_edited_here(path)) return std::nullopt;
  const std::optional<documents::Drafts::Draft> draft = open_.store().drafts().find(path);
  return draft ? text_of(open_.store().project().disk_path(path), draft->text) : std::nullopt;
}

std::vector<assist::Text> ProjectTexts::all() {
  std::vector<assist::Text> out;
  std::set<std::string> open;
  for (const documents::DocumentPtr& one : open_.store().all()) {
    if (!open_.is_changeable(*one)) continue;
    out.push_back(text_of(*one));
    open.insert(one->path);
  }
  std::vector<std::string> paths;
  is_cut_ = false;
  if (!open_.store().project().folder().empty()) find("", 0, paths);
  for (const std::string& folder : open_.folders_beside()) find(folder, 0, paths);
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

text::Result<assist::Text> ProjectTexts::read(const std::string& path) {
  if (const documents::Document* document = open_.store().find(path)) return text_of(*document);
  if (const auto library = library_text(path))
    return *text_of(library_source_name(path), std::string(*library));
  if (!is_in_a_language(path))
    return documents::refused(
        "no-language",
        fmt::format("{} is no mission, overlay, configuration or network", documents::shown(path)));
  if (auto kept = kept_of(path)) return *kept;
  text::Result<std::string> content = open_.store().project().read(path);
  if (!content) return std::unexpected(content.error());
  return *text_of(open_.store().project().disk_path(path), std::move(*content));
}

assist::Surroundings ProjectTexts::surroundings() {
  assist::Surroundings out = open_.surroundings();
  out.project = [this] { return all(); };
  out.fixed = [this](const std::string& name) { return why_fixed(name); };
  return out;
}

std::string ProjectTexts::path_of(std::string_view source_name) const {
  if (std::string library = library_path(source_name); !library.empty()) return library;
  for (const documents::DocumentPtr& one : open_.store().all()) {
    if (one->text.source()->name() == source_name) return one->path;
  }
  return open_.store().project().name_of(std::string(source_name)).value_or("");
}

std::string ProjectTexts::why_fixed(const std::string& source_name) const {
  const std::string path = path_of(source_name);
  if (const documents::Document* document = open_.store().find(path))
    return open_.is_changeable(*document) ? "" : "is read only";
  if (path.empty() || path.find(':') != std::string::npos) return "is not in the project";
  if (::access(open_.store().project().disk_path(path).c_str(), W_OK) != 0) return "is read only";
  if (elsewhere_.drafts.find(path)) return fmt::format("has unsaved changes {}", elsewhere_.where);
  return "";
}

}  // namespace mlab::project
