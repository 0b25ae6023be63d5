#include "mlab/console/documents/document_texts.h"

namespace mlab::console {

assist::Surroundings DocumentTexts::surroundings() {
  assist::Surroundings out;
  out.files = documents_.load_options().files;
  out.overlay_folders = documents_.load_options().overlay_folders;
  out.checks_code = false;
  return out;
}

bool DocumentTexts::is_edited_here(std::string_view path) const {
  return path.ends_with(".mdl") || path.ends_with(".odl") || path.ends_with(".ovl");
}

std::vector<std::string> DocumentTexts::folders_beside() const {
  const std::string path = documents_.mission_path();
  const std::size_t slash = path.rfind('/');
  if (!path.starts_with("examples:") || slash == std::string::npos) return {};
  return {path.substr(0, slash)};
}

void DocumentTexts::save(documents::Document& document) {
  SaveDocuments request;
  request.add_documents(document.path);
  [[maybe_unused]] const text::Result<bool> saved = documents_.save(request);
}

}  // namespace mlab::console
