#include "mlab/console/session/document_orders.h"

#include <algorithm>
#include <random>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/documents/check_text.h"
#include "mlab/console/documents/completion.h"
#include "mlab/console/published/overview.h"

namespace mlab::console {
namespace {

constexpr double kDiskPause = 1.0;  // between two looks at the files [s]

std::uint32_t any_seed() {
  return std::max(1U, static_cast<std::uint32_t>(std::random_device{}()) & 0x7fffffffU);
}

}  // namespace

DocumentOrders::DocumentOrders(const Parts& parts, std::function<void(const std::string& why)> tell_not_kept)
    : documents_(parts.documents),
      project_(parts.project),
      run_(parts.run),
      maker_(parts.maker),
      log_(parts.log),
      tell_not_kept_(std::move(tell_not_kept)) {}

void DocumentOrders::note(const Sender& sender, const std::string& what) {
  log_.add(run_.sim_time(),
           {Log::EDIT, fmt::format("{}: {}", sender.client.name, clean(what)), 0, "", {}, false});
}

Answered DocumentOrders::changed(const Sender& sender, const text::Result<bool>& result,
                                 const std::string& what) {
  if (result && !what.empty()) note(sender, what);
  keep_drafts();
  maker_.follow_documents();
  return result ? Answered() : result.error().message;
}

// ---- the operator

Answered DocumentOrders::edit_text(const Sender& sender, const EditText& edit) {
  return changed(sender, documents_.edit_text(edit, wall_time()), "");
}

Answered DocumentOrders::edit_map(const Sender& sender, const EditMap& edit) {
  return changed(sender, documents_.edit_map(edit, wall_time()), edit.name());
}

Answered DocumentOrders::create_obstacles(const Sender& sender, const CreateObstacles& create) {
  const std::uint32_t seed = create.seed() == 0 ? any_seed() : create.seed();
  return changed(sender, documents_.create_obstacles(create, seed, wall_time()),
                 fmt::format("create obstacles with seed {}", seed));
}

Answered DocumentOrders::undo(const Sender& sender) {
  const std::string name = documents_.edit_state().undo();
  if (!documents_.undo()) return "there is nothing to undo";
  return changed(sender, true, "undo " + name);
}

Answered DocumentOrders::redo(const Sender& sender) {
  const std::string name = documents_.edit_state().redo();
  if (!documents_.redo()) return "there is nothing to do again";
  return changed(sender, true, "redo " + name);
}

Answered DocumentOrders::create(const Sender& sender, const NewDocument& create) {
  return changed(sender, documents_.create(create, wall_time()), "new " + create.path());
}

Answered DocumentOrders::save(const Sender& sender, const SaveDocuments& save) {
  return changed(sender, documents_.save(save), "save");
}

Answered DocumentOrders::reload(const Sender& sender, const ReloadDocument& reload) {
  return changed(sender, documents_.reload(reload, wall_time()),
                 fmt::format("{} {}", reload.merge() ? "merge with" : "load anew", reload.document()));
}

Answered DocumentOrders::open(const Sender& sender, const OpenMission& open) {
  const text::Result<bool> opened = documents_.open(open.path(), wall_time());
  if (!opened) return opened.error().message;
  run_.note(sender.client.name, fmt::format("open {}", clean(open.path())));
  maker_.follow_other_mission();
  return std::nullopt;
}

// ---- anybody

Answered DocumentOrders::list_files(const ListFiles& list, Reply& reply) {
  const auto entries = project_.list(list.folder());
  if (!entries) return entries.error().message;
  FileList& out = *reply.mutable_files();
  out.set_folder(list.folder());
  for (const documents::ProjectFolder::Entry& entry : *entries) {
    FileList::Entry& told = *out.add_entries();
    told.set_path(entry.path);
    told.set_is_folder(entry.is_folder);
    told.set_kind(entry.kind);
  }
  return std::nullopt;
}

Answered DocumentOrders::complete(const Complete& wanted, Reply& reply) {
  *reply.mutable_completions() = console::complete(wanted, documents_.known_names(maker_.mission()));
  return std::nullopt;
}

Answered DocumentOrders::check(const Check& wanted, Reply& reply) {
  const text::Diagnostics problems =
      check_text(wanted, maker_.mission(), documents_.mission_folder(), documents_.load_options());
  for (const text::Diagnostic& problem : problems.items())
    *reply.add_diagnostics() = documents_.message(problem);
  return std::nullopt;
}

// ---- files and drafts

void DocumentOrders::look_at_disk() {
  const double now = wall_time();
  if (now - looked_ < kDiskPause) return;
  looked_ = now;
  if (!documents_.look_at_disk(now)) return;
  keep_drafts();
  maker_.follow_documents();
}

void DocumentOrders::keep_drafts() {
  documents_.store().keep_drafts(wall_time());
  tell_not_kept();
}

void DocumentOrders::sync_drafts() {
  documents_.store().sync_drafts(wall_time());
  tell_not_kept();
}

void DocumentOrders::tell_not_kept() {
  std::string why = documents_.not_kept();
  if (why == not_kept_) return;
  not_kept_ = std::move(why);
  if (tell_not_kept_) tell_not_kept_(not_kept_);
}

}  // namespace mlab::console
