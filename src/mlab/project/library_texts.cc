#include "mlab/project/library_texts.h"

#include <algorithm>

#include "mlab/library/library.h"

namespace mlab::project {
namespace {

constexpr std::string_view kFolder = "library/";

}  // namespace

std::string library_source_name(std::string_view path) {
  return std::string(kFolder) + std::string(path.substr(kLibrary.size()));
}

std::optional<std::string_view> library_text(std::string_view path) {
  if (!path.starts_with(kLibrary)) return std::nullopt;
  const auto texts = library::configuration_texts();
  const auto found = std::ranges::find(texts, library_source_name(path), &library::ConfigurationText::file);
  return found == texts.end() ? std::nullopt : std::optional(found->text);
}

std::string library_path(std::string_view source_name) {
  if (!source_name.starts_with(kFolder)) return "";
  std::string path = std::string(kLibrary) + std::string(source_name.substr(kFolder.size()));
  return library_text(path) ? path : "";
}

}  // namespace mlab::project
