#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/console.pb.h"
#include "mlab/console/documents/completion.h"
#include "mlab/console/documents/overlay_edit.h"
#include "mlab/console/published/scene_encoder.h"
#include "mlab/console/trial.h"
#include "mlab/documents/edit_log.h"
#include "mlab/documents/project_folder.h"
#include "mlab/documents/store.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/mission/mission.h"
#include "mlab/overlay/overlay.h"
#include "mlab/text/diagnostic.h"

namespace mlab::console {

using OpenDocument = documents::Document;

/// The mission that is open: its file and all overlays that it names, as texts, and what they mean. Every
/// edit is a change of these texts (what comes from the map, too), can be undone, and is followed by a check
/// of everything.
///
/// Has no thread; times are seconds of any clock that does not go back. Functions that return a Result change
/// nothing where they fail; the message is a sentence for a person.
class OpenDocuments {
 public:
  /// @param options       for missions; its `files` are replaced
  /// @param state_folder  where drafts are kept; empty: they are not
  OpenDocuments(documents::ProjectFolder& project, mdl::LoadOptions options, const std::string& state_folder);
  ~OpenDocuments();
  OpenDocuments(const OpenDocuments&) = delete;
  OpenDocuments& operator=(const OpenDocuments&) = delete;

  // ---- which mission

  /// For missions that do not SET SEED, from the next one that is opened on.
  void set_seed(std::uint64_t seed) { options_.seed = seed; }

  /// Opens a mission and its overlays, and begins the log of edits anew. Unsaved texts of the mission before
  /// stay as drafts. Drafts of the opened ones are put in as the first edit, so that undoing gives what
  /// stands on disk. A mission with errors is opened, too: then `mission()` is null.
  /// @errors `cannot-read`; `not-kept`: what is not saved can't be kept, so it would be lost
  text::Result<bool> open(const std::string& path, double now);
  /// A mission given on the command line, wherever it stands: what it names outside of the project becomes
  /// readable.
  text::Result<bool> open_on_disk(const std::string& disk_path, double now);
  /// Opens what a Trial brings along, in place of what was open. No draft is kept of it.
  /// @errors `no-folder`: its paths are none; `not-kept`
  text::Result<bool> open_trial(const Trial& trial, double now);
  /// The mission that is open is one.
  bool is_trial() const { return is_open() && mission_file_->is_detached; }
  bool is_open() const { return mission_file_ != nullptr; }
  /// There is a text of that name to be opened: a file, or what is kept of one.
  bool is_there(const std::string& path) const;

  /// A file that is not on disk yet. A MISSION is opened in place of what was open, with an empty overlay
  /// beside it; an OVERLAY comes to the mission that is open, which then names it.
  /// @errors `file-exists`, `cannot-write` (a path that can't be written), `no-mission`, `not-kept`
  text::Result<bool> create(const NewDocument& request, double now);

  // ---- edits

  text::Result<bool> edit_text(const EditText& request, double now);
  text::Result<bool> edit_map(const EditMap& request, double now);
  /// @param seed  in place of one that is 0
  text::Result<bool> create_obstacles(const CreateObstacles& request, std::uint32_t seed, double now);
  /// Of several documents, as one.
  void change(const std::vector<documents::Store::Change>& changes, std::string name, double now);
  /// An edit of another kind (a robot's parameter) that has been done already.
  void add_edit(documents::EditLog::Edit edit, double now) { log_->add(std::move(edit), now); }
  /// The history of all documents.
  const std::shared_ptr<documents::EditLog>& log() const { return log_; }
  /// False where there is nothing to undo.
  bool undo();
  bool redo();

  // ---- files

  /// Opens one beside the mission, with what is kept of unsaved work on it.
  /// @errors `cannot-read`
  text::Result<OpenDocument*> open_kept(const std::string& path, double now);
  /// @errors `cannot-write`; `changed-on-disk`: somebody else has changed the file since it was read;
  /// `read-only`.
  ///         What could be saved before the error is saved.
  text::Result<bool> save(const SaveDocuments& request);
  /// Takes what is on disk in place of a text, or together with what was changed here.
  /// @errors `no-document`; as Store::reload
  text::Result<bool> reload(const ReloadDocument& request, double now);
  /// Looks at the files. What was changed there is taken over where nothing is unsaved here.
  /// @return  whether anything has changed
  bool look_at_disk(double now);
  /// What is not saved, to be kept.
  documents::Store& store() { return store_; }
  /// Why what is not saved would be lost with this process; empty: it would not.
  std::string not_kept() const;
  /// What would be lost: ``a.mdl`: No space left on device`.
  std::vector<std::string> losses() const;

  // ---- what the texts mean

  /// The mission of the last texts without errors; null until there were some.
  const std::shared_ptr<const mission::Mission>& mission() const { return mission_; }
  /// The texts have errors: `mission()` is older than they are.
  bool runs_older_text() const { return mission_ != nullptr && has_errors_; }
  bool has_errors() const { return has_errors_; }
  /// What is wrong with them.
  const text::Diagnostics& problems() const { return diagnostics_; }
  /// The map as the texts say now, whatever is wrong with the rest of the mission; never null.
  const std::shared_ptr<const overlay::Overlay>& map() const { return map_; }
  /// That map as a message. Its revision grows where anything in it changes.
  const Scene& scene() const { return scene_; }
  /// Grows whenever a text, its diagnostics, or what is saved changes: then Documents is to be sent again.
  std::uint64_t revision() const { return revision_; }
  /// Grows whenever a file is opened, made, written or taken back: then Project is to be sent again.
  std::uint64_t files_revision() const { return files_revision_; }

  Documents documents_message() const;
  EditState edit_state() const;
  /// The mission file first, then its overlays in the order of the mission, then others that are not saved.
  std::vector<const OpenDocument*> documents() const;
  /// Of the mission that is open; empty: none is.
  std::string mission_path() const;
  /// The mission's folder on the machine, where its programs are looked for; empty: none is open.
  std::string mission_folder() const;
  /// How a place of `mission()` or of a diagnostic is told to a browser.
  DocumentPlace place(const text::Place& place) const;
  Diagnostic message(const text::Diagnostic& diagnostic) const;
  /// For loading what belongs to the mission (typed commands, say): reads the open texts.
  const mdl::LoadOptions& load_options() const { return options_; }
  /// What was open lately and what there is to open.
  Project project_message() const;
  /// Names for `complete`: units of this mission (null: of the texts'), places of the map, overlays beside
  /// the mission.
  KnownNames known_names(const mission::Mission* mission) const;
  /// Sentences for the log that came up since this was asked last: `restored unsaved text of a.mdl`.
  void add_notice(std::string sentence) { notices_.push_back(std::move(sentence)); }
  std::vector<std::string> take_notices() { return std::exchange(notices_, {}); }

 private:
  using Change = documents::Store::Change;
  using OpenResult = text::Result<OpenDocument*>;

  const OpenDocument* find_source(const text::SourcePtr& source) const;
  /// Opens a file, as it stands on disk or, where it does not, as a draft of it says.
  OpenResult open_file(const std::string& path);
  /// A document without a file.
  OpenDocument& add(const std::string& path, std::string text);
  void add_trial(const std::string& path, const std::string& text);
  void close();
  void open_overlays();
  void restore_drafts(double now);
  void update_shown();
  /// Everything anew that follows from the texts.
  void check();
  void update_scene();
  MapTexts map_texts() const;
  /// Does and enters an edit of the map. A mission without overlay gets one first, where `needs_overlay`.
  using MakeEdits = std::function<text::Result<std::vector<TextEdit>>(const MapTexts&)>;
  text::Result<bool> change_map(const std::string& name, bool needs_overlay, const MakeEdits& make,
                                double now);
  std::vector<Change> first_overlay();
  OpenDocument& new_document(const std::string& path);
  /// There is a text of that name: a file, or one that was never saved.
  bool is_taken(const std::string& path) const;
  /// For what is about to leave: what is not saved stays as drafts, or an error says what can't.
  text::Result<bool> keep_what_leaves(double now);
  text::Result<bool> save_as(OpenDocument& document, const std::string& path);
  void take_along(const std::vector<OpenDocument*>& overlays, const std::string& from_folder,
                  const std::string& to_folder);
  text::Result<bool> create_mission(const std::string& path, double now);
  text::Result<bool> create_overlay(const std::string& path, double now);

  documents::ProjectFolder& project_;
  mdl::LoadOptions options_;
  documents::Store store_;
  std::shared_ptr<documents::EditLog> log_;   // of all of them
  OpenDocument* mission_file_ = nullptr;      // null: none
  std::vector<OpenDocument*> overlays_;       // as the mission names them, each once
  std::vector<OpenDocument*> shown_;          // what `documents` gives
  std::vector<std::uint32_t> overlay_order_;  // as MapTexts::order
  text::Diagnostics diagnostics_;
  std::shared_ptr<const mission::Mission> mission_;
  std::shared_ptr<const overlay::Overlay> map_;
  Scene scene_;
  std::uint64_t revision_ = 0;
  std::uint64_t files_revision_ = 1;
  bool has_errors_ = false;
  std::vector<std::string> notices_;
};

}  // namespace mlab::console
