// What everybody is told of what he looks at.

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/designer_parts.h"
#include "mlab/designer/titles.h"

namespace mlab::designer {
namespace {

// Between two beats [s]: a little less than the loop waits at most.
constexpr double kBeatPause = 0.2;

}  // namespace

void Designer::Parts::publish() {
  settle();
  for (auto& [path, marks] : marks_) {
    const OpenConfiguration* one = desk_.find(path);
    if (one != nullptr && marks.follow(one->drawn)) keep_marks(path, marks);
  }
  for (auto& [to, client] : clients_) publish_to(to, client);
}

void Designer::Parts::publish_to(console::ConnectionId to, Client& client) {
  for (const std::string& path : client.documents) {
    const OpenConfiguration* one = desk_.find(path);
    if (one == nullptr) continue;
    const auto is_new = [&](const char* what, const std::string& version) {
      return std::exchange(client.sent[what + path + ' '], version) != version;
    };
    FromDesigner message;
    if (is_new("version ",
               fmt::format("{} {} {} {} {}", one->text.revision(), one->model_number, one->compiled_number,
                           one->saved ? one->is_dirty() : true, one->is_writable))) {
      *message.mutable_document() = document_message(*one);
      send_once(to, client, "document " + path + ' ', message);
    }
    if (marks_.contains(path)) {
      message.Clear();
      *message.mutable_marks() = marks_message(path);
      send_once(to, client, "marks " + path + ' ', message);
    }
    if (!is_new("components ",
                fmt::format("{} {} {}", one->model_number, desk_.offered_number(), one->is_writable)))
      continue;
    message.Clear();
    *message.mutable_palette() = palette_of(*one->drawn, desk_.context(*one));
    add_offered(desk_.offered(*one), desk_.context(*one), *message.mutable_palette());
    send_once(to, client, "palette " + path + ' ', message);
  }
  for (const Page& page : client.pages) {
    OpenConfiguration* one = desk_.find(page.document());
    if (one == nullptr || !client.documents.contains(page.document())) continue;
    DrawingContext context = desk_.context(*one);
    context.revision = one->drawn_revision;
    const std::string version =
        fmt::format("{} {} {}", one->drawn_revision, one->model_number, one->is_writable);
    const std::string what = "drawing " + page.document() + ' ' + page.path();
    if (std::exchange(client.sent["version of " + what], version) == version) continue;
    FromDesigner message;
    *message.mutable_drawing() = draw(*one->drawn, page.path(), context);
    send_once(to, client, what, message);
  }
  publish_differences(to, client);
  publish_tests(to, client);
  // What is no longer looked at is sent anew when somebody looks again.
  std::erase_if(client.sent, [&](const auto& sent) {
    const std::string& what = sent.first;
    if (!what.starts_with("drawing ") && !what.starts_with("version of ")) return false;
    return std::ranges::none_of(client.pages, [&](const Page& page) {
      return what.ends_with("drawing " + page.document() + ' ' + page.path());
    });
  });
}

MarkList Designer::Parts::marks_message(const std::string& path) const {
  MarkList out;
  out.set_document(path);
  marks_.at(path).encode(out);
  return out;
}

Document Designer::Parts::document_message(const OpenConfiguration& one) const {
  Document out;
  out.set_path(one.path);
  if (Desk::is_new(one.path)) out.set_title(unsaved_title(one.text.text()));
  out.set_text(std::string(one.text.text()));
  out.set_revision(one.text.revision());
  out.set_is_dirty(one.is_dirty());
  out.set_is_read_only(!one.is_writable);
  out.set_undo(one.log->undo_name());
  out.set_redo(one.log->redo_name());
  out.set_is_outdated(one.is_outdated());
  out.set_compile_ms(one.compile_ms);
  add_found_problems(one, out);
  add_declarations(*one.drawn, out);
  return out;
}

// Until the text has been compiled, what reading it said.
void Designer::Parts::add_found_problems(const OpenConfiguration& one, Document& out) const {
  const DrawingContext context = desk_.context(one);
  const text::Diagnostics& said = one.compiled ? one.compiled->problems : one.model->problems();
  for (std::size_t i = 0; i < said.items().size(); ++i) {
    Problem& problem = *out.add_problems();
    problem = problem_of(said.items()[i], *one.model, context);
    if (!one.compiled || i >= one.compiled->fixes.size()) continue;
    for (const language::Fix& fix : one.compiled->fixes[i]) {
      Fix& offered = *problem.add_fixes();
      offered.set_title(fix.title);
      for (const language::Splice& splice : fix.splices) {
        Fix::Splice& one_splice = *offered.add_splices();
        one_splice.set_begin(splice.span.begin);
        one_splice.set_end(splice.span.end);
        one_splice.set_text(splice.text);
      }
    }
  }
  if (!one.compiled || !one.code || one.code->code != one.compiled->code) return;
  for (const text::Diagnostic& d : one.code->problems.items())
    *out.add_problems() = problem_of(d, *one.model, context);
}

void Designer::Parts::send_once(console::ConnectionId to, Client& client, const std::string& what,
                                const FromDesigner& message) {
  std::string bytes = message.SerializeAsString();
  std::string& sent = client.sent[what];
  if (sent == bytes) return;
  sent = bytes;
  send_(to, std::make_shared<const std::string>(std::move(bytes)));
}

void Designer::Parts::send(console::ConnectionId to, const FromDesigner& message) {
  send_(to, std::make_shared<const std::string>(message.SerializeAsString()));
}

void Designer::Parts::send_beat(console::ConnectionId to, const Client& client) {
  FromDesigner message;
  message.mutable_beat()->set_number(client.beat);
  send(to, message);
}

void Designer::Parts::send_beats() {
  if (now() - last_beats_ < kBeatPause) return;
  last_beats_ = now();
  for (const auto& [to, client] : clients_) {
    if (client.has_greeted) send_beat(to, client);
  }
}

}  // namespace mlab::designer
