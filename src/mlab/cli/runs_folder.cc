#include "mlab/cli/runs_folder.h"

#include <filesystem>

#include "mlab/cli/places.h"
#include "mlab/documents/state_folder.h"

namespace mlab::cli {

std::string runs_folder(const std::string& project) {
  const std::string folder = documents::StateFolder(state_folder(), project).path();
  return folder.empty() ? "" : (std::filesystem::path(folder) / "runs").string();
}

}  // namespace mlab::cli
