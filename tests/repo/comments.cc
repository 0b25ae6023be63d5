#include "comments.h"

namespace mlab::repo {
namespace {

constexpr std::string_view kSlashes = "///";
constexpr std::string_view kMark = "@param";
constexpr std::string_view kBlanks = " \t";

bool is_of_name(char c) {
  return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::string_view without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  return first == std::string_view::npos ? std::string_view{} : text.substr(first);
}

/// Above a declaration; what stands behind a field is something else.
bool is_doc_comment(std::string_view line) {
  line = without_blanks(line);
  return line.starts_with(kSlashes) && !line.starts_with("///<");
}

/// `a` and `b` in `/// @param a, b  what they are`.
std::vector<std::string_view> described(std::string_view line) {
  std::vector<std::string_view> names;
  line = without_blanks(without_blanks(line).substr(kSlashes.size()));
  if (!line.starts_with(kMark)) return names;
  line.remove_prefix(kMark.size());
  do {
    line = without_blanks(line.substr(line.starts_with(',') ? 1 : 0));
    std::size_t length = 0;
    while (length < line.size() && is_of_name(line[length])) ++length;
    names.push_back(line.substr(0, length));
    line.remove_prefix(length);
  } while (line.starts_with(','));
  return names;
}

/// From line `first` to the `;` or `{` that stands outside of all brackets.
std::string declaration_at(const std::vector<std::string_view>& lines, std::size_t first) {
  std::string out;
  int depth = 0;
  for (std::size_t i = first; i < lines.size(); ++i) {
    const std::string_view code = lines[i].substr(0, lines[i].find("//"));
    for (const char c : code) {
      out += c;
      if (c == '(' || c == '[') ++depth;
      if (c == ')' || c == ']') --depth;
      if (depth <= 0 && (c == ';' || c == '{')) return out;
    }
    out += '\n';
  }
  return out;
}

bool has_word(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !is_of_name(text[at - 1])) && (end == text.size() || !is_of_name(text[end]))) return true;
  }
  return false;
}

}  // namespace

Findings stray_parameters(const Tree& tree) {
  Findings findings;
  for (const File& file : tree) {
    if (!file.is_cpp()) continue;
    const auto lines = file.lines();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (!is_doc_comment(lines[i])) continue;
      const std::size_t first = i;
      while (i < lines.size() && is_doc_comment(lines[i])) ++i;
      const std::string declaration = declaration_at(lines, i);
      for (std::size_t line = first; line < i; ++line) {
        for (const std::string_view name : described(lines[line])) {
          if (!name.empty() && has_word(declaration, name)) continue;
          findings.push_back(
              {file.path, line + 1,
               "`@param " + std::string(name) + "`: the declaration below has nothing of that name"});
        }
      }
    }
  }
  return findings;
}

}  // namespace mlab::repo
