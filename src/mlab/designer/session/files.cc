// What there is to open, opening, saving and closing.

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/drawing/titles.h"
#include "mlab/designer/session/parts.h"

namespace mlab::designer {
namespace {

constexpr std::uint32_t kProtocol = 1;

std::string file_title(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::size_t colon = path.find(':');
  const std::size_t begin = slash != std::string::npos   ? slash + 1
                            : colon != std::string::npos ? colon + 1
                                                         : 0;
  return path.substr(begin);
}

using Entries = google::protobuf::RepeatedPtrField<console::Project::Entry>;

console::Project::Entry& add_entry(Entries& into, const std::string& path, const std::string& title) {
  console::Project::Entry& entry = *into.Add();
  entry.set_path(path);
  entry.set_title(title);
  return entry;
}

// A configuration that has a file, with what it says of itself; that is read of so many only.
void add_file(Entries& into, const documents::ProjectFolder& project, const std::string& path) {
  constexpr int kMostRead = 100;
  std::string title = file_title(path);
  if (title.ends_with(".cdl") && title.size() > 4) title.resize(title.size() - 4);
  console::Project::Entry& entry = add_entry(into, path, title);
  if (into.size() > kMostRead) return;
  if (const text::Result<std::string> text = project.read(path)) entry.set_about(said_of(*text));
}

}  // namespace

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
  hello.mutable_only_kept()->Swap(all.mutable_only_kept());
  for (const std::string& path : desk_.configurations("examples:"))
    add_file(*hello.mutable_examples(), desk_.project(), path);
  for (const std::string& path : desk_.overlays())
    add_entry(*hello.mutable_overlays(), path, file_title(path));
  send(from, message);
  if (!not_kept_.empty()) send(from, keeping_message());
  if (!first_error_.empty()) {
    out.set_ok(false);
    out.set_error(first_error_);
  }
}

Lists Designer::Parts::lists() {
  Lists out;
  for (const std::string& path : desk_.store().only_kept()) {
    const std::optional<documents::Drafts::Draft> draft = desk_.drafts().find(path);
    if (!draft) continue;
    add_entry(*out.mutable_recent(), path, unsaved_title(draft->text)).set_about(said_of(draft->text));
    out.add_only_kept(path);
  }
  for (const documents::Drafts::Recent& recent : desk_.drafts().recent()) {
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

void Designer::Parts::open(console::ConnectionId from, Client& client, const Open& request, Answer& out) {
  const text::Result<OpenConfiguration*> found = desk_.open(request.path(), now());
  if (!found) {
    fail(out, found.error());
    return;
  }
  const std::string& path = (*found)->path;
  client.documents.insert(path);
  if (request.path().empty()) drop_marks(path);  // of an earlier one that was called so
  restore_marks(**found);
  if ((*found)->disk != documents::Document::Disk::kSame) send(from, disk_message(**found));
  out.set_text(path);
}

void Designer::Parts::close(Client& client, const Close& request) {
  stop_comparing(client, request.document());
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
  const bool has_file = !Desk::is_new(path) && (desk_.project().is_file(path) || !desk_.drafts().find(path));
  if (is_elsewhere || has_file) {
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

void Designer::Parts::save(const Save& request, Answer& out) {
  OpenConfiguration* one = opened(request.document(), out);
  if (one == nullptr) return;
  const std::string before = one->path;
  const bool was_asked = one->disk != documents::Document::Disk::kSame;
  const text::Result<std::string> saved = desk_.save(*one, request);
  if (!saved) {
    fail(out, saved.error());
    if (one->disk != documents::Document::Disk::kSame) tell_disk(*one);
    return;
  }
  out.set_text(*saved);
  if (*saved == before) {
    if (was_asked) tell_disk(*one);
    return;
  }
  if (last_trial_.document == before) last_trial_.document = *saved;
  if (auto marks = marks_.extract(before); !marks.empty()) {
    const auto moved = marks_.insert_or_assign(*saved, std::move(marks.mapped())).first;
    keep_marks(*saved, moved->second);
    mark_store_.drop(before);
  }
  FromDesigner renamed;
  renamed.mutable_renamed()->set_from(before);
  renamed.mutable_renamed()->set_to(*saved);
  for (auto& [to, client] : clients_) {
    if (client.documents.erase(before) == 0) continue;
    send(to, renamed);
    client.documents.insert(*saved);
    stop_comparing(client, before);
    for (Page& page : client.pages) {
      if (page.document() == before) page.set_document(*saved);
    }
  }
  if (was_asked) tell_disk(*one);
  tell_lists();
}

void Designer::Parts::reload(const Reload& request, Answer& out) {
  OpenConfiguration* one = opened(request.document(), out);
  if (one == nullptr) return;
  const bool was_asked = one->disk != documents::Document::Disk::kSame;
  const text::Result<bool> done = desk_.reload(*one, request.merge(), now());
  if (!done) fail(out, done.error());
  if (done && was_asked) tell_disk(*one);
}

void Designer::Parts::list_files(const ListFiles& request, Answer& out) {
  const auto entries = desk_.project().list(request.folder());
  if (!entries) {
    fail(out, entries.error());
    return;
  }
  console::FileList& files = *out.mutable_files();
  files.set_folder(request.folder());
  for (const documents::ProjectFolder::Entry& entry : *entries) {
    console::FileList::Entry& one = *files.add_entries();
    one.set_path(entry.path);
    one.set_is_folder(entry.is_folder);
    one.set_kind(entry.path.ends_with(".cdl") ? "configuration" : entry.kind);
  }
}

}  // namespace mlab::designer
