#include "mlab/designer/designer.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/component_tests/test_runs.h"
#include "mlab/designer/designer_parts.h"
#include "mlab/text/shown.h"
#include "mlab/text/utf8.h"

namespace mlab::designer {
namespace {

constexpr double kDiskPause = 1.0;  // between two looks at the files [s]

robot::ProgramSources programs(const DesignerSettings& settings) {
  robot::ProgramSources out;
  out.permission = settings.permission;
  out.include_root = settings.include_root;
  out.version = settings.version;
  out.limits = settings.limits;
  return out;
}

}  // namespace

Designer::Designer(DesignerSettings settings, Send send)
    : parts_(std::make_unique<Parts>(std::move(settings), std::move(send))) {}
Designer::~Designer() = default;

void Designer::receive(console::ConnectionId from, std::unique_ptr<ToDesigner> message) {
  parts_->receive(from, std::move(message));
}
std::vector<std::string> Designer::end() {
  return parts_->end();
}
void Designer::closed(console::ConnectionId connection) {
  parts_->closed(connection);
}

Designer::Parts::Parts(DesignerSettings settings, Send send)
    : settings_(std::move(settings)),
      send_(std::move(send)),
      desk_({settings_.project_folder, settings_.example_folder, settings_.state_folder}),
      texts_(desk_, documents::Drafts(settings_.state_folder, desk_.project().folder())),
      renaming_(desk_, texts_),
      mark_store_(settings_.state_folder.empty() ? "" : settings_.state_folder + "/designer",
                  desk_.project().folder()),
      compiler_(
          programs(settings_),
          [this](const std::string& document, const std::shared_ptr<const Compiled>& compiled) {
            inbox_->post([this, document, compiled] { desk_.take(document, compiled); });
          },
          [this](const std::string& document, const std::shared_ptr<const CheckedCode>& code) {
            inbox_->post([this, document, code] { desk_.take(document, code); });
          }),
      tests_(std::make_unique<TestRuns>(programs(settings_), [inbox = inbox_](std::function<void()> task) {
        inbox->post(std::move(task));
      })) {
  thread_ = std::thread([this] { work(); });
}

Designer::Parts::~Parts() {
  end();
}

std::vector<std::string> Designer::Parts::end() {
  ends_ = true;
  jobs_end_.request_stop();
  inbox_->wake();
  if (thread_.joinable()) thread_.join();
  std::vector<std::string> out = desk_.losses();
  for (const auto& [document, why] : unkept_marks_) out.push_back(why);
  return out;
}

void Designer::Parts::receive(console::ConnectionId from, std::unique_ptr<ToDesigner> message) {
  inbox_->post([this, from, message = std::shared_ptr<const ToDesigner>(std::move(message))] {
    handle(from, *message);
  });
}

void Designer::Parts::closed(console::ConnectionId connection) {
  inbox_->post([this, connection] {
    clients_.erase(connection);
    tests_->close(connection);
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
      keep_drafts();
      look_at_tests();
      publish();
      send_answers();
      start_compilations();
      tasks = inbox_->wait_until(std::chrono::steady_clock::now());
      if (tasks.empty()) break;
    }
    send_beats();
    if (now() - last_look_ > kDiskPause) look_at_disk();
    look_at_tests();
    keep_drafts();
  }
  desk_.store().sync_drafts(now());
}

// Whatever ends this process after an answer, what it answers is in the file system, or the page says that it
// is not.
void Designer::Parts::keep_drafts() {
  desk_.store().keep_drafts(now());
  keep_marks_again();
  tell_not_kept();
}

void Designer::Parts::tell_not_kept() {
  std::string why = desk_.not_kept();
  if (why.empty() && !unkept_marks_.empty()) why = unkept_marks_.begin()->second;
  if (why == not_kept_) return;
  not_kept_ = std::move(why);
  for (const auto& [to, client] : clients_) {
    if (client.has_greeted) send(to, keeping_message());
  }
  if (settings_.tell_not_kept) settings_.tell_not_kept(not_kept_);
}

FromDesigner Designer::Parts::keeping_message() const {
  FromDesigner out;
  out.mutable_keeping()->set_not_kept(not_kept_);
  return out;
}

void Designer::Parts::start_compilations() {
  while (const OpenConfiguration* one = desk_.next_to_compile()) compiler_.start(desk_.task(*one));
}

void Designer::Parts::look_at_disk() {
  last_look_ = now();
  for (const documents::Store::Seen& seen : desk_.look_at_disk(last_look_))
    tell_disk(*seen.document, seen.news == documents::Store::News::kTakenOver);
  publish();
}

FromDesigner Designer::Parts::disk_message(const documents::Document& one, bool is_taken_over) {
  using Disk = documents::Document::Disk;
  FromDesigner out;
  FileChanged& changed = *out.mutable_file_changed();
  changed.set_document(one.path);
  changed.set_is_gone(one.disk == Disk::kGone);
  changed.set_is_dirty_here(one.disk != Disk::kSame);
  changed.set_is_same_again(one.disk == Disk::kSame && !is_taken_over);
  return out;
}

void Designer::Parts::tell_disk(const documents::Document& one, bool is_taken_over) {
  const FromDesigner message = disk_message(one, is_taken_over);
  for (const auto& [to, client] : clients_) {
    if (client.documents.contains(one.path)) send(to, message);
  }
}

void Designer::Parts::handle(console::ConnectionId from, const ToDesigner& message) {
  if (message.has_beat()) {
    if (const auto known = clients_.find(from); known != clients_.end()) {
      known->second.beat = message.beat().number();
      send_beat(from, known->second);
    }
    return;
  }
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

// NOLINTNEXTLINE(readability-function-size): a row for each message
void Designer::Parts::answer(console::ConnectionId from, Client& client, const ToDesigner& message,
                             Answer& out) {
  switch (message.body_case()) {
    case ToDesigner::kGreeting:
      greet(from, client, message.greeting(), out);
      return;
    case ToDesigner::kOpen:
      open(from, client, message.open(), out);
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
    case ToDesigner::kFindUses:
      find_uses(message.find_uses(), out);
      return;
    case ToDesigner::kPlanRename:
      plan(message.plan_rename().at(), message.plan_rename().name(), out);
      return;
    case ToDesigner::kRenameEverywhere:
      rename_everywhere(message.rename_everywhere(), out);
      return;
    case ToDesigner::kUndoRename:
      undo_rename(out);
      return;
    case ToDesigner::kSearch:
      search(message.search(), out);
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
    case ToDesigner::kCompareWith:
      compare_with(from, client, message.request(), message.compare_with(), out);
      return;
    case ToDesigner::kStopComparing:
      stop_comparing(client, message.stop_comparing().document());
      return;
    case ToDesigner::kListRevisions:
      list_revisions(from, message.request(), message.list_revisions(), out);
      return;
    case ToDesigner::kWatchTests:
      watch_tests(from, message.watch_tests(), out);
      return;
    case ToDesigner::kRunTests:
      run_tests(message.run_tests());
      return;
    case ToDesigner::kShowTestCycle:
      show_test_cycle(from, message.request(), message.show_test_cycle(), out);
      return;
    case ToDesigner::kAddTest:
      add_test(message.add_test(), out);
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

OpenConfiguration* Designer::Parts::opened(const std::string& path, Answer& out) {
  OpenConfiguration* one = desk_.find(path);
  if (one == nullptr) {
    out.set_ok(false);
    out.set_error(fmt::format("`{}` is not open", text::shown(path, 200)));
  }
  return one;
}

OpenConfiguration* Designer::Parts::editable(const std::string& path, Answer& out) {
  OpenConfiguration* one = opened(path, out);
  if (one == nullptr || one->is_writable) return one;
  out.set_ok(false);
  out.set_error(fmt::format("`{}` is read only: save it under another name, or make your own copy",
                            text::shown(path, 200)));
  return nullptr;
}

void Designer::Parts::edit_text(const EditText& request, Answer& out) {
  OpenConfiguration* one = editable(request.document(), out);
  if (one == nullptr) return;
  const std::string_view text = one->text.text();
  const bool is_stale = request.revision() != one->text.revision();
  const bool is_inside = request.begin() <= request.end() && request.end() <= text.size() &&
                         text::is_character_boundary(text, request.begin()) &&
                         text::is_character_boundary(text, request.end());
  const bool fits = request.text().size() + text.size() <= text::Source::kMaxBytes;
  if (is_stale || !is_inside || !fits) {
    out.set_ok(false);
    out.set_error(is_stale ? "the text has changed meanwhile" : "this is no place of the text");
    return;
  }
  desk_.store().change({{one, {{request.begin(), request.end()}, request.text()}}},
                       request.name().empty() ? "type" : request.name(), now());
  typed_.insert(one->path);
}

void Designer::Parts::undo(const std::string& path, bool again, Answer& out) {
  OpenConfiguration* one = editable(path, out);
  if (one == nullptr) return;
  if (again ? one->log->redo() : one->log->undo()) {
    desk_.changed(*one);
    return;
  }
  out.set_ok(false);
  out.set_error(again ? "there is nothing to do again" : "there is nothing to undo");
}

}  // namespace mlab::designer
