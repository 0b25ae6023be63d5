#include "mlab/lang/cdl/syntax/help.h"

#include <algorithm>

#include <fmt/core.h>

namespace mlab::cdl {

std::string help_of(const std::vector<std::string_view>& comments) {
  std::string out;
  for (std::string_view line : comments) {
    line.remove_prefix(line.starts_with("///<") ? 4 : 3);
    line.remove_prefix(std::min(line.size(), line.find_first_not_of(" \t\r\n")));
    line = line.substr(0, line.find_last_not_of(" \t\r\n") + 1);
    if (line.empty() && !out.empty()) out += '\n';
    if (!out.empty() && !line.empty() && out.back() != '\n') out += ' ';
    out += line;
  }
  return out;
}

std::vector<std::string> help_lines(std::string_view help) {
  constexpr std::size_t kWidth = 110;
  std::vector<std::string> out;
  while (!help.empty()) {
    std::size_t end = help.find('\n');
    if (std::min(end, help.size()) > kWidth) end = help.rfind(' ', kWidth);
    if (end == std::string_view::npos && help.size() > kWidth) end = help.find_first_of(" \n", kWidth);
    const std::string_view line = help.substr(0, end);
    out.push_back(line.empty() ? "///" : fmt::format("/// {}", line));
    if (end == std::string_view::npos) break;
    const bool ends_paragraph = help[end] == '\n';
    help.remove_prefix(end + 1);
    if (ends_paragraph && !line.empty() && !help.empty()) out.emplace_back("///");
  }
  return out;
}

std::string help_behind(std::string help) {
  std::ranges::replace(help, '\n', ' ');
  std::ranges::replace(help, '\r', ' ');
  return "///< " + help;
}

}  // namespace mlab::cdl
