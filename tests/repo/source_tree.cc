#include "source_tree.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace mlab::repo {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> kSkipped = {"build", ".git",      "node_modules",
                                                      "dist",  "generated", "__pycache__"};

bool is_text(const std::string& text) {
  return text.find('\0') == std::string::npos;
}

}  // namespace

std::vector<std::string_view> File::lines() const {
  std::vector<std::string_view> lines;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    lines.push_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return lines;
}

Tree read_tree(const std::string& root) {
  Tree tree;
  for (fs::recursive_directory_iterator it(root), end; it != end; ++it) {
    if (std::ranges::count(kSkipped, it->path().filename().string()) > 0) {
      it.disable_recursion_pending();
      continue;
    }
    if (!it->is_regular_file() || it->is_symlink()) continue;
    std::ifstream in(it->path(), std::ios::binary);
    File file{fs::relative(it->path(), root).generic_string(), {std::istreambuf_iterator<char>(in), {}}};
    if (!is_text(file.text)) file.text.clear();
    tree.push_back(std::move(file));
  }
  std::ranges::sort(tree, {}, &File::path);
  return tree;
}

const File* find_file(const Tree& tree, std::string_view path) {
  const auto it = std::ranges::find(tree, path, &File::path);
  return it == tree.end() ? nullptr : &*it;
}

}  // namespace mlab::repo
