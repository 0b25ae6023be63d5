#include "mlab/designer/session/document_orders.h"

#include <utility>

#include "mlab/designer/edit/edit.h"
#include "mlab/text/utf8.h"

namespace mlab::designer {

// ---- files

void DocumentOrders::open(const Sender& sender, const Open& request, Answer& out) {
  const text::Result<OpenConfiguration*> found = desk_.open(request.path(), wall_time());
  if (!found) {
    fail(out, found.error());
    return;
  }
  const std::string& path = (*found)->path;
  clients_.open(sender.client, path);
  if (request.path().empty()) keepers_.gone(path);  // an earlier one that was called so
  keepers_.opened(**found);
  out.set_text(path);
}

void DocumentOrders::close(const Sender& sender, const Close& request) {
  leave(sender.client, request.document());
}

void DocumentOrders::leave(Client& client, const std::string& document) {
  clients_.close(client, document);
  if (!clients_.is_open(document)) desk_.close(document);
}

void DocumentOrders::discard(const Sender& sender, const Discard& request, Answer& out) {
  const std::string& path = request.document();
  const bool is_elsewhere = clients_.is_open_beside(sender.client, path);
  const bool has_file = !Desk::is_new(path) && (desk_.project().is_file(path) || !desk_.drafts().find(path));
  if (is_elsewhere || has_file) {
    refuse(out, is_elsewhere ? "another window has it open: close that first"
                             : "only what has no file can be thrown away");
    return;
  }
  desk_.discard(path);
  leave(sender.client, path);
  keepers_.gone(path);
}

void DocumentOrders::save(const Save& request, Answer& out) {
  OpenConfiguration* document = opened(desk_, request.document(), out);
  if (document == nullptr) return;
  const std::string before = document->path;
  const text::Result<std::string> saved = desk_.save(*document, request);
  if (!saved) {
    fail(out, saved.error());
    return;
  }
  out.set_text(*saved);
  if (*saved == before) return;
  keepers_.renamed(before, *saved);
  clients_.rename(before, *saved);
}

void DocumentOrders::reload(const Reload& request, Answer& out) {
  OpenConfiguration* document = opened(desk_, request.document(), out);
  if (document == nullptr) return;
  const text::Result<bool> done = desk_.reload(*document, request.merge(), wall_time());
  if (!done) fail(out, done.error());
}

void DocumentOrders::list_files(const ListFiles& request, Answer& out) {
  const auto entries = desk_.project().list(request.folder());
  if (!entries) {
    fail(out, entries.error());
    return;
  }
  console::FileList& files = *out.mutable_files();
  files.set_folder(request.folder());
  for (const documents::ProjectFolder::Entry& entry : *entries) {
    console::FileList::Entry& file = *files.add_entries();
    file.set_path(entry.path);
    file.set_is_folder(entry.is_folder);
    file.set_kind(entry.path.ends_with(".cdl") ? "configuration" : entry.kind);
  }
}

// ---- changes

void DocumentOrders::edit_text(const EditText& request, Answer& out) {
  OpenConfiguration* document = editable(desk_, request.document(), out);
  if (document == nullptr) return;
  const std::string_view text = document->text.text();
  const bool is_stale = request.revision() != document->text.revision();
  const bool is_inside = request.begin() <= request.end() && request.end() <= text.size() &&
                         text::is_character_boundary(text, request.begin()) &&
                         text::is_character_boundary(text, request.end());
  const bool fits = request.text().size() + text.size() <= text::Source::kMaxBytes;
  if (is_stale || !is_inside || !fits) {
    refuse(out, is_stale ? "the text has changed meanwhile" : "this is no place of the text");
    return;
  }
  desk_.store().change({{document, {{request.begin(), request.end()}, request.text()}}},
                       request.name().empty() ? "type" : request.name(), wall_time());
}

void DocumentOrders::edit(const Edit& request, Answer& out) {
  OpenConfiguration* document = editable(desk_, request.document(), out);
  if (document == nullptr) return;
  if (document->is_outdated()) {
    refuse(out, "the text has a slip of grammar: mend it first, or undo it");
    return;
  }
  text::Result<Edited> done = edited(document->drawn, desk_.environment(), request, desk_.offered(*document));
  if (!done) {
    fail(out, done.error());
    return;
  }
  if (done->text.size() > text::Source::kMaxBytes) {
    refuse(out, "the text would be too long");
    return;
  }
  // Moving the same node on and on is one step.
  const bool may_merge = request.changes(0).has_arrange() || request.changes(0).has_set_value();
  desk_.store().change(*document, done->text, std::move(done->name), wall_time(), may_merge);
}

void DocumentOrders::undo(const Undo& request, Answer& out) {
  OpenConfiguration* document = editable(desk_, request.document(), out);
  if (document != nullptr && !document->log->undo()) refuse(out, "there is nothing to undo");
}

void DocumentOrders::redo(const Redo& request, Answer& out) {
  OpenConfiguration* document = editable(desk_, request.document(), out);
  if (document != nullptr && !document->log->redo()) refuse(out, "there is nothing to do again");
}

void DocumentOrders::copy(const Copy& request, Answer& out) {
  const OpenConfiguration* document = opened(desk_, request.document(), out);
  if (document == nullptr) return;
  text::Result<std::string> text = copied(*document->drawn, request);
  if (!text) {
    fail(out, text.error());
    return;
  }
  out.set_text(std::move(*text));
}

}  // namespace mlab::designer
