#include "mlab/console/session/map_picture.h"

#include <utility>

#include "mlab/overlay/picture.h"

namespace mlab::console {

void MapPicture::follow(const OpenDocuments& documents, const documents::ProjectFolder& project) {
  const std::uint64_t revision = documents.scene().revision();
  if (revision == revision_) return;
  Session::Picture picture;
  const auto& planned = documents.map()->map_picture;
  const auto name = planned ? project.name_of(planned->file) : std::nullopt;
  if (name) {
    if (auto bytes = project.read(*name)) {
      overlay::ShownPicture shown = overlay::shown_picture(std::move(*bytes));
      picture.content_type = std::move(shown.content_type);
      if (!picture.content_type.empty())
        picture.bytes = std::make_shared<const std::string>(std::move(shown.bytes));
    }
  }
  const std::scoped_lock lock(mutex_);
  revision_ = revision;
  picture_ = std::move(picture);
}

Session::Picture MapPicture::find(std::uint64_t revision) const {
  const std::scoped_lock lock(mutex_);
  return revision == revision_ ? picture_ : Session::Picture{};
}

}  // namespace mlab::console
