#include "mlab/console/documents.h"

#include <algorithm>
#include <filesystem>
#include <ranges>

#include <fmt/core.h>

#include "mlab/console/document_parts.h"
#include "mlab/console/mission_text.h"
#include "mlab/console/utf8.h"
#include "mlab/lang/mdl/tree.h"
#include "mlab/text/line_ends.h"

namespace mlab::console {
namespace {

namespace fs = std::filesystem;

template <class List, class Value>
bool holds(const List& list, const Value& value) {
  return std::ranges::find(list, value) != list.end();
}

}  // namespace

OpenDocuments::OpenDocuments(ProjectFolder& project, mdl::LoadOptions options,
                             const std::string& state_folder)
    : project_(project),
      options_(std::move(options)),
      drafts_(state_folder, project.folder()),
      keeper_(drafts_),
      map_(std::make_shared<const overlay::Overlay>()) {
  options_.files = files();
  update_scene();
}

OpenDocuments::~OpenDocuments() {
  keep_drafts(0.0, DraftKeeper::When::kAtOnce);
}

// ---- which documents there are

OpenDocument* OpenDocuments::find(std::string_view path) {
  const auto found =
      std::ranges::find_if(open_, [&](const auto& entry) { return entry.second.path == path; });
  return found == open_.end() ? nullptr : &found->second;
}

// A diagnostic may hold the text of a moment ago, so the name counts.
const OpenDocument* OpenDocuments::find_source(const text::SourcePtr& source) const {
  if (!source) return nullptr;
  for (const Key key : shown_) {
    const OpenDocument& document = open_.at(key);
    if (document.source == source || document.source->name() == source->name()) return &document;
  }
  return nullptr;
}

OpenDocuments::Key OpenDocuments::add(OpenDocument document) {
  ++files_revision_;
  open_.emplace(++last_key_, std::move(document));
  return last_key_;
}

text::Result<OpenDocuments::Key> OpenDocuments::open_file(const std::string& path, bool is_mission) {
  const auto same = std::ranges::find_if(open_, [&](const auto& entry) { return entry.second.path == path; });
  if (same != open_.end()) return same->first;
  OpenDocument out;
  out.path = path;
  out.is_mission = is_mission;
  out.is_writable = project_.is_writable(path);
  text::Result<std::string> on_disk = project_.read(path);
  if (!on_disk) {
    const auto draft = drafts_.find(path);
    if (!draft || draft->had_file || project_.is_file(path)) return std::unexpected(on_disk.error());
    out.source = source_of(project_.disk_path(path), draft->text);
    notices_.push_back(fmt::format("restored {}, which was never saved", shown(path)));
    return add(std::move(out));
  }
  if (!is_utf8(*on_disk))
    notices_.push_back(
        fmt::format("{} is not UTF-8: it is read as Latin 1, and saved as UTF-8", shown(path)));
  out.saved = text::unix_lines(std::move(*on_disk));
  out.source = source_of(project_.disk_path(path), as_utf8(*out.saved));
  return add(std::move(out));
}

// The mission, its overlays in its order, then what is not saved.
void OpenDocuments::update_shown() {
  shown_.clear();
  if (!is_open()) return;
  shown_.push_back(mission_file_);
  shown_.insert(shown_.end(), overlays_.begin(), overlays_.end());
  for (const auto& [key, document] : open_) {
    if (document.is_dirty() && !document.is_nothing() && !holds(shown_, key)) shown_.push_back(key);
  }
}

std::vector<const OpenDocument*> OpenDocuments::documents() const {
  std::vector<const OpenDocument*> out;
  for (const Key key : shown_) out.push_back(&open_.at(key));
  return out;
}

// ---- which mission

text::Result<bool> OpenDocuments::open(const std::string& path, double now) {
  if (text::Result<bool> kept = keep_what_leaves(now); !kept) return kept;
  std::map<Key, OpenDocument> before = std::exchange(open_, {});
  const text::Result<Key> key = open_file(path, true);
  if (!key) {
    open_ = std::move(before);
    return std::unexpected(key.error());
  }
  mission_file_ = *key;
  overlays_.clear();
  log_.clear();
  mission_.reset();
  check();
  restore_drafts(now);
  drafts_.add_recent(path, mission_ ? mission_->name : "");
  return true;
}

// Every file that the mission names, found as ever, may be read from now on. Later texts of the browser
// cannot add to this.
text::Result<bool> OpenDocuments::open_on_disk(const std::string& disk_path, double now) {
  std::error_code missing;
  const std::string path = fs::weakly_canonical(fs::absolute(disk_path), missing).string();
  const auto allow = [&](const std::string& file) {
    if (!project_.name_of(file)) project_.allow_outside(file);
  };
  if (!text::files_on_disk().is_file(path)) {
    return refused("cannot-read", fmt::format("there is no mission {}", shown(disk_path)));
  }
  allow(path);
  mdl::LoadOptions options = options_;
  options.files = text::files_on_disk();
  options.files.is_file = [&](const std::string& file) {
    const bool is_there = text::files_on_disk().is_file(file);
    if (is_there) allow(file);
    return is_there;
  };
  options.societies = nullptr;
  text::Diagnostics unsaid;
  mdl::load_mission(path, unsaid, options);
  return open(*project_.name_of(path), now);
}

OpenDocuments::Key OpenDocuments::add_trial(const std::string& path, const std::string& text,
                                            bool is_mission) {
  OpenDocument out;
  out.path = path;
  out.is_mission = is_mission;
  out.is_writable = false;
  out.is_trial = true;
  out.source = source_of(project_.disk_path(path), text);
  return add(std::move(out));
}

text::Result<bool> OpenDocuments::open_trial(const Trial& trial, double now) {
  const bool has_overlay = !trial.overlay_path.empty();
  const bool has_place = !project_.disk_path(trial.path).empty() &&
                         (!has_overlay || !project_.disk_path(trial.overlay_path).empty());
  if (!has_place) return refused("no-folder", fmt::format("there is no place for {}", shown(trial.path)));
  if (text::Result<bool> kept = keep_what_leaves(now); !kept) return kept;
  close();
  mission_file_ = add_trial(trial.path, trial.text, true);
  if (has_overlay) add_trial(trial.overlay_path, trial.overlay_text, false);
  check();
  return true;
}

void OpenDocuments::close() {
  open_.clear();
  mission_file_ = 0;
  overlays_.clear();
  log_.clear();
  mission_.reset();
  check();
}

// Drafts of files become an edit, so that undoing it gives the file's own text.
void OpenDocuments::restore_drafts(double now) {
  for (int round = 0; round < 3; ++round) {  // a restored mission may name other overlays
    std::vector<TextChange> changes;
    for (const Key key : shown_) {
      OpenDocument& document = open_.at(key);
      const auto draft = drafts_.find(document.path);
      if (!draft || !document.saved || draft->text == document.source->text() || !is_utf8(draft->text))
        continue;
      changes.push_back({key, 0, std::string(document.source->text()), draft->text});
      document.draft.kept = document.revision;
      notices_.push_back(
          draft->file_digest == Drafts::digest(*document.saved)
              ? fmt::format("restored the unsaved text of {}", shown(document.path))
              : fmt::format("restored the unsaved text of {}; its file has changed since, undo shows it",
                            shown(document.path)));
    }
    if (changes.empty()) return;
    commit("restore unsaved text", std::move(changes), now);
    log_.separate();
  }
}

// ---- what the texts mean

text::Files OpenDocuments::files() {
  return {[this](const std::string& path) {
            const auto name = project_.name_of(path);
            if (!name || find(*name) != nullptr || project_.is_file(*name)) return name.has_value();
            const auto draft = drafts_.find(*name);
            return draft && !draft->had_file;
          },
          [this](const std::string& path) -> text::Result<text::SourcePtr> {
            const auto name = project_.name_of(path);
            if (!name)
              return refused("cannot-read", fmt::format("{} is not in the project folder", shown(path)));
            if (const OpenDocument* document = find(*name)) return document->source;
            text::Result<std::string> text = project_.read(*name);
            if (!text) return std::unexpected(text.error());
            return source_of(path, std::move(*text));
          },
          [this](const std::string& path) {
            const auto name = project_.name_of(path);
            return name ? project_.beginning(*name) : std::string();
          }};
}

void OpenDocuments::open_overlays() {
  overlays_.clear();
  overlay_order_.clear();
  if (!is_open()) return;
  text::Diagnostics unsaid;
  const mdl::Tree tree = mdl::parse(mission_document().source, unsaid);
  for (const mdl::Statement& statement : tree.preamble) {
    const auto* overlay = std::get_if<mdl::statement::OverlayFile>(&statement.what);
    if (overlay == nullptr) continue;
    const auto path = mdl::find_overlay(overlay->file.text, mission_folder(), options_);
    const auto name = path ? project_.name_of(*path) : std::nullopt;
    const auto key = name ? open_file(*name, false) : text::Result<Key>(refused("", ""));
    if (!key || *key == mission_file_) {
      overlay_order_.push_back(MapTexts::kMissing);
      continue;
    }
    const auto known = std::ranges::find(overlays_, *key);
    overlay_order_.push_back(static_cast<std::uint32_t>(known - overlays_.begin()));
    if (known == overlays_.end()) overlays_.push_back(*key);
  }
}

void OpenDocuments::check() {
  ++revision_;
  open_overlays();
  update_shown();
  diagnostics_ = {};
  has_errors_ = false;
  if (is_open()) {
    const text::SourcePtr& source = mission_document().source;
    const auto mission = mdl::check_mission(source, mission_folder(), diagnostics_, options_);
    has_errors_ = mission == nullptr;
    text::Diagnostics unsaid;
    map_ = std::make_shared<const overlay::Overlay>(
        mission ? mission->overlay : mdl::check_map(source, mission_folder(), unsaid, options_));
    if (mission) mission_ = mission;
  } else {
    map_ = std::make_shared<const overlay::Overlay>();
  }
  update_scene();
}

void OpenDocuments::update_scene() {
  Scene now = encode_scene(*map_, [this](const text::Place& where) { return place(where); });
  const std::uint64_t revision = scene_.revision();
  now.set_revision(revision);
  if (now.has_picture()) now.mutable_picture()->set_url(fmt::format("/picture/{}", revision));
  if (revision > 0 && now.SerializeAsString() == scene_.SerializeAsString()) return;
  now.set_revision(revision + 1);
  if (now.has_picture()) now.mutable_picture()->set_url(fmt::format("/picture/{}", revision + 1));
  scene_ = std::move(now);
}

std::string OpenDocuments::mission_path() const {
  return is_open() ? mission_document().path : "";
}

std::string OpenDocuments::mission_folder() const {
  return is_open() ? fs::path(mission_document().source->name()).parent_path().string() : "";
}

DocumentPlace OpenDocuments::place(const text::Place& place) const {
  const OpenDocument* document = find_source(place.source);
  if (document == nullptr) return {};
  return {document->path, place.source->line_column(place.span.begin).line};
}

Diagnostic OpenDocuments::message(const text::Diagnostic& diagnostic) const {
  return encode_diagnostic(diagnostic, [this](const text::Place& where) { return place(where); });
}

// ---- edits

void OpenDocuments::replace(const TextChange& change, bool undone) {
  OpenDocument& document = open_.at(change.document);
  const std::string& removed = undone ? change.inserted : change.removed;
  const std::string& inserted = undone ? change.removed : change.inserted;
  std::string text(document.source->text());
  text.replace(change.begin, removed.size(), inserted);
  document.source = source_of(document.source->name(), std::move(text));
  ++document.revision;
}

void OpenDocuments::commit(std::string name, std::vector<TextChange> changes, double now) {
  const auto shared = std::make_shared<const std::vector<TextChange>>(std::move(changes));
  const auto redo = [this, shared] {
    for (const TextChange& change : *shared) replace(change, false);
  };
  const auto undo = [this, shared] {
    for (const TextChange& change : std::views::reverse(*shared)) replace(change, true);
  };
  redo();
  log_.add({std::move(name), undo, redo}, now);
  check();
}

text::Result<bool> OpenDocuments::edit_text(const EditText& request, double now) {
  const auto found =
      std::ranges::find_if(open_, [&](const auto& entry) { return entry.second.path == request.document(); });
  if (found == open_.end())
    return refused("no-document", fmt::format("{} is not open", shown(request.document())));
  const auto& [key, document] = *found;
  const std::string_view text = document.source->text();
  if (request.revision() != document.revision)
    return refused("older-text", fmt::format("{} has changed meanwhile", shown(document.path)));
  if (request.begin() > request.end() || request.end() > text.size() ||
      !is_character_boundary(text, request.begin()) || !is_character_boundary(text, request.end())) {
    return refused("no-such-range", fmt::format("{} has no such range", shown(document.path)));
  }
  if (text.size() + request.text().size() > text::Source::kMaxBytes)
    return refused("file-too-large", fmt::format("{} would become too large", shown(document.path)));
  const std::string name = request.name().empty() ? fmt::format("edit {}", document.path) : request.name();
  commit(name,
         {{key, request.begin(), std::string(text.substr(request.begin(), request.end() - request.begin())),
           request.text()}},
         now);
  return true;
}

MapTexts OpenDocuments::map_texts() const {
  MapTexts out{mission_document().source, {}, overlay_order_, map_.get()};
  for (const Key key : overlays_) out.overlays.push_back({open_.at(key).path, open_.at(key).source});
  return out;
}

// A document for a new file. One that an undone edit left behind is taken again.
OpenDocuments::Key OpenDocuments::new_document(const std::string& path) {
  for (const auto& [key, document] : open_) {
    if (document.path == path && document.is_nothing()) return key;
  }
  OpenDocument out;
  out.path = path;
  out.is_writable = project_.is_writable(path);
  out.source = source_of(project_.disk_path(path), "");
  return add(std::move(out));
}

bool OpenDocuments::is_taken(const std::string& path) {
  const OpenDocument* document = find(path);
  return project_.is_file(path) || (document != nullptr && !document->is_nothing());
}

// An empty overlay beside the mission, which names it.
std::vector<OpenDocuments::TextChange> OpenDocuments::first_overlay() {
  const OpenDocument& mission = mission_document();
  const std::string beside = fs::path(mission.path).replace_extension().string();
  std::string path = beside + ".odl";
  for (int i = 2; is_taken(path); ++i) path = fmt::format("{}_{}.odl", beside, i);
  const Splice line = overlay_statement(mission.source, fs::path(path).filename().string());
  return {{new_document(path), 0, "", kEmptyOverlay}, {mission_file_, line.begin, "", line.text}};
}

text::Result<bool> OpenDocuments::change_map(const std::string& name, bool needs_overlay,
                                             const MakeEdits& make, double now) {
  if (!is_open()) return refused("no-mission", "no mission is open");
  std::vector<TextChange> changes;
  if (needs_overlay && overlays_.empty()) {
    changes = first_overlay();
    for (const TextChange& change : changes) replace(change, false);
    check();
  }
  text::Result<std::vector<TextEdit>> edits = make(map_texts());
  std::vector<TextChange> more;
  if (edits) {
    for (const TextEdit& edit : *edits) {
      const auto found =
          std::ranges::find_if(open_, [&](const auto& entry) { return entry.second.source == edit.source; });
      const text::Span range{edit.splice.begin, edit.splice.end};
      more.push_back({found->first, range.begin, std::string(edit.source->text(range)), edit.splice.text});
    }
  }
  for (const TextChange& change : std::views::reverse(changes)) replace(change, true);
  if (!edits) {
    if (!changes.empty()) check();
    return std::unexpected(edits.error());
  }
  changes.insert(changes.end(), more.begin(), more.end());
  commit(name, std::move(changes), now);
  return true;
}

text::Result<bool> OpenDocuments::edit_map(const EditMap& request, double now) {
  const bool needs_overlay = std::ranges::any_of(request.changes(), [](const MapChange& change) {
    return change.has_add_measure() || change.has_add_obstacle() || change.has_add_object();
  });
  const std::string name = request.name().empty() ? "edit the map" : request.name();
  return change_map(
      name, needs_overlay,
      [&](const MapTexts& texts) { return console::edit_map(texts, request.changes(), request.document()); },
      now);
}

text::Result<bool> OpenDocuments::create_obstacles(const CreateObstacles& request, std::uint32_t seed,
                                                   double now) {
  const std::uint32_t used = request.seed() != 0 ? request.seed() : seed;
  bool is_complete = true;
  log_.separate();
  text::Result<bool> out = change_map(
      fmt::format("random obstacles, seed {}", used), true,
      [&](const MapTexts& texts) { return console::create_obstacles(texts, request, used, is_complete); },
      now);
  if (out && !is_complete) notices_.emplace_back("no room was found for all of the random obstacles");
  return out;
}

bool OpenDocuments::undo() {
  if (!log_.undo()) return false;
  ++files_revision_;
  check();
  return true;
}

bool OpenDocuments::redo() {
  if (!log_.redo()) return false;
  ++files_revision_;
  check();
  return true;
}

// ---- messages

Documents OpenDocuments::documents_message() const {
  Documents out;
  std::map<std::string, Documents::Document*> by_path;
  for (const OpenDocument* document : documents()) {
    Documents::Document& to = *out.add_documents();
    to.set_path(document->path);
    to.set_language(document->is_mission ? Complete::MISSION : Complete::OVERLAY);
    to.set_text(std::string(document->source->text()));
    to.set_revision(document->revision);
    to.set_is_dirty(document->is_dirty());
    to.set_is_read_only(!document->is_writable);
  }
  for (Documents::Document& document : *out.mutable_documents()) by_path[document.path()] = &document;
  for (const text::Diagnostic& item : diagnostics_.items()) {
    Diagnostic diagnostic = message(item);
    const auto found = by_path.find(diagnostic.document());
    if (found != by_path.end()) {
      *found->second->add_diagnostics() = std::move(diagnostic);
    } else if (out.documents_size() > 0) {
      *out.mutable_documents(0)->add_diagnostics() = std::move(diagnostic);
    }
  }
  out.set_runs_older_text(runs_older_text());
  return out;
}

Project OpenDocuments::project_message() const {
  Project out;
  out.set_folder(project_.name());
  out.set_mission(mission_path());
  const auto add_entry = [](Project::Entry& to, const std::string& path, const std::string& title) {
    to.set_path(path);
    to.set_title(as_utf8(title));
  };
  for (const Drafts::Recent& recent : drafts_.recent()) {
    const bool is_there = project_.is_file(recent.path) || drafts_.find(recent.path);
    if (is_there) add_entry(*out.add_recent(), recent.path, recent.title);
  }
  for (const std::string& path : project_.missions("examples:")) add_entry(*out.add_examples(), path, "");
  for (const std::string& path : project_.missions("")) add_entry(*out.add_missions(), path, "");
  for (const std::string& path : drafts_.new_files()) {
    if (path.ends_with(".mdl") && !project_.is_file(path))
      add_entry(*out.add_missions(), path, "not saved yet");
  }
  return out;
}

KnownNames OpenDocuments::known_names(const mission::Mission* mission) const {
  KnownNames out{mission != nullptr ? mission : mission_.get(), map_.get(), {}};
  const std::size_t slash = mission_path().rfind('/');
  const std::string folder = slash == std::string::npos ? "" : mission_path().substr(0, slash);
  const auto entries = project_.list(folder);
  for (std::size_t i = 0; entries && i < entries->size(); ++i) {
    const ProjectFolder::Entry& entry = (*entries)[i];
    if (entry.kind == "overlay") out.overlay_files.push_back(fs::path(entry.path).filename().string());
  }
  return out;
}

EditState OpenDocuments::edit_state() const {
  EditState out;
  out.set_undo(log_.undo_name());
  out.set_redo(log_.redo_name());
  out.set_undo_number(log_.undo_number());
  out.set_redo_number(log_.redo_number());
  out.set_is_dirty(std::ranges::any_of(documents(), &OpenDocument::is_dirty));
  out.set_not_kept(not_kept());
  return out;
}

}  // namespace mlab::console
