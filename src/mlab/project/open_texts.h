#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/assist/service.h"
#include "mlab/documents/edit_log.h"
#include "mlab/documents/store.h"

namespace mlab::project {

/// The texts of a project that are open in a program, and what it does when they change: what has to be known
/// of console and designer to look for names in all files, and to change them.
class OpenTexts {
 public:
  OpenTexts() = default;
  OpenTexts(const OpenTexts&) = delete;
  OpenTexts& operator=(const OpenTexts&) = delete;
  virtual ~OpenTexts() = default;

  virtual documents::Store& store() = 0;
  /// What stands beside a text, but for the project's texts. Valid as long as this.
  virtual assist::Surroundings surroundings() = 0;
  /// People edit such files here, by the name of the file: what is kept of one that is not open is theirs.
  virtual bool is_edited_here(std::string_view path) const = 0;
  /// They can type into this one, which is open.
  virtual bool is_changeable(const documents::Document& document) const = 0;
  /// Folders besides the project's own that belong to what is open, by the names of ProjectFolder.
  virtual std::vector<std::string> folders_beside() const = 0;
  /// The history of all texts; null: each has its own.
  virtual std::shared_ptr<documents::EditLog> log() const = 0;

  /// Opens one of which there is unsaved work, with that.
  virtual text::Result<documents::Document*> open(const std::string& path, double now) = 0;
  /// Makes an edit, with all that follows from it.
  virtual void change(const std::vector<documents::Store::Change>& changes, const std::string& name,
                      double now) = 0;
  /// A file that is not open was written.
  virtual void wrote_file(const std::string& path) = 0;
  /// Where that fails it stays unsaved, which everybody sees.
  virtual void save(documents::Document& document) = 0;
  /// A sentence for people that comes up while something is undone.
  virtual void tell(const std::string& sentence) = 0;
};

}  // namespace mlab::project
