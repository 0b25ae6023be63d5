#include "mlab/designer/session/publisher.h"

#include <utility>

#include <fmt/core.h>

#include "mlab/designer/drawing/titles.h"

namespace mlab::designer {

void Publisher::greet(console::ConnectionId to) {
  browsers_[to].lists = from_.desk.lists_number();
  FromDesigner message;
  *message.mutable_hello() = from_.start_page.hello();
  from_.clients.send(to, message);
}

void Publisher::publish() {
  ++round_;
  for (const auto& [to, client] : from_.clients.all()) {
    if (client.has_greeted) publish_to(to, client);
  }
  std::erase_if(browsers_, [&](const auto& known) { return from_.clients.find(known.first) == nullptr; });
}

void Publisher::publish_to(console::ConnectionId to, const Client& client) {
  Browser& browser = browsers_[to];
  FromDesigner message;
  if (std::exchange(browser.lists, from_.desk.lists_number()) != from_.desk.lists_number()) {
    *message.mutable_lists() = from_.start_page.lists();
    from_.clients.send(to, message);
  }
  if (browser.not_kept != from_.keeping.why_not()) {
    browser.not_kept = from_.keeping.why_not();
    message.mutable_keeping()->set_not_kept(browser.not_kept);
    from_.clients.send(to, message);
  }
  std::map<std::uint64_t, Opening> openings;
  for (const auto& [path, opening] : client.documents) {
    const OpenConfiguration* document = from_.desk.find(path);
    if (document == nullptr) continue;
    Opening& told = openings[opening] = std::move(browser.openings[opening]);
    const View view{to, client, *document, told};
    publish_file(view);
    publish_document(view);
    publish_pages(view);
    publish_differences(view);
    publish_tests(view);
    // What is no longer looked at is sent anew when somebody looks again.
    std::erase_if(told.topics, [&](const auto& topic) { return topic.second.round != round_; });
  }
  browser.openings = std::move(openings);
}

void Publisher::tell(const View& view, const std::string& topic, const std::optional<std::string>& version,
                     const std::function<void(FromDesigner& out)>& write) const {
  const auto [known, is_new] = view.told.topics.try_emplace(topic);
  LastMessage& told = known->second;
  told.round = round_;
  if (!is_new && version && told.version == version) return;
  told.version = version;
  FromDesigner message;
  write(message);
  std::string bytes = message.SerializeAsString();
  if (bytes == told.bytes) return;
  told.bytes = bytes;
  from_.clients.send_bytes(view.to, std::move(bytes));
}

// ---- the topics of a document

// What has become of its file. Whoever opens a document that is as its file need not be told.
void Publisher::publish_file(const View& view) const {
  using Disk = documents::Document::Disk;
  const OpenConfiguration& document = view.document;
  Opening& told = view.told;
  const bool is_new = !told.file_news.has_value();
  const bool is_taken_over = !is_new && told.taken_over != document.taken_over;
  const bool is_told = is_new ? document.disk == Disk::kSame : told.file_news == document.file_news;
  told.file_news = document.file_news;
  told.taken_over = document.taken_over;
  if (is_told) return;
  FromDesigner message;
  FileChanged& changed = *message.mutable_file_changed();
  changed.set_document(document.path);
  changed.set_is_gone(document.disk == Disk::kGone);
  changed.set_is_dirty_here(document.disk != Disk::kSame);
  changed.set_is_same_again(document.disk == Disk::kSame && !is_taken_over);
  from_.clients.send(view.to, message);
}

void Publisher::publish_document(const View& view) const {
  const OpenConfiguration& document = view.document;
  tell(
      view, "document",
      fmt::format("{} {} {} {} {}", document.text.revision(), document.model_number, document.compiled_number,
                  document.saved ? document.is_dirty() : true, document.is_writable),
      [&](FromDesigner& out) { *out.mutable_document() = document_message(document); });
  if (const Marks* marks = from_.marks.find(document.path)) {
    tell(view, "marks", std::nullopt, [&](FromDesigner& out) {
      out.mutable_marks()->set_document(document.path);
      marks->encode(*out.mutable_marks());
    });
  }
  tell(view, "palette",
       fmt::format("{} {} {}", document.model_number, from_.desk.offered_number(), document.is_writable),
       [&](FromDesigner& out) {
         const DrawingContext context = from_.desk.context(document);
         *out.mutable_palette() = palette_of(*document.drawn, context);
         add_offered(from_.desk.offered(document), context, *out.mutable_palette());
       });
}

void Publisher::publish_pages(const View& view) const {
  const OpenConfiguration& document = view.document;
  for (const Page& page : view.client.pages) {
    if (page.document() != document.path) continue;
    tell(view, "drawing " + page.path(),
         fmt::format("{} {} {}", document.drawn_revision, document.model_number, document.is_writable),
         [&](FromDesigner& out) {
           DrawingContext context = from_.desk.context(document);
           context.revision = document.drawn_revision;
           *out.mutable_drawing() = draw(*document.drawn, page.path(), context);
         });
  }
}

void Publisher::publish_differences(const View& view) const {
  const OpenConfiguration& document = view.document;
  const Comparisons::Comparison* shown = from_.comparisons.find(view.to, document.path);
  if (shown == nullptr) return;
  const Comparing& comparing = shown->comparing;
  const std::string version =
      fmt::format("{} {} {}", shown->number, comparing.number(), document.is_outdated());
  tell(view, "differences", version, [&](FromDesigner& out) {
    *out.mutable_differences() = comparing.list();
    out.mutable_differences()->set_document(document.path);
    if (document.is_outdated())
      out.mutable_differences()->set_trouble(
          "the text can't be read right now: this is of the last that could");
  });
  for (const Page& page : view.client.pages) {
    if (page.document() != document.path || page.path().find('/') != std::string::npos) continue;
    tell(view, "difference " + page.path(), version, [&](FromDesigner& out) {
      *out.mutable_page_difference() = comparing.page(page.path(), from_.desk.context(document));
    });
  }
}

void Publisher::publish_tests(const View& view) const {
  const OpenConfiguration& document = view.document;
  if (!from_.tests.is_watched_by(view.to, document.path)) return;
  tell(view, "tests", fmt::format("{}", from_.tests.number()),
       [&](FromDesigner& out) { *out.mutable_tests() = from_.tests.list(document); });
}

// ---- messages

Document Publisher::document_message(const OpenConfiguration& document) const {
  Document out;
  out.set_path(document.path);
  if (Desk::is_new(document.path)) out.set_title(unsaved_title(document.text.text()));
  out.set_text(std::string(document.text.text()));
  out.set_revision(document.text.revision());
  out.set_is_dirty(document.is_dirty());
  out.set_is_read_only(!document.is_writable);
  out.set_undo(document.log->undo_name());
  out.set_redo(document.log->redo_name());
  out.set_is_outdated(document.is_outdated());
  out.set_compile_ms(document.compile_ms);
  add_found_problems(document, out);
  add_declarations(*document.drawn, out);
  return out;
}

// Until the text has been compiled, what reading it found.
void Publisher::add_found_problems(const OpenConfiguration& document, Document& out) const {
  const DrawingContext context = from_.desk.context(document);
  const text::Diagnostics& found =
      document.compiled ? document.compiled->problems : document.model->problems();
  for (std::size_t i = 0; i < found.items().size(); ++i) {
    Problem& problem = *out.add_problems();
    problem = problem_of(found.items()[i], *document.model, context);
    if (!document.compiled || i >= document.compiled->fixes.size()) continue;
    for (const assist::Fix& fix : document.compiled->fixes[i]) {
      Fix& offered = *problem.add_fixes();
      offered.set_title(fix.title);
      for (const assist::Splice& splice : fix.splices) {
        Fix::Splice& written = *offered.add_splices();
        written.set_begin(splice.span.begin);
        written.set_end(splice.span.end);
        written.set_text(splice.text);
      }
    }
  }
  if (!document.compiled || !document.code || document.code->code != document.compiled->code) return;
  for (const text::Diagnostic& d : document.code->problems.items())
    *out.add_problems() = problem_of(d, *document.model, context);
}

}  // namespace mlab::designer
