#include "mlab/designer/drawing/titles.h"

#include <algorithm>
#include <cstddef>

#include "mlab/text/shown.h"

namespace mlab::designer {

std::string unsaved_title(std::string_view text) {
  constexpr std::string_view kImported = "// From `";
  constexpr std::string_view kNothing = "New configuration";
  constexpr std::size_t kMost = 3;  // names in a title
  if (text.starts_with(kImported)) {
    std::string_view path = text.substr(kImported.size());
    path = path.substr(0, path.find_first_of("`\r\n"));
    const std::string_view name = path.substr(path.rfind('/') + 1);
    return name.empty() ? std::string(kNothing) : text::shown(name);
  }
  std::string out;
  std::size_t names = 0;
  for (std::size_t at = 0; at < text.size(); at = std::min(text.find('\n', at), text.size() - 1) + 1) {
    const std::string_view line = text.substr(at, text.find('\n', at) - at);
    for (const std::string_view kind : {"assemblage ", "robot ", "society "}) {
      if (!line.starts_with(kind)) continue;
      const std::string_view rest = line.substr(kind.size());
      const std::string_view name = rest.substr(0, rest.find_first_of(" (:{;\r"));
      if (++names <= kMost) out += (out.empty() ? "" : ", ") + text::shown(name);
    }
  }
  if (names == 0) return std::string(kNothing);
  return names > kMost ? out + " …" : out;
}

std::string said_of(std::string_view text) {
  constexpr std::size_t kMost = 140;  // bytes
  constexpr std::string_view kWhite = " \t\r";
  std::string all;
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    line.remove_prefix(std::min(line.size(), line.find_first_not_of(kWhite)));
    if (line.empty() && all.empty()) continue;
    if (!line.starts_with("//")) break;
    line.remove_prefix(std::min(line.size(), line.find_first_not_of('/')));
    line.remove_prefix(std::min(line.size(), line.find_first_not_of(kWhite)));
    line = line.substr(0, line.find_last_not_of(kWhite) + 1);
    if (line.empty() && !all.empty()) break;
    if (!all.empty()) all += ' ';
    all += line;
    if (all.size() > kMost || all.find(". ") != std::string::npos) break;
  }
  if (const std::size_t end = all.find(". "); end != std::string::npos) all.resize(end + 1);
  if (all.size() > kMost) {
    const std::size_t blank = all.rfind(' ', kMost);
    return text::shown(all.substr(0, blank == std::string::npos ? kMost : blank), kMost + 1) + " …";
  }
  return text::shown(all, kMost + 1);
}

}  // namespace mlab::designer
