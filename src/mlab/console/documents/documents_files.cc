#include <filesystem>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/documents/document_parts.h"
#include "mlab/console/documents/documents.h"
#include "mlab/console/documents/mission_text.h"

namespace mlab::console {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNewMission =
    "MISSION NAME \"{}\"\n"
    "OVERLAY \"{}\"\n\n"
    "UNIT <scouts> ROBOT ROBOT ROBOT ROBOT\n\n"
    "COMMAND LIST:\n\n"
    "  0. UNIT scouts START 100 100 0 20\n";
constexpr const char* kNewOverlay = "MISSION-AREA 1000 1000\n\nCONTROL MEASURES:\n";

}  // namespace

text::Result<OpenDocument*> OpenDocuments::open_kept(const std::string& path, double now) {
  OpenResult found = open_file(path);
  if (!found) return found;
  log_->separate();
  store_.restore_draft(**found, now);
  log_->separate();
  check();
  return found;
}

text::Result<bool> OpenDocuments::save(const SaveDocuments& request) {
  ++revision_;
  ++files_revision_;
  std::vector<OpenDocument*> wanted;
  for (const std::string& path : request.documents()) {
    OpenDocument* document = store_.find(path);
    if (document == nullptr) return refused("no-document", fmt::format("{} is not open", shown(path)));
    wanted.push_back(document);
  }
  if (!request.as().empty()) {
    if (wanted.size() != 1)
      return refused("one-document", "one document at a time is saved under another name");
    return save_as(*wanted.front(), request.as());
  }
  if (wanted.empty()) {
    for (OpenDocument* document : shown_) {
      if (document->is_dirty()) wanted.push_back(document);
    }
  }
  text::Result<bool> out = true;
  for (OpenDocument* document : wanted) {
    text::Result<bool> saved = store_.save(*document, request.overwrite());
    if (!saved && out) out = std::move(saved);
  }
  update_shown();
  return out;
}

text::Result<bool> OpenDocuments::reload(const ReloadDocument& request, double now) {
  OpenDocument* document = store_.find(request.document());
  if (document == nullptr || document->is_detached)
    return refused("no-document", fmt::format("{} is not open", shown(request.document())));
  text::Result<bool> done = store_.reload(*document, request.merge(), now);
  if (done) check();
  return done;
}

bool OpenDocuments::look_at_disk(double now) {
  const std::vector<documents::Store::Seen> seen = store_.look_at_disk(now);
  using News = documents::Store::News;
  for (const documents::Store::Seen& one : seen) {
    if (one.news == News::kSameAgain) continue;
    const char* what = one.news == News::kGone        ? "is gone from the disk"
                       : one.news == News::kTakenOver ? "was changed on the disk: its new text is taken over"
                                                      : "was changed on the disk, and here too";
    notices_.push_back(fmt::format("{} {}", shown(one.document->path), what));
  }
  if (!seen.empty()) check();
  return !seen.empty();
}

std::vector<std::string> OpenDocuments::losses() const {
  std::vector<std::string> out;
  for (const documents::Store::Loss& loss : store_.losses())
    out.push_back(fmt::format("{}: {}", shown(loss.document->path), loss.why));
  return out;
}

std::string OpenDocuments::not_kept() const {
  const std::vector<std::string> lost = losses();
  return lost.empty() ? store_.folder_problem() : lost.front();
}

text::Result<bool> OpenDocuments::keep_what_leaves(double now) {
  store_.keep_drafts(now, documents::DraftKeeper::When::kAtOnce);
  const std::vector<std::string> lost = losses();
  if (lost.empty()) return true;
  return refused("not-kept", fmt::format("what is not saved would be lost: save it first, or undo it "
                                         "(it can't be kept as a draft: {})",
                                         lost.front()));
}

// The same text under another name. A mission takes with it what stands beside it and is not there yet, so
// that it means the same.
text::Result<bool> OpenDocuments::save_as(OpenDocument& document, const std::string& path) {
  const std::string old_folder = fs::path(document.text.source()->name()).parent_path().string();
  const OpenDocument* there = store_.find(path);  // nothing but what an undone edit has left
  if (there != nullptr && there == mission_file_ && there != &document)
    return refused("file-exists", fmt::format("{} is the mission that is open", shown(path)));
  std::vector<OpenDocument*> overlays = overlays_;
  if (there != &document) std::erase(overlays, there);
  if (text::Result<bool> saved = store_.save_as(document, path); !saved) return saved;
  if (&document == mission_file_) {
    for (const documents::DocumentPtr& other : store_.all()) {
      other->is_writable = other->is_writable || std::exchange(other->is_detached, false);
    }
    store_.drafts().add_recent(path, mission_ ? mission_->name : "");
    take_along(overlays, old_folder, mission_folder());
  }
  check();
  return true;
}

// Overlays that are open go along with their text as it is; all else that the mission names has to be there.
void OpenDocuments::take_along(const std::vector<OpenDocument*>& overlays, const std::string& from_folder,
                               const std::string& to_folder) {
  if (from_folder == to_folder) return;
  for (OpenDocument* overlay : overlays) {
    const std::string below =
        fs::path(overlay->text.source()->name()).lexically_relative(from_folder).string();
    const auto to = project_.name_of((fs::path(to_folder) / below).string());
    if (below.starts_with("..") || !to || project_.is_file(*to) || store_.find(*to) != nullptr) continue;
    const text::Result<bool> saved = store_.save_as(*overlay, *to);
    notices_.push_back(saved ? fmt::format("saved its overlay as {}", shown(*to))
                             : fmt::format("its overlay was not saved along: {}", saved.error().message));
  }
}

text::Result<bool> OpenDocuments::create(const NewDocument& request, double now) {
  const std::string& path = request.path();
  if (!project_.is_writable(path))
    return refused(
        "cannot-write",
        fmt::format("{} can't be made: names end with .mdl or .odl, inside of the project", shown(path)));
  if (is_taken(path)) {
    const std::string_view rest = project_.is_file(path) ? "" : ", not saved yet";
    return refused("file-exists", fmt::format("there is {} already{}", shown(path), rest));
  }
  return request.kind() == NewDocument::OVERLAY ? create_overlay(path, now) : create_mission(path, now);
}

text::Result<bool> OpenDocuments::create_mission(const std::string& path, double now) {
  const fs::path overlay = fs::path(path).replace_extension(".odl");
  if (overlay == path) return refused("cannot-write", "a mission's name ends with .mdl");
  if (text::Result<bool> kept = keep_what_leaves(now); !kept) return kept;
  close();
  const bool has_overlay = is_taken(overlay.string());
  const std::string name = fs::path(path).stem().string();
  mission_file_ = &add(path, fmt::format(kNewMission, name, overlay.filename().string()));
  if (!has_overlay) add(overlay.string(), kNewOverlay);
  check();
  return true;
}

text::Result<bool> OpenDocuments::create_overlay(const std::string& path, double now) {
  if (!is_open()) return refused("no-mission", "an overlay belongs to a mission, and none is open");
  const std::string name = fs::path(project_.disk_path(path)).lexically_relative(mission_folder()).string();
  change({{&new_document(path), {{}, kEmptyOverlay}},
          {mission_file_, overlay_statement(mission_file_->text.source(), name)}},
         fmt::format("new overlay {}", path), now);
  return true;
}

}  // namespace mlab::console
