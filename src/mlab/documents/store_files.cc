// What readers of languages see of a project: open texts above files.

#include <filesystem>
#include <map>
#include <utility>

#include <fmt/core.h>

#include "mlab/documents/refused.h"
#include "mlab/documents/store.h"

namespace mlab::documents {
namespace {

std::string lexically_normal(const std::string& path) {
  std::error_code odd;
  return std::filesystem::absolute(path, odd).lexically_normal().string();
}

text::Result<text::SourcePtr> read_of_project(const ProjectFolder& project, const std::string& path) {
  const std::optional<std::string> name = project.name_of(path);
  if (!name) return refused("cannot-read", fmt::format("{} is not in the project folder", shown(path)));
  text::Result<std::string> content = project.read(*name);
  if (!content) return std::unexpected(content.error());
  return std::make_shared<const text::Source>(path, std::move(*content));
}

}  // namespace

text::Files with_texts(const std::vector<text::SourcePtr>& texts, const text::Files& under,
                       std::string (*normal)(const std::string& path)) {
  const auto by_name = std::make_shared<std::map<std::string, text::SourcePtr>>();
  for (const text::SourcePtr& one : texts) by_name->try_emplace(normal(one->name()), one);
  const auto open = [by_name, normal](const std::string& path) -> text::SourcePtr {
    const auto found = by_name->find(normal(path));
    return found == by_name->end() ? nullptr : found->second;
  };
  text::Files out = under;
  out.is_file = [open, below = under.is_file](const std::string& path) {
    return open(path) != nullptr || below(path);
  };
  out.read = [open, below = under.read](const std::string& path) -> text::Result<text::SourcePtr> {
    if (text::SourcePtr source = open(path)) return source;
    return below(path);
  };
  return out;
}

text::Files Store::files() {
  return {[this](const std::string& path) {
            const auto name = project_.name_of(path);
            if (!name || find(*name) != nullptr || project_.is_file(*name)) return name.has_value();
            return drafts_.find(*name).has_value();
          },
          [this](const std::string& path) -> text::Result<text::SourcePtr> {
            const auto name = project_.name_of(path);
            const Document* document = name ? find(*name) : nullptr;
            if (document != nullptr) return document->text.source();
            return read_of_project(project_, path);
          },
          [this](const std::string& path) {
            const auto name = project_.name_of(path);
            return name ? project_.beginning(*name) : std::string();
          }};
}

std::shared_ptr<const text::Files> Store::snapshot(const std::vector<text::SourcePtr>& more) const {
  std::vector<text::SourcePtr> texts = more;
  for (const DocumentPtr& one : open_) {
    const bool has_place = std::filesystem::path(one->text.source()->name()).is_absolute();
    if (has_place) texts.push_back(one->text.source());
  }
  text::Files under;
  under.is_file = [project = project_](const std::string& path) {
    const auto name = project.name_of(path);
    return name && project.is_file(*name);
  };
  under.read = [project = project_](const std::string& path) { return read_of_project(project, path); };
  return std::make_shared<const text::Files>(with_texts(texts, under, lexically_normal));
}

}  // namespace mlab::documents
