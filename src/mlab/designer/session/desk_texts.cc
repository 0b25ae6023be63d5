#include "mlab/designer/session/desk_texts.h"

namespace mlab::designer {

bool is_configuration(std::string_view path) {
  return path.ends_with(".cdl") || Desk::is_new(path);
}

text::Result<documents::Document*> DeskTexts::open(const std::string& path, double now) {
  const text::Result<OpenConfiguration*> opened = desk_.open(path, now);
  if (!opened) return std::unexpected(opened.error());
  return *opened;
}

void DeskTexts::change(const std::vector<documents::Store::Change>& changes, const std::string& name,
                       double now) {
  // Each has a history of its own.
  for (const documents::Store::Change& change : changes) desk_.store().change({change}, name, now, false);
}

void DeskTexts::save(documents::Document& document) {
  Save request;
  request.set_document(document.path);
  [[maybe_unused]] const text::Result<std::string> saved = desk_.save(*desk_.find(document.path), request);
}

}  // namespace mlab::designer
