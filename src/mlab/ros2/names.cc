#include "mlab/ros2/names.h"

#include <algorithm>

#include <fmt/format.h>

#include "mlab/text/shown.h"

namespace mlab::ros2 {
namespace {

constexpr std::size_t kLongestFullName = 200;

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool is_word(std::string_view word) {
  return !word.empty() && is_letter(word[0]) && !word.contains("__") &&
         std::ranges::all_of(word, [](char c) { return is_letter(c) || is_digit(c); });
}

/// What is wrong with a name in full; empty: nothing.
std::string name_problem(std::string_view name) {
  if (name.size() > kLongestFullName)
    return fmt::format("has {} characters: {} at most", name.size(), kLongestFullName);
  for (std::string_view rest = name.substr(1);;) {
    const std::size_t slash = rest.find('/');
    const std::string_view word = rest.substr(0, slash);
    if (!is_word(word))
      return fmt::format(
          "has `{}` in it: words of letters, digits and single `_`, with no digit before, and "
          "`/` between them",
          text::shown(word));
    if (slash == std::string_view::npos) return "";
    rest = rest.substr(slash + 1);
  }
}

}  // namespace

std::expected<std::string, std::string> namespace_of(std::string_view written) {
  while (written.ends_with('/')) written.remove_suffix(1);
  if (written.empty()) return "";
  std::string out = written.starts_with('/') ? std::string(written) : fmt::format("/{}", written);
  if (const std::string problem = name_problem(out); !problem.empty())
    return std::unexpected(fmt::format("the namespace `{}` {}", text::shown(written), problem));
  return out;
}

std::expected<std::string, std::string> full_name(std::string_view robot_namespace, std::string_view name) {
  std::string out = name.starts_with('/') ? std::string(name) : fmt::format("{}/{}", robot_namespace, name);
  if (const std::string problem = name_problem(out); !problem.empty())
    return std::unexpected(fmt::format("the name `{}` {}", text::shown(name), problem));
  return out;
}

}  // namespace mlab::ros2
