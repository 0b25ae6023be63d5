#pragma once

#include <cstdint>
#include <mutex>

#include "mlab/console/documents/documents.h"
#include "mlab/console/session.h"
#include "mlab/documents/project_folder.h"

namespace mlab::console {

/// The picture behind the map, for those who ask for it by the revision of the scene. `find` may be called
/// from any thread.
class MapPicture {
 public:
  /// Reads it anew where the scene is another one.
  void follow(const OpenDocuments& documents, const documents::ProjectFolder& project);
  Session::Picture find(std::uint64_t revision) const;

 private:
  mutable std::mutex mutex_;
  Session::Picture picture_;
  std::uint64_t revision_ = 0;
};

}  // namespace mlab::console
