#include "mlab/text/files.h"

#include <filesystem>
#include <system_error>

namespace mlab::text {

const Files& files_on_disk() {
  static const Files kDisk{[](const std::string& path) {
                             std::error_code unreadable;
                             return std::filesystem::is_regular_file(path, unreadable);
                           },
                           [](const std::string& path) { return read_source(path); }};
  return kDisk;
}

}  // namespace mlab::text
