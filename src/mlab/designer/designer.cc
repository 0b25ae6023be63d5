#include "mlab/designer/designer.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/utf8.h"
#include "mlab/designer/designer_parts.h"
#include "mlab/designer/open_text.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

constexpr double kDiskPause = 1.0;  // between two looks at the files [s]
constexpr std::uint32_t kProtocol = 1;

std::string file_title(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::size_t colon = path.find(':');
  const std::size_t begin = slash != std::string::npos   ? slash + 1
                            : colon != std::string::npos ? colon + 1
                                                         : 0;
  return path.substr(begin);
}

robot::ProgramSources programs(const DesignerSettings& settings) {
  robot::ProgramSources out;
  out.include_root = settings.include_root;
  out.version = settings.version;
  out.checks_code = settings.may_compile;
  return out;
}

console::Project::Entry& add_entry(google::protobuf::RepeatedPtrField<console::Project::Entry>& into,
                                   const std::string& path, const std::string& title) {
  console::Project::Entry& entry = *into.Add();
  entry.set_path(path);
  entry.set_title(title);
  return entry;
}

using Entries = google::protobuf::RepeatedPtrField<console::Project::Entry>;

/// A configuration that has a file, with what it says of itself; that is read of so many only.
void add_file(Entries& into, const console::ProjectFolder& project, const std::string& path) {
  constexpr int kMostRead = 100;
  std::string title = file_title(path);
  if (title.ends_with(".cdl") && title.size() > 4) title.resize(title.size() - 4);
  console::Project::Entry& entry = add_entry(into, path, title);
  if (into.size() > kMostRead) return;
  if (const text::Result<std::string> text = project.read(path)) entry.set_about(said_of(*text));
}

}  // namespace

Designer::Designer(DesignerSettings settings, Send send)
    : parts_(std::make_unique<Parts>(std::move(settings), std::move(send))) {}
Designer::~Designer() = default;

void Designer::receive(console::ConnectionId from, std::unique_ptr<ToDesigner> message) {
  parts_->receive(from, std::move(message));
}
void Designer::closed(console::ConnectionId connection) {
  parts_->closed(connection);
}

Designer::Parts::Parts(DesignerSettings settings, Send send)
    : settings_(std::move(settings)),
      send_(std::move(send)),
      desk_({settings_.project_folder, settings_.example_folder, settings_.state_folder}),
      mark_store_(settings_.state_folder.empty() ? "" : settings_.state_folder + "/designer",
                  desk_.project().folder()),
      compiler_(
          programs(settings_),
          [this](const std::string& document, const std::shared_ptr<const Compiled>& compiled) {
            inbox_->post([this, document, compiled] { desk_.take(document, compiled); });
          },
          [this](const std::string& document, const std::shared_ptr<const CheckedCode>& code) {
            inbox_->post([this, document, code] { desk_.take(document, code); });
          }) {
  thread_ = std::thread([this] { work(); });
}

Designer::Parts::~Parts() {
  ends_ = true;
  jobs_end_.request_stop();
  inbox_->wake();
  thread_.join();
}

void Designer::Parts::receive(console::ConnectionId from, std::unique_ptr<ToDesigner> message) {
  inbox_->post([this, from, message = std::shared_ptr<const ToDesigner>(std::move(message))] {
    handle(from, *message);
  });
}

void Designer::Parts::closed(console::ConnectionId connection) {
  inbox_->post([this, connection] {
    const auto client = clients_.find(connection);
    if (client == clients_.end()) return;
    for (const std::string& path : client->second.documents) {
      OpenConfiguration* one = desk_.find(path);
      if (one != nullptr) one->draft_time = -1e9;
    }
    clients_.erase(client);
  });
}

double Designer::Parts::now() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void Designer::Parts::work() {
  if (!settings_.open.empty()) {
    const text::Result<OpenConfiguration*> opened = desk_.open_on_disk(settings_.open, now());
    if (opened)
      first_ = (*opened)->path;
    else
      first_error_ = opened.error().message;
  }
  while (!ends_) {
    const auto wake = std::chrono::steady_clock::now() + std::chrono::milliseconds(250);
    std::vector<console::Inbox::Task> tasks = inbox_->wait_until(wake);
    while (!ends_) {
      for (const console::Inbox::Task& task : tasks) task();
      publish();
      send_answers();
      start_compilations();
      tasks = inbox_->wait_until(std::chrono::steady_clock::now());
      if (tasks.empty()) break;
    }
    if (now() - last_look_ > kDiskPause) look_at_disk();
    desk_.keep_drafts(now());
  }
  for (OpenConfiguration* one : desk_.all()) one->draft_time = -1e9;
  desk_.keep_drafts(0.0);
}

void Designer::Parts::start_compilations() {
  while (const OpenConfiguration* one = desk_.next_to_compile()) compiler_.start(desk_.task(*one));
}

void Designer::Parts::look_at_disk() {
  last_look_ = now();
  const std::vector<Desk::Change> changes = desk_.look_at_disk(last_look_);
  for (const Desk::Change& change : changes) {
    FromDesigner message;
    message.mutable_file_changed()->set_document(change.document->path);
    message.mutable_file_changed()->set_is_gone(change.is_gone);
    message.mutable_file_changed()->set_is_dirty_here(change.is_dirty_here);
    for (auto& [to, client] : clients_) {
      if (client.documents.contains(change.document->path)) send(to, message);
    }
  }
  publish();
}

void Designer::Parts::handle(console::ConnectionId from, const ToDesigner& message) {
  if (!message.has_edit_text()) settle();
  Client& client = clients_[from];
  Answer out;
  out.set_request(message.request());
  out.set_ok(true);
  if (!client.has_greeted && !message.has_greeting()) {
    out.set_ok(false);
    out.set_error("the first message has to be a Greeting");
  } else {
    answer(from, client, message, out);
  }
  if (std::exchange(is_deferred_, false) || message.request() == 0) return;
  FromDesigner reply;
  *reply.mutable_answer() = std::move(out);
  answers_.emplace_back(from, std::move(reply));
}

// After what they bring about has been told.
void Designer::Parts::send_answers() {
  for (const auto& [to, answer] : answers_) {
    if (clients_.contains(to)) send(to, answer);
  }
  answers_.clear();
}

void Designer::Parts::settle() {
  for (const std::string& path : std::exchange(typed_, {})) {
    if (OpenConfiguration* one = desk_.find(path)) desk_.changed(*one);
  }
}

void Designer::Parts::answer(console::ConnectionId from, Client& client, const ToDesigner& message,
                             Answer& out) {
  switch (message.body_case()) {
    case ToDesigner::kGreeting:
      greet(from, client, message.greeting(), out);
      return;
    case ToDesigner::kOpen:
      open(client, message.open(), out);
      return;
    case ToDesigner::kClose:
      close(client, message.close());
      return;
    case ToDesigner::kLook:
      client.pages.assign(message.look().pages().begin(), message.look().pages().end());
      return;
    case ToDesigner::kEditText:
      edit_text(message.edit_text(), out);
      return;
    case ToDesigner::kEdit:
      edit(message.edit(), out);
      return;
    case ToDesigner::kUndo:
      undo(message.undo().document(), false, out);
      return;
    case ToDesigner::kRedo:
      undo(message.redo().document(), true, out);
      return;
    case ToDesigner::kCopy:
      copy(message.copy(), out);
      return;
    case ToDesigner::kSave:
      save(message.save(), out);
      return;
    case ToDesigner::kReload:
      reload(message.reload(), out);
      return;
    case ToDesigner::kListFiles:
      list_files(message.list_files(), out);
      return;
    case ToDesigner::kDiscard:
      discard(client, message.discard(), out);
      return;
    case ToDesigner::kAskLanguage:
      ask_language(message.ask_language(), out);
      return;
    case ToDesigner::kDescribe:
      describe(message.describe(), out);
      return;
    case ToDesigner::kFits:
      fits(message.fits(), out);
      return;
    case ToDesigner::kFindLive:
      find_live(message.find_live(), out);
      return;
    case ToDesigner::kSetMark:
      set_mark(message.set_mark(), out);
      return;
    case ToDesigner::kRemoveMark:
      remove_mark(message.remove_mark(), out);
      return;
    case ToDesigner::kWriteBack:
      write_back(message.write_back(), out);
      return;
    case ToDesigner::kReadField:
      read_field(from, message.request(), message.read_field(), out);
      return;
    case ToDesigner::kTry:
      try_out(from, message.request(), message.try_(), out);
      return;
    default:
      out.set_ok(false);
      out.set_error("this designer does not know that request");
  }
}

void Designer::Parts::fail(Answer& out, const text::Diagnostic& why) const {
  out.set_ok(false);
  out.set_error(why.message);
  console::Diagnostic& d = *out.add_problems()->mutable_diagnostic();
  d.set_kind(why.kind);
  d.set_message(why.message);
  for (const std::string& hint : why.hints) d.add_hints(hint);
}

void Designer::Parts::greet(console::ConnectionId from, Client& client, const Greeting& greeting,
                            Answer& out) {
  if (greeting.protocol() != kProtocol) {
    out.set_ok(false);
    out.set_error(fmt::format("this server speaks protocol {}", kProtocol));
    return;
  }
  client.has_greeted = true;
  FromDesigner message;
  Hello& hello = *message.mutable_hello();
  hello.set_protocol(kProtocol);
  hello.set_version(settings_.version);
  hello.set_folder(desk_.project().name());
  hello.set_open(first_);
  Lists all = lists();
  hello.mutable_recent()->Swap(all.mutable_recent());
  hello.mutable_files()->Swap(all.mutable_files());
  for (const std::string& path : desk_.configurations("examples:"))
    add_file(*hello.mutable_examples(), desk_.project(), path);
  for (const std::string& path : desk_.overlays())
    add_entry(*hello.mutable_overlays(), path, file_title(path));
  send(from, message);
  if (!first_error_.empty()) {
    out.set_ok(false);
    out.set_error(first_error_);
  }
}

Lists Designer::Parts::lists() {
  Lists out;
  for (const std::string& path : desk_.drafts().new_files()) {
    const std::optional<console::Drafts::Draft> draft = desk_.drafts().find(path);
    if (draft)
      add_entry(*out.mutable_recent(), path, unsaved_title(draft->text)).set_about(said_of(draft->text));
  }
  for (const console::Drafts::Recent& recent : desk_.drafts().recent()) {
    if (desk_.project().is_file(recent.path)) add_file(*out.mutable_recent(), desk_.project(), recent.path);
  }
  for (const std::string& path : desk_.configurations(""))
    add_file(*out.mutable_files(), desk_.project(), path);
  return out;
}

void Designer::Parts::tell_lists() {
  FromDesigner message;
  *message.mutable_lists() = lists();
  for (const auto& [to, client] : clients_) {
    if (client.has_greeted) send(to, message);
  }
}

void Designer::Parts::open(Client& client, const Open& request, Answer& out) {
  const text::Result<OpenConfiguration*> opened = desk_.open(request.path(), now());
  if (!opened) {
    fail(out, opened.error());
    return;
  }
  const std::string& path = (*opened)->path;
  client.documents.insert(path);
  if (request.path().empty()) drop_marks(path);  // of an earlier one that was called so
  restore_marks(**opened);
  out.set_text(path);
}

void Designer::Parts::close(Client& client, const Close& request) {
  client.documents.erase(request.document());
  std::erase_if(client.pages, [&](const Page& page) { return page.document() == request.document(); });
  std::erase_if(client.sent, [&](const auto& one) {
    return one.first.find(' ' + request.document() + ' ') != std::string::npos;
  });
  for (const auto& [id, other] : clients_) {
    if (other.documents.contains(request.document())) return;
  }
  desk_.close(request.document());
}

void Designer::Parts::discard(Client& client, const Discard& request, Answer& out) {
  const std::string& path = request.document();
  const bool is_elsewhere = std::ranges::any_of(clients_, [&](const auto& other) {
    return &other.second != &client && other.second.documents.contains(path);
  });
  if (is_elsewhere || !Desk::is_new(path)) {
    out.set_ok(false);
    out.set_error(is_elsewhere ? "another window has it open: close that first"
                               : "only what has no file can be thrown away");
    return;
  }
  desk_.discard(path);
  Close close_it;
  close_it.set_document(path);
  close(client, close_it);
  drop_marks(path);
  tell_lists();
}

OpenConfiguration* Designer::Parts::editable(const std::string& path, Answer& out) {
  OpenConfiguration* one = desk_.find(path);
  const bool is_writable = one != nullptr && one->is_writable;
  if (is_writable) return one;
  out.set_ok(false);
  out.set_error(one == nullptr
                    ? fmt::format("`{}` is not open", text::shown(path, 200))
                    : fmt::format("`{}` is read only: save it under another name, or make your own copy",
                                  text::shown(path, 200)));
  return nullptr;
}

void Designer::Parts::edit_text(const EditText& request, Answer& out) {
  OpenConfiguration* one = editable(request.document(), out);
  if (one == nullptr) return;
  const std::string& text = one->text.text();
  const bool is_stale = request.revision() != one->text.revision();
  const bool is_inside = request.begin() <= request.end() && request.end() <= text.size() &&
                         console::is_character_boundary(text, request.begin()) &&
                         console::is_character_boundary(text, request.end());
  const bool fits = request.text().size() + text.size() <= text::Source::kMaxBytes;
  if (is_stale || !is_inside || !fits) {
    out.set_ok(false);
    out.set_error(is_stale ? "the text has changed meanwhile" : "this is no place of the text");
    return;
  }
  std::string changed = text;
  changed.replace(request.begin(), request.end() - request.begin(), request.text());
  one->text.change(std::move(changed), request.name().empty() ? "type" : request.name(), now(), true);
  typed_.insert(one->path);
}

void Designer::Parts::undo(const std::string& path, bool again, Answer& out) {
  OpenConfiguration* one = editable(path, out);
  if (one == nullptr) return;
  if (again ? one->text.redo() : one->text.undo()) {
    desk_.changed(*one);
    return;
  }
  out.set_ok(false);
  out.set_error(again ? "there is nothing to do again" : "there is nothing to undo");
}

void Designer::Parts::save(const Save& request, Answer& out) {
  OpenConfiguration* one = desk_.find(request.document());
  if (one == nullptr) {
    out.set_ok(false);
    out.set_error(fmt::format("`{}` is not open", text::shown(request.document(), 200)));
    return;
  }
  const std::string before = one->path;
  const text::Result<std::string> saved = desk_.save(*one, request);
  if (!saved) {
    fail(out, saved.error());
    if (saved.error().kind != "changed-on-disk") return;
    FromDesigner message;
    message.mutable_file_changed()->set_document(before);
    message.mutable_file_changed()->set_is_dirty_here(true);
    for (auto& [to, client] : clients_) {
      if (client.documents.contains(before)) send(to, message);
    }
    return;
  }
  out.set_text(*saved);
  if (*saved == before) return;
  if (last_trial_.document == before) last_trial_.document = *saved;
  if (auto marks = marks_.extract(before); !marks.empty()) {
    mark_store_.keep(*saved, marks.mapped());
    mark_store_.drop(before);
    marks_.insert_or_assign(*saved, std::move(marks.mapped()));
  }
  for (auto& [id, client] : clients_) {
    if (client.documents.erase(before) == 0) continue;
    client.documents.insert(*saved);
    for (Page& page : client.pages) {
      if (page.document() == before) page.set_document(*saved);
    }
  }
  tell_lists();
}

void Designer::Parts::reload(const Reload& request, Answer& out) {
  OpenConfiguration* one = desk_.find(request.document());
  if (one == nullptr) {
    out.set_ok(false);
    out.set_error(fmt::format("`{}` is not open", text::shown(request.document(), 200)));
    return;
  }
  const text::Result<bool> done = desk_.reload(*one, request.merge(), now());
  if (!done) fail(out, done.error());
}

void Designer::Parts::list_files(const ListFiles& request, Answer& out) {
  const auto entries = desk_.project().list(request.folder());
  if (!entries) {
    fail(out, entries.error());
    return;
  }
  console::FileList& files = *out.mutable_files();
  files.set_folder(request.folder());
  for (const console::ProjectFolder::Entry& entry : *entries) {
    console::FileList::Entry& one = *files.add_entries();
    one.set_path(entry.path);
    one.set_is_folder(entry.is_folder);
    one.set_kind(entry.path.ends_with(".cdl") ? "configuration" : entry.kind);
  }
}

// ---- what everybody is told

void Designer::Parts::publish() {
  settle();
  for (auto& [path, marks] : marks_) {
    const OpenConfiguration* one = desk_.find(path);
    if (one != nullptr && marks.follow(one->drawn)) mark_store_.keep(path, marks);
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
  out.set_text(one.text.text());
  out.set_revision(one.text.revision());
  out.set_is_dirty(one.is_dirty());
  out.set_is_read_only(!one.is_writable);
  out.set_undo(one.text.undo_name());
  out.set_redo(one.text.redo_name());
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

}  // namespace mlab::designer
