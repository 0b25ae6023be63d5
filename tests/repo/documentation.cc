#include "documentation.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace mlab::repo {
namespace {

bool is_fence(std::string_view line) {
  return line.starts_with("```");
}

/// Calls `visit(line number, line)` for the lines of a Markdown file that stand outside code blocks.
template <class Visit>
void for_each_prose_line(const File& file, Visit visit) {
  bool in_code = false;
  const auto lines = file.lines();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (is_fence(lines[i])) in_code = !in_code;
    if (!in_code && !is_fence(lines[i]) && !lines[i].starts_with("    ")) visit(i + 1, lines[i]);
  }
}

/// The anchor that a heading gets: `## The two commands` is `the-two-commands`.
std::string anchor_of(std::string_view heading) {
  heading.remove_prefix(std::min(heading.find_first_not_of("# "), heading.size()));
  std::string anchor;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (std::isalnum(byte) != 0 || c == '_' || c == '-') anchor += static_cast<char>(std::tolower(byte));
    if (c == ' ') anchor += '-';
  }
  return anchor;
}

bool has_anchor(const File& file, std::string_view anchor) {
  bool found = false;
  for_each_prose_line(file, [&](std::size_t, std::string_view line) {
    if (line.starts_with('#') && anchor_of(line) == anchor) found = true;
  });
  return found;
}

bool is_elsewhere(std::string_view target) {
  return target.find("://") != std::string_view::npos || target.starts_with("mailto:");
}

/// `line` without what stands between back quotes.
std::string without_code(std::string_view line) {
  std::string prose;
  bool in_code = false;
  for (const char c : line) {
    if (c == '`') in_code = !in_code;
    if (!in_code) prose += c;
  }
  return prose;
}

std::vector<std::string> link_targets(std::string_view line) {
  std::vector<std::string> targets;
  const std::string prose = without_code(line);
  for (std::size_t at = prose.find("]("); at != std::string::npos; at = prose.find("](", at + 1)) {
    const std::size_t end = prose.find(')', at);
    if (end != std::string::npos) targets.push_back(prose.substr(at + 2, end - at - 2));
  }
  return targets;
}

bool is_file_or_folder(const Tree& tree, const std::string& path) {
  if (path.empty() || path == ".") return true;
  return std::ranges::any_of(
      tree, [&](const File& file) { return file.path == path || file.path.starts_with(path + "/"); });
}

/// What is wrong with a link of `from`; empty where it leads somewhere.
std::string trouble_with(const Tree& tree, const File& from, const std::string& target) {
  const std::size_t hash = std::min(target.find('#'), target.size());
  const auto folder = std::filesystem::path(from.path).parent_path();
  std::string path =
      hash == 0 ? from.path : (folder / target.substr(0, hash)).lexically_normal().generic_string();
  if (path.ends_with('/')) path.pop_back();
  if (!is_file_or_folder(tree, path)) return "there is no `" + path + "`";
  if (hash == target.size()) return {};
  const File* file = find_file(tree, path);
  if (file != nullptr && has_anchor(*file, std::string_view(target).substr(hash + 1))) return {};
  return "`" + path + "` has no heading for `" + target.substr(hash) + "`";
}

std::size_t indentation(std::string_view line) {
  return std::min(line.find_first_not_of(' '), line.size());
}

/// The lines without the indentation that they share, each ended by a newline.
std::string unindented(const std::vector<std::string_view>& lines) {
  std::size_t shared = std::string_view::npos;
  for (const std::string_view line : lines) {
    if (indentation(line) < line.size()) shared = std::min(shared, indentation(line));
  }
  std::string text;
  for (std::string_view line : lines) {
    line.remove_prefix(std::min(shared, line.size()));
    text.append(line).push_back('\n');
  }
  return text;
}

/// True where `block` stands in the file as consecutive lines, at any depth of indentation.
bool contains_block(const File& file, const std::vector<std::string_view>& block) {
  const std::string wanted = unindented(block);
  const auto lines = file.lines();
  for (std::size_t first = 0; first + block.size() <= lines.size(); ++first) {
    const auto begin = lines.begin() + static_cast<std::ptrdiff_t>(first);
    if (unindented({begin, begin + static_cast<std::ptrdiff_t>(block.size())}) == wanted) return true;
  }
  return false;
}

/// The path in `<!-- from PATH -->`; empty on every other line.
std::string origin_of(std::string_view line) {
  constexpr std::string_view kOpen = "<!-- from ";
  constexpr std::string_view kClose = " -->";
  if (!line.starts_with(kOpen) || !line.ends_with(kClose)) return {};
  return std::string(line.substr(kOpen.size(), line.size() - kOpen.size() - kClose.size()));
}

}  // namespace

Findings dead_links(const Tree& tree) {
  Findings findings;
  for (const File& file : tree) {
    if (!file.ends_with(".md")) continue;
    for_each_prose_line(file, [&](std::size_t number, std::string_view line) {
      for (const std::string& target : link_targets(line)) {
        const std::string trouble = is_elsewhere(target) ? std::string{} : trouble_with(tree, file, target);
        if (!trouble.empty()) findings.push_back({file.path, number, trouble});
      }
    });
  }
  return findings;
}

Findings stale_examples(const Tree& tree) {
  Findings findings;
  for (const File& file : tree) {
    if (!file.ends_with(".md")) continue;
    const auto lines = file.lines();
    for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
      const std::string path = origin_of(lines[i]);
      if (path.empty() || !is_fence(lines[i + 1])) continue;
      std::vector<std::string_view> block;
      for (std::size_t j = i + 2; j < lines.size() && !is_fence(lines[j]); ++j) block.push_back(lines[j]);
      const File* origin = find_file(tree, path);
      if (origin == nullptr) {
        findings.push_back({file.path, i + 1, "there is no `" + path + "`"});
      } else if (block.empty() || !contains_block(*origin, block)) {
        findings.push_back({file.path, i + 1, "the example does not stand in `" + path + "` as it is shown"});
      }
    }
  }
  return findings;
}

}  // namespace mlab::repo
