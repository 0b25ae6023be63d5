#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "mlab/documents/draft_keeper.h"
#include "mlab/documents/edit_log.h"
#include "mlab/text/source.h"

namespace mlab::documents {

/// What a document says, and how often that has changed.
class OpenText {
 public:
  explicit OpenText(text::SourcePtr source) : source_(std::move(source)) {}

  std::string_view text() const { return source_->text(); }
  /// Its name is the file's path on the machine. Another one with every change.
  const text::SourcePtr& source() const { return source_; }
  /// Grows with every change, undone ones as well.
  std::uint64_t revision() const { return revision_; }

  void set(std::string text) {
    source_ = std::make_shared<const text::Source>(source_->name(), std::move(text));
    ++revision_;
  }
  /// The same text of a file that is called otherwise.
  void rename(std::string name) {
    source_ = std::make_shared<const text::Source>(std::move(name), std::string(text()));
  }

 private:
  text::SourcePtr source_;
  std::uint64_t revision_ = 1;
};

/// A text that is open, whoever looks at it: what it says here, what its file says, and what is kept of it.
struct Document {
  /// What was seen of its file last.
  enum class Disk {
    kSame,     ///< as `saved`
    kChanged,  ///< somebody else has changed it, and there is something unsaved here: people have to decide
    kGone,
  };

  std::string path;  ///< as ProjectFolder names it
  OpenText text;
  std::optional<std::string> saved;  ///< as it stood on disk when both were one; nothing: it has no file yet
  Disk disk = Disk::kSame;
  std::string disk_text;         ///< where `disk` is kChanged: what stands there
  std::string disk_seen;         ///< digest of what the last look read, where that was news; else empty
  std::uint32_t taken_over = 0;  ///< how often its file's new text has been put in its place
  /// Digest of an older file, where the text comes from a draft of that one: what it had in common with this
  /// one is not known.
  std::string older_file;
  bool is_writable = true;
  /// Of nothing on disk (a trial, a text of the library): neither saved under its own name nor kept.
  bool is_detached = false;
  std::shared_ptr<EditLog> log;  ///< its own, or one of many documents; never null
  DraftState draft;

  Document(std::string its_path, text::SourcePtr source)
      : path(std::move(its_path)), text(std::move(source)), log(std::make_shared<EditLog>()) {}

  bool is_of_older_file() const { return !older_file.empty(); }
  /// What an undone edit leaves of a file that it had made.
  bool is_nothing() const { return !saved && text.text().empty(); }
  /// It says something else than its file did when both were one.
  bool is_changed_here() const { return saved ? *saved != text.text() : !text.text().empty(); }
  /// Something of it is nowhere on disk.
  bool is_dirty() const { return !is_detached && (is_changed_here() || (saved && disk == Disk::kGone)); }
};

using DocumentPtr = std::shared_ptr<Document>;

}  // namespace mlab::documents
