#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "mlab/text/diagnostic.h"
#include "mlab/text/files.h"

namespace mlab::git {

/// One revision that touched a file.
struct Revision {
  std::string id;    ///< the whole hash
  std::string date;  ///< YYYY-MM-DD
  std::string author;
  std::string subject;  ///< of its message
  std::string path;     ///< of the file then, from the top of the repository
};

/// A file as a revision has it.
struct FileThen {
  std::string revision;  ///< as a person wrote it
  std::string id;        ///< the revision's whole hash
  std::string path;      ///< what the file was called then, from the top of the repository
};

/// A file in a working tree of git. Calls the program `git`; may be used from any thread. Errors are
/// `git`: sentences for a person, of a missing program, a file outside of any repository, an unknown
/// revision, a file that a revision doesn't have.
class TrackedFile {
 public:
  /// @param path  of a file, which need not be there any more; its folder has to be
  explicit TrackedFile(std::string path);

  /// What a person wrote (`HEAD~2`, `v1.0`, a branch, a hash) as a whole hash.
  text::Result<std::string> resolve(const std::string& revision) const;
  /// Where a revision has it, through renames. A file that it was copied from is another one.
  /// @param revision  as a person wrote it
  text::Result<FileThen> find(const std::string& revision) const;
  /// The text as it was, named `REVISION:PATH`, with its path of today.
  text::Result<text::SourcePtr> at(const FileThen& then) const;
  /// The last revisions that touched it, the newest first; through renames, up to where it was copied.
  text::Result<std::vector<Revision>> revisions(std::size_t most) const;
  /// Files that stood beside it, for texts that name others: their names begin with `REVISION:`.
  text::Files files_at(const FileThen& then) const;

 private:
  /// What stands in a revision at a path from the top of the repository.
  struct Entry {
    std::string mode;  ///< empty: nothing
    std::string blob;
  };
  text::Result<Entry> entry(const std::string& id, const std::string& path) const;
  text::Result<std::string> text_of(const std::string& id, const std::string& path) const;
  /// Where HEAD has it.
  struct InHead {
    std::string path;  ///< from the top of the repository
    std::string way;   ///< from the file's folder of today
  };
  InHead in_head() const;
  /// What it was called in a revision, from the top of the repository; empty: it can't be told.
  std::string former_name(const std::string& id) const;

  std::string path_;
  std::string folder_;
  std::string name_;
};

}  // namespace mlab::git
