#include "mlab/designer/session/start_page.h"

#include <optional>
#include <utility>

#include "mlab/designer/drawing/titles.h"
#include "mlab/designer/session/request.h"

namespace mlab::designer {
namespace {

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

void StartPage::open_first(const std::string& disk_path) {
  if (disk_path.empty()) return;
  const text::Result<OpenConfiguration*> opened = desk_.open_on_disk(disk_path, wall_time());
  if (opened)
    first_ = (*opened)->path;
  else
    first_error_ = opened.error().message;
}

Hello StartPage::hello() const {
  Hello out;
  out.set_protocol(kProtocol);
  out.set_version(version_);
  out.set_folder(desk_.project().name());
  out.set_open(first_);
  Lists all = lists();
  out.mutable_recent()->Swap(all.mutable_recent());
  out.mutable_files()->Swap(all.mutable_files());
  out.mutable_only_kept()->Swap(all.mutable_only_kept());
  for (const std::string& path : desk_.configurations("examples:"))
    add_file(*out.mutable_examples(), desk_.project(), path);
  for (const std::string& path : desk_.overlays()) add_entry(*out.mutable_overlays(), path, file_title(path));
  return out;
}

Lists StartPage::lists() const {
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

}  // namespace mlab::designer
