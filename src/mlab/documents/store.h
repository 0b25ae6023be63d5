#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/documents/document.h"
#include "mlab/documents/draft_keeper.h"
#include "mlab/documents/drafts.h"
#include "mlab/documents/project_folder.h"
#include "mlab/text/diagnostic.h"
#include "mlab/text/files.h"
#include "mlab/text/splice.h"

namespace mlab::documents {

/// The texts of one project that are open, and the files behind them. What is typed is never lost: a change
/// can be undone, is kept as a draft, and no file is written over that somebody else has changed meanwhile.
///
/// Has no thread; times are seconds of any clock that does not go back. Functions that return a Result change
/// nothing where they fail; the message is a sentence for a person.
class Store {
 public:
  /// @param project       outlives this
  /// @param state_folder  where drafts are kept; empty: they are not
  Store(ProjectFolder& project, const std::string& state_folder);

  ProjectFolder& project() { return project_; }
  const ProjectFolder& project() const { return project_; }
  Drafts& drafts() { return drafts_; }
  const Drafts& drafts() const { return drafts_; }

  // ---- what is open

  /// Null where it is not open.
  Document* find(std::string_view path) const;
  /// In the order in which they were opened.
  const std::vector<DocumentPtr>& all() const { return open_; }
  Document& add(DocumentPtr document);
  void close(std::string_view path);
  /// @return  what was open
  std::vector<DocumentPtr> close_all() { return std::exchange(open_, {}); }
  /// A file as it is worked with: in UTF-8, and with LF where every line of it ends in CR LF.
  /// @errors as ProjectFolder::read
  text::Result<std::string> read(const std::string& path) const;
  /// What was not saved comes back as the first change of all, so that undoing gives what stands on disk.
  enum class Restored {
    kNothing,
    kText,
    kTextOfOlderFile,  ///< the file has changed since
    kTextOfGoneFile,   ///< there is none any more
  };
  Restored restore_draft(Document& document, double now);
  /// Paths of what there is as drafts only: never saved, or its file is gone.
  std::vector<std::string> only_kept() const;

  // ---- changes

  struct Change {
    Document* document = nullptr;
    text::Splice splice;  ///< of the text as those before it leave it
  };
  /// Makes them, and enters them into the documents' log as one. The documents have the same one.
  /// @param merges  with those of the same name right before and after it
  void change(const std::vector<Change>& changes, std::string name, double now, bool merges = true);
  /// The document is to say that.
  void change(Document& document, std::string_view text, std::string name, double now, bool merges = true);

  // ---- files

  /// @param overwrites  also what somebody else has written there meanwhile
  /// @errors `read-only`, `file-exists`, `changed-on-disk` (Document::disk says so, too), `cannot-write`
  text::Result<bool> save(Document& document, bool overwrites = false);
  /// Under another name, which it has from then on. Under its own: as `save`.
  /// @param overwrites  what stands there
  /// @errors `file-exists` (there, or open), `cannot-write`
  text::Result<bool> save_as(Document& document, const std::string& path, bool overwrites = false);
  /// Takes what is on disk: in place of the text, or together with what was changed here.
  /// @errors `cannot-read`; `conflict`: both changed the same lines
  text::Result<bool> reload(Document& document, bool merge, double now);
  /// Looks at all files. What was changed there is taken over where nothing is unsaved here, as soon as two
  /// looks have read the same: who writes a file may be in the middle of it.
  enum class News {
    kGone,
    kTakenOver,
    kChanged,    ///< people have to decide
    kSameAgain,  ///< there is nothing to decide any more, or nothing unsaved
  };
  struct Seen {
    Document* document = nullptr;
    News news = News::kGone;
  };
  /// @return  what is new since the last look
  std::vector<Seen> look_at_disk(double now);

  // ---- drafts

  /// Writes drafts of what is not saved, so that what ends this process takes nothing. To be called after
  /// changes, before they are answered, and now and then: what could not be written is tried again after a
  /// second.
  void keep_drafts(double now, DraftKeeper::When when = DraftKeeper::When::kNowAndThen);
  void keep_draft(Document& document, double now, DraftKeeper::When when);
  /// Waits until they are on the disk.
  void sync_drafts(double now);
  struct Loss {
    const Document* document = nullptr;
    std::string why;
  };
  /// What would be lost with this process.
  std::vector<Loss> losses() const;
  /// Why no draft at all could be kept; empty: one could.
  const std::string& folder_problem() const { return keeper_.folder_problem(); }

  // ---- for readers

  /// The open texts, and under them the files of the project. Valid as long as this.
  text::Files files();
  /// The same for other threads, as it is now.
  /// @param more  texts besides, above those; their names are paths of the machine
  std::shared_ptr<const text::Files> snapshot(const std::vector<text::SourcePtr>& more = {}) const;

 private:
  text::Result<bool> write(Document& document, const std::string& path);
  static bool has_settled(Document& document, const std::string& content);
  std::optional<News> look_at_file(Document& document, double now);

  ProjectFolder& project_;
  Drafts drafts_;
  DraftKeeper keeper_;
  std::vector<DocumentPtr> open_;
};

/// How a text is asked for by paths of the machine, above other files: `texts` are found by their names.
/// @param normal  what of a path says whether it is the same
text::Files with_texts(const std::vector<text::SourcePtr>& texts, const text::Files& under,
                       std::string (*normal)(const std::string& path));

}  // namespace mlab::documents
