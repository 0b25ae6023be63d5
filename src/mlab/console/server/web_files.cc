#include "mlab/console/server/web_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include <fmt/core.h>

namespace mlab::console {
namespace {

namespace fs = std::filesystem;

std::string content_type_of(const fs::path& file) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 14> kTypes = {{
      {".html", "text/html; charset=utf-8"},
      {".js", "text/javascript; charset=utf-8"},
      {".mjs", "text/javascript; charset=utf-8"},
      {".css", "text/css; charset=utf-8"},
      {".svg", "image/svg+xml"},
      {".png", "image/png"},
      {".jpg", "image/jpeg"},
      {".ico", "image/x-icon"},
      {".woff2", "font/woff2"},
      {".json", "application/json"},
      {".map", "application/json"},
      {".webmanifest", "application/manifest+json"},
      {".wasm", "application/wasm"},
      {".txt", "text/plain; charset=utf-8"},
  }};
  const std::string extension = file.extension().string();
  const auto* const it =
      std::ranges::find(kTypes, extension, &std::pair<std::string_view, std::string_view>::first);
  return std::string(it == kTypes.end() ? "application/octet-stream" : it->second);
}

// FNV-1a: tells versions of a file apart, no more.
std::string etag_of(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return fmt::format("\"{:x}-{:016x}\"", bytes.size(), hash);
}

}  // namespace

WebFiles WebFiles::read(const std::string& folder) {
  WebFiles out;
  std::error_code error;
  for (auto it = fs::recursive_directory_iterator(folder, error);
       !error && it != fs::recursive_directory_iterator(); it.increment(error)) {
    if (!it->is_regular_file(error)) continue;
    std::ifstream stream(it->path(), std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    const std::string path = "/" + it->path().lexically_relative(folder).generic_string();
    std::string etag = etag_of(bytes);
    out.files_[path] = {content_type_of(it->path()), std::make_shared<const std::string>(std::move(bytes)),
                        std::move(etag), path.starts_with("/assets/")};
  }
  return out;
}

const WebFiles::File* WebFiles::find(std::string_view path) const {
  const auto it = files_.find(path);
  return it == files_.end() ? nullptr : &it->second;
}

}  // namespace mlab::console
