#include "mlab/cli/files.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include <fmt/format.h>

#include "mlab/cli/places.h"
#include "mlab/cli/version.h"

namespace mlab::cli {
namespace fs = std::filesystem;

robot_build::Toolchain toolchain() {
  robot_build::Toolchain out;
  out.include_root = include_root();
  out.version = kVersion;
  std::error_code error;
  const fs::path list = fs::path(prefix()) / "share" / "mlab" / "robot_link.txt";
  if (fs::exists(list, error)) out.link_file = list.string();
  return out;
}

assist::Surroundings surroundings(const cell::Permission& permission) {
  assist::Surroundings out;
  out.overlay_folders = overlay_folders();
  out.programs = program_sources("", permission);
  return out;
}

std::string web_folder() {
  return (fs::path(prefix()) / "share" / "mlab" / "web").string();
}

std::string why_web_is_missing() {
  // The launcher leaves it where it could not build the page of these sources; an older page is then no help.
  const fs::path told = fs::path(prefix()) / "share" / "mlab" / "web_missing.txt";
  std::ifstream file(told, std::ios::binary);
  if (file) return (std::ostringstream() << file.rdbuf()).str();
  std::error_code error;
  if (fs::exists(fs::path(web_folder()) / "index.html", error)) return "";
  return fmt::format("this mlab was built or installed without it: there is no {}\n", web_folder());
}

std::string example_folder() {
  std::error_code error;
  for (const fs::path& folder : {fs::path(prefix()) / "share" / "mlab" / "missions",
                                 fs::path(MLAB_SOURCE_INCLUDE).parent_path() / "missions"}) {
    if (fs::is_directory(folder, error)) return folder.string();
  }
  return "";
}

std::string library_folder() {
  std::error_code error;
  for (const fs::path& folder : {fs::path(prefix()) / "share" / "mlab" / "library",
                                 fs::path(MLAB_SOURCE_INCLUDE).parent_path() / "library"}) {
    if (fs::is_directory(folder, error)) return folder.string();
  }
  return "";
}

}  // namespace mlab::cli
