#include "mlab/text/files.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

namespace mlab::text {
namespace {

std::string read_beginning(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string out(1024, '\0');
  file.read(out.data(), static_cast<std::streamsize>(out.size()));
  out.resize(static_cast<std::size_t>(file.gcount()));
  return out;
}

}  // namespace

const Files& files_on_disk() {
  static const Files kDisk{[](const std::string& path) {
                             std::error_code unreadable;
                             return std::filesystem::is_regular_file(path, unreadable);
                           },
                           [](const std::string& path) { return read_source(path); }, read_beginning};
  return kDisk;
}

}  // namespace mlab::text
