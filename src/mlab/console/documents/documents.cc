#include "mlab/console/documents/documents.h"

#include <algorithm>
#include <filesystem>

#include <fmt/core.h>

#include "mlab/console/documents/document_parts.h"
#include "mlab/console/documents/mission_text.h"
#include "mlab/lang/mdl/tree.h"
#include "mlab/text/utf8.h"

namespace mlab::console {
namespace {

namespace fs = std::filesystem;

template <class List, class Value>
bool holds(const List& list, const Value& value) {
  return std::ranges::find(list, value) != list.end();
}

Documents::Disk on_disk(OpenDocument::Disk disk) {
  return disk == OpenDocument::Disk::kSame      ? Documents::SAME
         : disk == OpenDocument::Disk::kChanged ? Documents::CHANGED
                                                : Documents::GONE;
}

}  // namespace

OpenDocuments::OpenDocuments(documents::ProjectFolder& project, mdl::LoadOptions options,
                             const std::string& state_folder)
    : project_(project),
      options_(std::move(options)),
      store_(project, state_folder),
      log_(std::make_shared<documents::EditLog>()),
      map_(std::make_shared<const overlay::Overlay>()) {
  options_.files = store_.files();
  update_scene();
}

OpenDocuments::~OpenDocuments() {
  store_.keep_drafts(0.0, documents::DraftKeeper::When::kAtOnce);
}

// ---- which documents there are

// A diagnostic may hold the text of a moment ago, so the name counts.
const OpenDocument* OpenDocuments::find_source(const text::SourcePtr& source) const {
  if (!source) return nullptr;
  for (const OpenDocument* document : shown_) {
    const text::SourcePtr& known = document->text.source();
    if (known == source || known->name() == source->name()) return document;
  }
  return nullptr;
}

OpenDocument& OpenDocuments::add(const std::string& path, std::string text) {
  ++files_revision_;
  auto out = std::make_shared<OpenDocument>(
      path, std::make_shared<const text::Source>(project_.disk_path(path), std::move(text)));
  out->is_writable = project_.is_writable(path);
  out->log = log_;
  return store_.add(std::move(out));
}

OpenDocuments::OpenResult OpenDocuments::open_file(const std::string& path) {
  if (OpenDocument* open = store_.find(path)) return open;
  text::Result<std::string> content = store_.read(path);
  if (!content) {
    const auto draft = store_.drafts().find(path);
    if (!draft || project_.is_file(path)) return std::unexpected(content.error());
    notices_.push_back(draft->had_file
                           ? fmt::format("restored the unsaved text of {}, whose file is gone", shown(path))
                           : fmt::format("restored {}, which was never saved", shown(path)));
    OpenDocument& out = add(path, draft->text);
    store_.restore_draft(out, 0.0);
    return &out;
  }
  if (!text::is_utf8(project_.read(path).value_or("")))
    notices_.push_back(
        fmt::format("{} is not UTF-8: it is read as Latin 1, and saved as UTF-8", shown(path)));
  OpenDocument& out = add(path, *content);
  out.saved = std::move(*content);
  return &out;
}

// The mission, its overlays in its order, then what is not saved.
void OpenDocuments::update_shown() {
  shown_.clear();
  if (!is_open()) return;
  shown_.push_back(mission_file_);
  shown_.insert(shown_.end(), overlays_.begin(), overlays_.end());
  for (const documents::DocumentPtr& one : store_.all()) {
    if (one->is_dirty() && !holds(shown_, one.get())) shown_.push_back(one.get());
  }
}

std::vector<const OpenDocument*> OpenDocuments::documents() const {
  return {shown_.begin(), shown_.end()};
}

// ---- which mission

text::Result<bool> OpenDocuments::open(const std::string& path, double now) {
  if (text::Result<bool> kept = keep_what_leaves(now); !kept) return kept;
  const std::vector<documents::DocumentPtr> before = store_.close_all();
  const OpenResult found = open_file(path);
  if (!found) {
    for (const documents::DocumentPtr& one : before) store_.add(one);
    return std::unexpected(found.error());
  }
  mission_file_ = *found;
  overlays_.clear();
  log_->clear();
  mission_.reset();
  check();
  restore_drafts(now);
  store_.drafts().add_recent(path, mission_ ? mission_->name : "");
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

bool OpenDocuments::is_there(const std::string& path) const {
  // It may be allowed only when it is opened.
  if (path.starts_with(documents::kOutsideFiles) &&
      text::files_on_disk().is_file(path.substr(documents::kOutsideFiles.size())))
    return true;
  return project_.is_file(path) || store_.drafts().find(path).has_value();
}

void OpenDocuments::add_trial(const std::string& path, const std::string& text) {
  OpenDocument& out = add(path, text);
  out.is_writable = false;
  out.is_detached = true;
}

text::Result<bool> OpenDocuments::open_trial(const Trial& trial, double now) {
  const bool has_overlay = !trial.overlay_path.empty();
  const bool has_place = !project_.disk_path(trial.path).empty() &&
                         (!has_overlay || !project_.disk_path(trial.overlay_path).empty());
  if (!has_place) return refused("no-folder", fmt::format("there is no place for {}", shown(trial.path)));
  if (text::Result<bool> kept = keep_what_leaves(now); !kept) return kept;
  close();
  add_trial(trial.path, trial.text);
  mission_file_ = store_.find(trial.path);
  if (has_overlay) add_trial(trial.overlay_path, trial.overlay_text);
  check();
  return true;
}

void OpenDocuments::close() {
  mission_file_ = nullptr;
  overlays_.clear();
  log_->clear();
  store_.close_all();
  mission_.reset();
  check();
}

// Drafts of files become an edit, so that undoing it gives the file's own text.
void OpenDocuments::restore_drafts(double now) {
  using Restored = documents::Store::Restored;
  for (int round = 0; round < 3; ++round) {  // a restored mission may name other overlays
    bool is_done = true;
    for (OpenDocument* document : shown_) {
      const Restored restored = store_.restore_draft(*document, now);
      if (restored == Restored::kNothing || restored == Restored::kTextOfGoneFile) continue;
      is_done = false;
      notices_.push_back(
          restored == Restored::kText
              ? fmt::format("restored the unsaved text of {}", shown(document->path))
              : fmt::format("restored the unsaved text of {}; its file has changed since, undo shows it",
                            shown(document->path)));
    }
    if (is_done) return;
    log_->separate();
    check();
  }
}

// ---- what the texts mean

void OpenDocuments::open_overlays() {
  overlays_.clear();
  overlay_order_.clear();
  if (!is_open()) return;
  text::Diagnostics unsaid;
  const mdl::Tree tree = mdl::parse(mission_file_->text.source(), unsaid);
  for (const mdl::Statement& statement : tree.preamble) {
    const auto* overlay = std::get_if<mdl::statement::OverlayFile>(&statement.what);
    if (overlay == nullptr) continue;
    const auto path = mdl::find_overlay(overlay->file.text, mission_folder(), options_);
    const auto name = path ? project_.name_of(*path) : std::nullopt;
    const OpenResult found = name ? open_file(*name) : OpenResult(refused("", ""));
    if (!found || *found == mission_file_) {
      overlay_order_.push_back(MapTexts::kMissing);
      continue;
    }
    const auto known = std::ranges::find(overlays_, *found);
    overlay_order_.push_back(static_cast<std::uint32_t>(known - overlays_.begin()));
    if (known == overlays_.end()) overlays_.push_back(*found);
  }
}

void OpenDocuments::check() {
  ++revision_;
  open_overlays();
  update_shown();
  diagnostics_ = {};
  has_errors_ = false;
  if (is_open()) {
    const text::SourcePtr source = mission_file_->text.source();
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
  return is_open() ? mission_file_->path : "";
}

std::string OpenDocuments::mission_folder() const {
  return is_open() ? fs::path(mission_file_->text.source()->name()).parent_path().string() : "";
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

void OpenDocuments::change(const std::vector<Change>& changes, std::string name, double now) {
  store_.change(changes, std::move(name), now);
  check();
}

text::Result<bool> OpenDocuments::edit_text(const EditText& request, double now) {
  OpenDocument* document = store_.find(request.document());
  if (document == nullptr)
    return refused("no-document", fmt::format("{} is not open", shown(request.document())));
  const std::string_view text = document->text.text();
  if (request.revision() != document->text.revision())
    return refused("older-text", fmt::format("{} has changed meanwhile", shown(document->path)));
  if (request.begin() > request.end() || request.end() > text.size() ||
      !text::is_character_boundary(text, request.begin()) ||
      !text::is_character_boundary(text, request.end())) {
    return refused("no-such-range", fmt::format("{} has no such range", shown(document->path)));
  }
  if (text.size() + request.text().size() > text::Source::kMaxBytes)
    return refused("file-too-large", fmt::format("{} would become too large", shown(document->path)));
  const std::string name = request.name().empty() ? fmt::format("edit {}", document->path) : request.name();
  change({{document, {{request.begin(), request.end()}, request.text()}}}, name, now);
  return true;
}

MapTexts OpenDocuments::map_texts() const {
  MapTexts out{mission_file_->text.source(), {}, overlay_order_, map_.get()};
  for (const OpenDocument* one : overlays_) out.overlays.push_back({one->path, one->text.source()});
  return out;
}

// A document for a new file. One that an undone edit left behind is taken again.
OpenDocument& OpenDocuments::new_document(const std::string& path) {
  OpenDocument* before = store_.find(path);
  return before != nullptr ? *before : add(path, "");
}

bool OpenDocuments::is_taken(const std::string& path) const {
  const OpenDocument* document = store_.find(path);
  if (project_.is_file(path)) return true;
  return document != nullptr ? !document->is_nothing() : store_.drafts().find(path).has_value();
}

// An empty overlay beside the mission, which names it.
std::vector<OpenDocuments::Change> OpenDocuments::first_overlay() {
  const std::string beside = fs::path(mission_file_->path).replace_extension().string();
  std::string path = beside + ".odl";
  for (int i = 2; is_taken(path); ++i) path = fmt::format("{}_{}.odl", beside, i);
  const std::string name = fs::path(path).filename().string();
  return {{&new_document(path), {{}, kEmptyOverlay}},
          {mission_file_, overlay_statement(mission_file_->text.source(), name)}};
}

text::Result<bool> OpenDocuments::change_map(const std::string& name, bool needs_overlay,
                                             const MakeEdits& make, double now) {
  if (!is_open()) return refused("no-mission", "no mission is open");
  std::vector<Change> changes;
  if (needs_overlay && overlays_.empty()) changes = first_overlay();
  std::vector<std::string> before;  // so that the edits are made of texts with that overlay
  for (const auto& [document, splice] : changes) {
    before.emplace_back(document->text.text());
    document->text.set(text::spliced(before.back(), splice));
  }
  if (!changes.empty()) check();
  const text::Result<std::vector<TextEdit>> edits = make(map_texts());
  std::vector<Change> more;
  for (const TextEdit& edit : edits.value_or(std::vector<TextEdit>())) {
    const auto& found = std::ranges::find(
        shown_, edit.source, [](const OpenDocument* one) -> const auto& { return one->text.source(); });
    more.push_back({*found, edit.splice});
  }
  for (std::size_t i = 0; i < changes.size(); ++i) changes[i].document->text.set(before[i]);
  if (!edits) {
    if (!changes.empty()) check();
    return std::unexpected(edits.error());
  }
  changes.insert(changes.end(), more.begin(), more.end());
  change(changes, name, now);
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
  log_->separate();
  text::Result<bool> out = change_map(
      fmt::format("random obstacles, seed {}", used), true,
      [&](const MapTexts& texts) { return console::create_obstacles(texts, request, used, is_complete); },
      now);
  if (out && !is_complete) notices_.emplace_back("no room was found for all of the random obstacles");
  return out;
}

bool OpenDocuments::undo() {
  if (!log_->undo()) return false;
  ++files_revision_;
  check();
  return true;
}

bool OpenDocuments::redo() {
  if (!log_->redo()) return false;
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
    const bool is_mission = document == mission_file_ || document->path.ends_with(".mdl");
    to.set_language(is_mission ? Complete::MISSION : Complete::OVERLAY);
    to.set_text(std::string(document->text.text()));
    to.set_revision(document->text.revision());
    to.set_is_dirty(document->is_dirty());
    to.set_is_read_only(!document->is_writable);
    to.set_disk(on_disk(document->disk));
    to.set_taken_over(document->taken_over);
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
  const auto missions = [this](std::string_view folder) {
    std::vector<std::string> found = project_.files(folder, ".mdl");
    std::ranges::sort(found);
    return found;
  };
  Project out;
  out.set_folder(project_.name());
  out.set_mission(mission_path());
  const auto add_entry = [](Project::Entry& to, const std::string& path, const std::string& title) {
    to.set_path(path);
    to.set_title(text::as_utf8(title));
  };
  for (const documents::Drafts::Recent& recent : store_.drafts().recent()) {
    const bool is_there = project_.is_file(recent.path) || store_.drafts().find(recent.path);
    if (is_there) add_entry(*out.add_recent(), recent.path, recent.title);
  }
  for (const std::string& path : missions("examples:")) add_entry(*out.add_examples(), path, "");
  for (const std::string& path : missions("")) add_entry(*out.add_missions(), path, "");
  for (const std::string& path : store_.only_kept()) {
    if (path.ends_with(".mdl")) add_entry(*out.add_missions(), path, "not saved yet");
  }
  return out;
}

KnownNames OpenDocuments::known_names(const mission::Mission* mission) const {
  KnownNames out{mission != nullptr ? mission : mission_.get(), map_.get(), {}};
  const std::size_t slash = mission_path().rfind('/');
  const std::string folder = slash == std::string::npos ? "" : mission_path().substr(0, slash);
  const auto entries = project_.list(folder);
  for (std::size_t i = 0; entries && i < entries->size(); ++i) {
    const documents::ProjectFolder::Entry& entry = (*entries)[i];
    if (entry.kind == "overlay") out.overlay_files.push_back(fs::path(entry.path).filename().string());
  }
  return out;
}

EditState OpenDocuments::edit_state() const {
  EditState out;
  out.set_undo(log_->undo_name());
  out.set_redo(log_->redo_name());
  out.set_undo_number(log_->undo_number());
  out.set_redo_number(log_->redo_number());
  out.set_is_dirty(std::ranges::any_of(documents(), &OpenDocument::is_dirty));
  out.set_not_kept(not_kept());
  return out;
}

}  // namespace mlab::console
