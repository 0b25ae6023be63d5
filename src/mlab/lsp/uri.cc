#include "mlab/lsp/uri.h"

#include <cctype>
#include <cstddef>
#include <filesystem>
#include <system_error>

#include <fmt/core.h>

namespace mlab::lsp {
namespace {

constexpr std::string_view kFile = "file://";

int hex(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

}  // namespace

std::string path_of(std::string_view uri) {
  if (!uri.starts_with(kFile)) return std::string(uri);
  uri.remove_prefix(kFile.size());
  const std::size_t slash = uri.find('/');  // behind the host
  if (slash == std::string_view::npos) return std::string(uri);
  uri.remove_prefix(slash);
  std::string out;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool is_escape =
        uri[i] == '%' && i + 2 < uri.size() && hex(uri[i + 1]) >= 0 && hex(uri[i + 2]) >= 0;
    if (!is_escape) {
      out += uri[i];
      continue;
    }
    out += static_cast<char>(hex(uri[i + 1]) * 16 + hex(uri[i + 2]));
    i += 2;
  }
  return out;
}

std::string uri_of(const std::string& path) {
  const bool is_uri = path.find(':') != std::string::npos && path.find(':') < path.find('/');
  if (is_uri) return path;
  std::error_code failure;
  const std::string absolute = std::filesystem::absolute(path, failure).lexically_normal().string();
  std::string out(kFile);
  for (const char c : failure ? path : absolute) {
    const bool is_plain =
        std::isalnum(static_cast<unsigned char>(c)) != 0 || std::string_view("-._~/").contains(c);
    out += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return out;
}

}  // namespace mlab::lsp
