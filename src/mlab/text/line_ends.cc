#include "mlab/text/line_ends.h"

#include <algorithm>
#include <cstddef>

namespace mlab::text {

bool has_dos_lines(std::string_view text) {
  bool has_line = false;
  for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1)) {
    if (at == 0 || text[at - 1] != '\r' || (at > 1 && text[at - 2] == '\r')) return false;
    has_line = true;
  }
  return has_line;
}

std::string unix_lines(std::string text) {
  if (!has_dos_lines(text)) return text;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
    text[kept++] = text[i];
  }
  text.resize(kept);
  return text;
}

std::string lines_as_in(std::string_view old, std::string text) {
  if (!has_dos_lines(old)) return text;
  std::string out;
  out.reserve(text.size() + static_cast<std::size_t>(std::ranges::count(text, '\n')));
  for (const char c : text) {
    if (c == '\n' && !out.ends_with('\r')) out += '\r';
    out += c;
  }
  return out;
}

}  // namespace mlab::text
