#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace mlab::repo {

/// One file of the project; pictures and the like are there, without a text.
struct File {
  std::string path;  ///< from the root of the project, with `/`
  std::string text;

  std::vector<std::string_view> lines() const;
  bool ends_with(std::string_view suffix) const { return path.ends_with(suffix); }
  bool is_cpp() const { return ends_with(".h") || ends_with(".cc"); }
};

/// The files of the project, or of a small tree that a test makes up; sorted by path.
using Tree = std::vector<File>;

/// Reads the tree below `root` without what builds and tools leave there.
Tree read_tree(const std::string& root);

/// Null where the tree has no such file.
const File* find_file(const Tree& tree, std::string_view path);

/// A rule that the tree does not keep.
struct Finding {
  std::string path;
  std::size_t line = 1;  ///< counted from 1
  std::string message;

  friend bool operator==(const Finding&, const Finding&) = default;
  friend std::ostream& operator<<(std::ostream& out, const Finding& f) {
    return out << '\n' << f.path << ':' << f.line << ": " << f.message;
  }
};
using Findings = std::vector<Finding>;

}  // namespace mlab::repo
