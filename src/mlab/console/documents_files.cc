#include <filesystem>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/document_parts.h"
#include "mlab/console/documents.h"
#include "mlab/console/mission_text.h"
#include "mlab/text/line_ends.h"

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

// A document's text with the line ends of its file.
std::string for_disk(const ProjectFolder& project, const OpenDocument& document) {
  return text::lines_as_in(project.read(document.path).value_or(""), std::string(document.source->text()));
}

}  // namespace

text::Result<bool> OpenDocuments::save_one(OpenDocument& document) {
  if (!document.is_writable) {
    return refused("read-only",
                   fmt::format("{} can't be changed: save it under another name", shown(document.path)));
  }
  const bool is_there = project_.is_file(document.path);
  if (is_there != document.saved.has_value()) {
    if (is_there)
      return refused(
          "changed-on-disk",
          fmt::format("{} has come into being meanwhile: save under another name", shown(document.path)));
  } else if (is_there) {
    const text::Result<std::string> on_disk = project_.read(document.path);
    if (!on_disk || text::unix_lines(*on_disk) != *document.saved)
      return refused("changed-on-disk",
                     fmt::format("{} has been changed by somebody else since it was opened: save "
                                 "under another name, or open it anew",
                                 shown(document.path)));
  }
  const text::Result<bool> written = project_.write(document.path, for_disk(project_, document));
  if (!written) return written;
  document.saved = std::string(document.source->text());
  document.draft.problem = drafts_.drop(document.path);
  document.draft.kept = 0;
  return true;
}

text::Result<bool> OpenDocuments::save(const SaveDocuments& request) {
  ++revision_;
  ++files_revision_;
  log_.separate();
  std::vector<OpenDocument*> wanted;
  for (const std::string& path : request.documents()) {
    OpenDocument* document = find(path);
    if (document == nullptr) return refused("no-document", fmt::format("{} is not open", shown(path)));
    wanted.push_back(document);
  }
  if (!request.as().empty()) {
    if (wanted.size() != 1)
      return refused("one-document", "one document at a time is saved under another name");
    return save_as(*wanted.front(), request.as());
  }
  if (wanted.empty()) {
    for (const Key key : shown_) {
      if (open_.at(key).is_dirty()) wanted.push_back(&open_.at(key));
    }
  }
  text::Result<bool> out = true;
  for (OpenDocument* document : wanted) {
    text::Result<bool> saved = save_one(*document);
    if (!saved && out) out = std::move(saved);
  }
  update_shown();
  return out;
}

void OpenDocuments::keep_drafts(double now, DraftKeeper::When when) {
  keeper_.look(now);
  for (auto& [key, document] : open_) {
    const std::string* file = document.saved ? &*document.saved : nullptr;
    const bool is_unsaved = document.is_dirty() && !document.is_nothing();
    keeper_.follow({document.path, document.source->text(), file, document.revision, is_unsaved},
                   document.draft, now, when);
  }
}

void OpenDocuments::sync_drafts(double now) {
  keep_drafts(now, DraftKeeper::When::kAtOnce);
  for (auto& [key, document] : open_) keeper_.sync(document.path, document.draft);
}

std::vector<std::string> OpenDocuments::losses() const {
  std::vector<std::string> out;
  for (const auto& [key, document] : open_) {
    if (!document.draft.problem.empty())
      out.push_back(fmt::format("{}: {}", shown(document.path), document.draft.problem));
  }
  return out;
}

std::string OpenDocuments::not_kept() const {
  const std::vector<std::string> lost = losses();
  return lost.empty() ? keeper_.folder_problem() : lost.front();
}

text::Result<bool> OpenDocuments::keep_what_leaves(double now) {
  keep_drafts(now, DraftKeeper::When::kAtOnce);
  const std::vector<std::string> lost = losses();
  if (lost.empty()) return true;
  return refused("not-kept", fmt::format("what is not saved would be lost: save it first, or undo it "
                                         "(it can't be kept as a draft: {})",
                                         lost.front()));
}

// The same text under another name. A mission takes with it what stands beside it and is not there yet, so
// that it means the same.
text::Result<bool> OpenDocuments::save_as(OpenDocument& document, const std::string& path) {
  if (is_taken(path)) return refused("file-exists", fmt::format("there is {} already", shown(path)));
  const text::Result<bool> written = project_.write(path, for_disk(project_, document));
  if (!written) return written;
  drafts_.drop(document.path);
  const std::string old_folder = fs::path(document.source->name()).parent_path().string();
  document.path = path;
  document.source = source_of(project_.disk_path(path), std::string(document.source->text()));
  document.saved = std::string(document.source->text());
  document.is_writable = true;
  document.draft = {};
  document.is_trial = false;
  if (document.is_mission) {
    for (auto& [key, other] : open_) {
      other.is_writable = other.is_writable || std::exchange(other.is_trial, false);
    }
    drafts_.add_recent(path, mission_ ? mission_->name : "");
    take_along(old_folder, fs::path(document.source->name()).parent_path().string());
  }
  check();
  return true;
}

// Overlays that are open go along with their text as it is; all else that the mission names has to be there.
void OpenDocuments::take_along(const std::string& from_folder, const std::string& to_folder) {
  if (from_folder == to_folder) return;
  for (const Key key : overlays_) {
    OpenDocument& overlay = open_.at(key);
    const std::string below = fs::path(overlay.source->name()).lexically_relative(from_folder).string();
    const auto to = project_.name_of((fs::path(to_folder) / below).string());
    if (below.starts_with("..") || !to || project_.is_file(*to) || find(*to) != nullptr) continue;
    if (const auto written = project_.write(*to, for_disk(project_, overlay)); !written) {
      notices_.push_back(fmt::format("its overlay was not saved along: {}", written.error().message));
      continue;
    }
    drafts_.drop(overlay.path);
    overlay.path = *to;
    overlay.source = source_of(project_.disk_path(*to), std::string(overlay.source->text()));
    overlay.saved = std::string(overlay.source->text());
    overlay.is_writable = true;
    overlay.draft = {};
    notices_.push_back(fmt::format("saved its overlay as {}", shown(*to)));
  }
}

text::Result<bool> OpenDocuments::create(const NewDocument& request, double now) {
  const std::string& path = request.path();
  if (!project_.is_writable(path))
    return refused(
        "cannot-write",
        fmt::format("{} can't be made: names end with .mdl or .odl, inside of the project", shown(path)));
  if (is_taken(path)) return refused("file-exists", fmt::format("there is {} already", shown(path)));
  return request.kind() == NewDocument::OVERLAY ? create_overlay(path, now) : create_mission(path, now);
}

text::Result<bool> OpenDocuments::create_mission(const std::string& path, double now) {
  const fs::path overlay = fs::path(path).replace_extension(".odl");
  if (overlay == path) return refused("cannot-write", "a mission's name ends with .mdl");
  const bool has_overlay = project_.is_file(overlay.string());
  if (text::Result<bool> kept = keep_what_leaves(now); !kept) return kept;
  close();
  const std::string name = fs::path(path).stem().string();
  OpenDocument mission;
  mission.path = path;
  mission.is_mission = true;
  mission.source =
      source_of(project_.disk_path(path), fmt::format(kNewMission, name, overlay.filename().string()));
  mission_file_ = add(std::move(mission));
  if (!has_overlay) {
    OpenDocument map;
    map.path = overlay.string();
    map.source = source_of(project_.disk_path(map.path), kNewOverlay);
    add(std::move(map));
  }
  check();
  return true;
}

text::Result<bool> OpenDocuments::create_overlay(const std::string& path, double now) {
  if (!is_open()) return refused("no-mission", "an overlay belongs to a mission, and none is open");
  const std::string name = fs::path(project_.disk_path(path)).lexically_relative(mission_folder()).string();
  const Splice line = overlay_statement(mission_document().source, name);
  commit(fmt::format("new overlay {}", path),
         {{new_document(path), 0, "", kEmptyOverlay}, {mission_file_, line.begin, "", line.text}}, now);
  return true;
}

}  // namespace mlab::console
