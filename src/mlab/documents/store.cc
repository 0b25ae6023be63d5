#include "mlab/documents/store.h"

#include <algorithm>
#include <ranges>
#include <utility>

#include <fmt/core.h>

#include "mlab/documents/merge.h"
#include "mlab/documents/refused.h"
#include "mlab/text/line_ends.h"
#include "mlab/text/utf8.h"

namespace mlab::documents {

Store::Store(ProjectFolder& project, const std::string& state_folder)
    : project_(project), drafts_(state_folder, project.folder()), keeper_(drafts_) {}

// ---- what is open

Document* Store::find(std::string_view path) const {
  const auto found =
      std::ranges::find(open_, path, [](const DocumentPtr& one) -> const std::string& { return one->path; });
  return found == open_.end() ? nullptr : found->get();
}

Document& Store::add(DocumentPtr document) {
  open_.push_back(std::move(document));
  return *open_.back();
}

void Store::close(std::string_view path) {
  std::erase_if(open_, [&](const DocumentPtr& one) { return one->path == path; });
}

text::Result<std::string> Store::read(const std::string& path) const {
  text::Result<std::string> content = project_.read(path);
  if (content) *content = text::unix_lines(text::as_utf8(*content));
  return content;
}

Store::Restored Store::restore_draft(Document& document, double now) {
  const std::optional<Drafts::Draft> draft = drafts_.find(document.path);
  if (!draft || !text::is_utf8(draft->text)) return Restored::kNothing;
  const bool is_other = draft->text != document.text.text();
  if (is_other) change(document, draft->text, "restore unsaved text", now);
  document.draft.kept = document.text.revision();
  if (!document.saved && draft->had_file) {
    document.older_file = draft->file_digest;
    document.disk = Document::Disk::kGone;
    return Restored::kTextOfGoneFile;
  }
  if (!is_other) return Restored::kNothing;
  const bool is_of_older_file = document.saved && draft->file_digest != Drafts::digest(*document.saved);
  document.older_file = is_of_older_file ? draft->file_digest : "";
  return is_of_older_file ? Restored::kTextOfOlderFile : Restored::kText;
}

std::vector<std::string> Store::only_kept() const {
  std::vector<std::string> out = drafts_.paths();
  std::erase_if(out, [&](const std::string& path) { return project_.is_file(path); });
  return out;
}

// ---- changes

void Store::change(const std::vector<Change>& changes, std::string name, double now, bool merges) {
  struct Step {
    std::weak_ptr<Document> document;  // which may own the log that owns this
    std::uint32_t begin = 0;
    std::string removed;
    std::string inserted;

    void replace(const std::string& was, const std::string& is) const {
      const DocumentPtr in = document.lock();
      if (in == nullptr) return;
      const text::Span span{begin, begin + static_cast<std::uint32_t>(was.size())};
      in->text.set(text::spliced(in->text.text(), {span, is}));
    }
  };
  for (const Change& one : changes) {  // where a draft was undone, what comes now is of the file as it stands
    Document& to = *one.document;
    if (to.is_of_older_file() && to.saved && !to.is_changed_here()) to.older_file.clear();
  }
  const auto steps = std::make_shared<std::vector<Step>>();
  for (const Change& one : changes) {
    const auto owner = std::ranges::find(open_, one.document, &DocumentPtr::get);
    const std::string removed(one.document->text.source()->text(one.splice.span));
    const text::Splice less = text::difference(removed, one.splice.text);
    if (removed == one.splice.text) continue;
    steps->push_back({*owner, one.splice.span.begin + less.span.begin,
                      removed.substr(less.span.begin, less.span.end - less.span.begin), less.text});
    steps->back().replace(steps->back().removed, steps->back().inserted);
  }
  if (steps->empty()) return;
  const auto undo = [steps] {
    for (const Step& step : std::views::reverse(*steps)) step.replace(step.inserted, step.removed);
  };
  const auto redo = [steps] {
    for (const Step& step : *steps) step.replace(step.removed, step.inserted);
  };
  changes.front().document->log->add({std::move(name), undo, redo, merges}, now);
}

void Store::change(Document& document, std::string_view text, std::string name, double now, bool merges) {
  if (text == document.text.text()) return;
  change({{&document, text::difference(document.text.text(), text)}}, std::move(name), now, merges);
}

// ---- files

text::Result<bool> Store::write(Document& document, const std::string& path) {
  const std::string as_before = project_.read(document.path).value_or("");
  const text::Result<bool> written =
      project_.write(path, text::lines_as_in(as_before, std::string(document.text.text())));
  if (!written) return written;
  document.draft = {};
  document.draft.problem = drafts_.drop(document.path);
  document.saved = std::string(document.text.text());
  document.older_file.clear();
  document.disk = Document::Disk::kSame;
  document.disk_text.clear();
  document.log->separate();
  return true;
}

text::Result<bool> Store::save(Document& document, bool overwrites) {
  const std::string& path = document.path;
  if (!document.is_writable || document.is_detached) {
    return refused("read-only", fmt::format("{} can't be changed: save it under another name", shown(path)));
  }
  if (!overwrites && project_.is_file(path)) {
    if (!document.saved)
      return refused("file-exists", fmt::format("there is {} already: save under another name", shown(path)));
    const text::Result<std::string> content = read(path);
    const bool is_of_other_file = document.is_of_older_file() && document.is_changed_here();
    if (!content || *content != *document.saved || is_of_other_file) {
      document.disk = Document::Disk::kChanged;
      document.disk_text = content.value_or("");
      return refused("changed-on-disk",
                     fmt::format("{} has been changed by somebody else since it was opened", shown(path)));
    }
  }
  return write(document, path);
}

text::Result<bool> Store::save_as(Document& document, const std::string& path, bool overwrites) {
  if (path == document.path) return save(document, overwrites);
  const Document* open = find(path);
  if (open != nullptr && !open->is_nothing())
    return refused("file-exists", fmt::format("{} is open already", shown(path)));
  if (!overwrites && project_.is_file(path))
    return refused("file-exists", fmt::format("there is {} already", shown(path)));
  if (const text::Result<bool> written = write(document, path); !written) return written;
  if (open != nullptr) close(path);
  document.path = path;
  document.text.rename(project_.disk_path(path));
  document.is_writable = true;
  document.is_detached = false;
  return true;
}

text::Result<bool> Store::reload(Document& document, bool merge, double now) {
  text::Result<std::string> content = read(document.path);
  if (!content) return std::unexpected(content.error());
  if (merge && document.is_of_older_file()) {
    return refused("conflict",
                   "what the file was when this was typed is not known: one of the two has to give way");
  }
  if (merge && document.saved) {
    const std::optional<std::string> both = merged(*document.saved, document.text.text(), *content);
    if (!both)
      return refused("conflict",
                     "the same lines were changed here and on disk: one of the two has to give way");
    change(document, *both, "merge with the file", now, false);
  } else {
    change(document, *content, "load the file anew", now, false);
  }
  document.saved = std::move(*content);
  document.older_file.clear();
  document.disk = Document::Disk::kSame;
  document.disk_text.clear();
  return true;
}

std::vector<Store::Seen> Store::look_at_disk(double now) {
  std::vector<Seen> out;
  for (const DocumentPtr& one : open_) {
    const bool has_had_file = one->saved || one->disk == Document::Disk::kGone;
    if (!has_had_file || one->is_detached) continue;
    if (const std::optional<News> news = look_at_file(*one, now)) out.push_back({one.get(), *news});
  }
  return out;
}

// What somebody is writing just now reads otherwise at the next look.
bool Store::has_settled(Document& document, const std::string& content) {
  const bool is_known = content == document.text.text() || (document.saved && content == *document.saved) ||
                        (document.disk == Document::Disk::kChanged && content == document.disk_text);
  std::string digest = is_known ? std::string() : Drafts::digest(content);
  const bool was_seen = std::exchange(document.disk_seen, digest) == digest;
  return is_known || was_seen;
}

std::optional<Store::News> Store::look_at_file(Document& document, double now) {
  using Disk = Document::Disk;
  if (!project_.is_file(document.path)) {
    if (std::exchange(document.disk, Disk::kGone) == Disk::kGone) return std::nullopt;
    return News::kGone;
  }
  text::Result<std::string> content = read(document.path);
  if (!content || !has_settled(document, *content)) return std::nullopt;
  if (!document.saved) {  // opened while it was gone
    if (Drafts::digest(*content) == document.older_file) document.older_file.clear();
    document.saved = *content;
  }
  const bool was_dirty = document.is_dirty();
  const bool is_asked = document.is_of_older_file() && document.is_changed_here();
  if (*content == document.text.text() || (!is_asked && *content == *document.saved)) {
    if (*content == document.text.text()) document.older_file.clear();
    document.saved = std::move(*content);
    const bool was_other = std::exchange(document.disk, Disk::kSame) != Disk::kSame;
    if (!was_other && was_dirty == document.is_dirty()) return std::nullopt;
    return News::kSameAgain;
  }
  if (!document.is_changed_here()) {
    change(document, *content, "take over the changed file", now, false);
    document.saved = std::move(*content);
    document.disk = Disk::kSame;
    ++document.taken_over;
    return News::kTakenOver;
  }
  if (document.disk == Disk::kChanged && document.disk_text == *content) return std::nullopt;
  document.disk = Disk::kChanged;
  document.disk_text = std::move(*content);
  return News::kChanged;
}

// ---- drafts

void Store::keep_draft(Document& document, double now, DraftKeeper::When when) {
  if (document.is_detached) return;
  const std::string* file = document.saved ? &*document.saved : nullptr;
  keeper_.follow({document.path, document.text.text(), file, document.text.revision(), document.is_dirty(),
                  document.older_file},
                 document.draft, now, when);
}

void Store::keep_drafts(double now, DraftKeeper::When when) {
  keeper_.look(now);
  for (const DocumentPtr& one : open_) keep_draft(*one, now, when);
}

void Store::sync_drafts(double now) {
  keep_drafts(now, DraftKeeper::When::kAtOnce);
  for (const DocumentPtr& one : open_) keeper_.sync(one->path, one->draft);
}

std::vector<Store::Loss> Store::losses() const {
  std::vector<Loss> out;
  for (const DocumentPtr& one : open_) {
    if (!one->draft.problem.empty()) out.push_back({one.get(), one->draft.problem});
  }
  return out;
}

}  // namespace mlab::documents
