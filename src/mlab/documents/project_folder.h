#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/text/diagnostic.h"

namespace mlab::documents {

/// How names begin of files of the examples, and of files outside of the project.
inline constexpr std::string_view kExampleFiles = "examples:";
inline constexpr std::string_view kOutsideFiles = "outside:";

/// The files that a console may touch, by the names that the browser knows them by.
///
/// - `scouts/left.mdl`: inside the project folder, read and written;
/// - `examples:demo_c/demo_c.mdl`: of the examples, read only;
/// - `outside:/maps/town.odl`: read only, and only files that `allow_outside` named. They are what a
/// mission
///   given on the command line names, found as `mdl` finds them (beside it, in the current folder, in the
///   folders for overlays). Nothing that a browser sends makes another file of the machine readable.
///
/// A name is walked folder by folder without following any symbolic link, so neither `..` nor absolute names,
/// nor links, nor folders that change meanwhile lead out. Only regular files are read and written.
class ProjectFolder {
 public:
  struct Settings {
    std::string folder;    ///< the project; empty: there is none, nothing can be written
    std::string examples;  ///< empty: none
    /// Extensions of the files that may be written, in small letters, and how people call these.
    std::vector<std::string> writable = {".mdl", ".odl", ".ovl"};
    std::string writable_kinds = "missions (.mdl) and overlays (.odl, .ovl)";
  };
  struct Entry {
    std::string path;  ///< as above
    bool is_folder = false;
    std::string kind;  ///< mission, overlay, picture, other; empty for folders
  };

  explicit ProjectFolder(const Settings& settings);

  /// As people call it: the last part of the folder's path.
  std::string name() const;
  /// Where it is on the machine, without symbolic links; empty: there is none.
  const std::string& folder() const { return project_; }
  /// The files of a folder, folders first, then by name; hidden ones are left out. Empty: the project's own.
  /// @errors `cannot-read`
  text::Result<std::vector<Entry>> list(std::string_view folder) const;
  /// The files below the project folder, or of the examples (`examples:`), that end so: those of folders
  /// first. At most kMaxFound, within kMaxDepth folders.
  std::vector<std::string> files(std::string_view folder, std::string_view ending) const;

  bool is_file(std::string_view path) const;
  bool is_writable(std::string_view path) const;
  /// @errors `cannot-read`, `file-too-large`
  text::Result<std::string> read(std::string_view path) const;
  /// How the file begins, a few kilobytes; empty where it can't be read.
  std::string beginning(std::string_view path) const;
  /// Writes a file as a whole or not at all: beside it, then in its place. Folders that miss are made.
  /// @errors `cannot-write`
  text::Result<bool> write(std::string_view path, std::string_view text) const;

  /// Lets a file outside of the project be read.
  void allow_outside(const std::string& disk_path);
  /// The name of a file that stands at this path of the machine; nothing where it may not be touched. The
  /// path need not exist; a relative one counts from the current folder.
  std::optional<std::string> name_of(const std::string& disk_path) const;
  /// Where a file stands on the machine; empty where the name is none.
  std::string disk_path(std::string_view path) const;

  static constexpr std::size_t kMaxFound = 500;
  static constexpr int kMaxDepth = 6;
  static constexpr std::size_t kMostEntries = 5000;  ///< of a folder that are looked at

 private:
  struct Location {
    std::string root;                ///< folder on the machine
    std::vector<std::string> parts;  ///< below it, at least one
  };
  std::optional<Location> locate(std::string_view path) const;
  void find(std::string_view folder, std::string_view ending, int depth, std::vector<std::string>& out) const;

  std::string project_;   // without symbolic links
  std::string examples_;  // the same
  std::vector<std::string> writable_;
  std::string writable_kinds_;
  std::vector<std::string> outside_;
};

}  // namespace mlab::documents
