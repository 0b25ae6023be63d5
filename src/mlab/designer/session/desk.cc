#include "mlab/designer/session/desk.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/drawing/titles.h"
#include "mlab/designer/edit/spans.h"
#include "mlab/designer/edit/spread.h"
#include "mlab/documents/refused.h"
#include "mlab/lang/cdl/syntax/lexer.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/lang/cdl_historic/import.h"
#include "mlab/project/library_texts.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/robot/program/robot_program.h"

namespace mlab::designer {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kNew = "new:";

using documents::refused;
using documents::shown;
using project::kLibrary;

}  // namespace

Desk::Desk(const Settings& settings)
    : project_({settings.project_folder, settings.example_folder, {".cdl"}, "configurations (.cdl)"}),
      store_(project_, settings.state_folder.empty() ? "" : settings.state_folder + "/designer"),
      files_(store_.files()) {}

OpenConfiguration* Desk::find(std::string_view path) {
  const auto found = open_.find(path);
  return found == open_.end() ? nullptr : found->second.get();
}

std::vector<OpenConfiguration*> Desk::all() {
  std::vector<OpenConfiguration*> out;
  out.reserve(open_.size());
  for (const auto& [path, one] : open_) out.push_back(one.get());
  return out;
}

// Files only; hidden ones are left out.
std::vector<std::string> Desk::names_in(const std::string& folder) const {
  const std::string path = (fs::path(folder) / "").lexically_normal().string();
  const bool is_root = path == (fs::path(project_.folder()) / "").string();
  const std::optional<std::string> name =
      is_root ? std::string() : project_.name_of(fs::path(path).parent_path());
  std::vector<std::string> out;
  const auto entries =
      name ? project_.list(*name) : text::Result<std::vector<documents::ProjectFolder::Entry>>();
  if (!entries) return out;
  for (const documents::ProjectFolder::Entry& entry : *entries) {
    if (!entry.is_folder) out.push_back(fs::path(entry.path).filename().string());
  }
  return out;
}

assist::Surroundings Desk::surroundings() {
  assist::Surroundings out;
  out.files = files_;
  out.list = [this](const std::string& folder) { return names_in(folder); };
  out.checks_code = false;
  return out;
}

// Of those that are not open: what is changed here is known already.
std::map<std::string, std::string> Desk::stamps(const OpenConfiguration& one) const {
  std::map<std::string, std::string> out;
  for (const std::string& path : one.model->configuration().files) {
    const std::optional<std::string> name = project_.name_of(path);
    if (!name || open_.contains(*name)) continue;
    std::error_code missing;
    const auto time = fs::last_write_time(path, missing).time_since_epoch().count();
    const auto size = fs::file_size(path, missing);
    out[path] = missing ? "" : fmt::format("{} {}", time, size);
  }
  return out;
}

const cdl::Environment& Desk::environment() {
  environment_ = robot::library_environment();
  environment_.files = &files_;
  return environment_;
}

std::string Desk::source_name(const std::string& path) const {
  if (path.starts_with(kLibrary)) return project::library_source_name(path);
  if (path.starts_with(kNew))
    return (fs::path(project_.folder()) / (path.substr(kNew.size()) + ".new.cdl")).string();
  return project_.disk_path(path);
}

std::string Desk::document_of(std::string_view source_name) const {
  if (std::string path = project::library_path(source_name); !path.empty()) return path;
  for (const auto& [path, one] : open_) {
    if (one->model && one->model->source()->name() == source_name) return path;
  }
  return project_.name_of(std::string(source_name)).value_or("");
}

DrawingContext Desk::context(const OpenConfiguration& one) const {
  return {one.path, one.text.revision(), !one.is_writable,
          [this](std::string_view source_name) { return document_of(source_name); }};
}

std::shared_ptr<OpenConfiguration> Desk::make(const std::string& path, std::string text) {
  auto out = std::make_shared<OpenConfiguration>(
      path, std::make_shared<const text::Source>(source_name(path), std::move(text)));
  out->is_writable = is_new(path) || project_.is_writable(path);
  return out;
}

OpenConfiguration* Desk::add(const std::shared_ptr<OpenConfiguration>& one) {
  open_[one->path] = one;
  model(*one);
  look_beside();
  return one.get();
}

void Desk::model(OpenConfiguration& one) {
  auto source = std::make_shared<const text::Source>(source_name(one.path), std::string(one.text.text()));
  one.model = std::make_shared<Model>(std::move(source), environment());
  one.modelled = one.text.source();
  one.is_started = false;
  one.compiled.reset();
  one.used = stamps(one);
  one.beside_seen = beside_number_;
  ++one.model_number;
  if (!one.model->is_readable() && one.drawn) return;
  one.drawn = one.model;
  one.drawn_revision = one.text.revision();
}

void Desk::changed(OpenConfiguration& one) {
  model(one);
  const std::string name = one.model->source()->name();
  for (const auto& [path, other] : open_) {
    if (other.get() == &one) continue;
    const auto& files = other->model->configuration().files;
    if (std::ranges::find(files, name) != files.end()) model(*other);
  }
}

void Desk::follow_texts() {
  std::vector<OpenConfiguration*> behind = all();
  std::erase_if(behind, [](const OpenConfiguration* one) { return one->modelled == one->text.source(); });
  for (OpenConfiguration* one : behind) changed(*one);
}

OpenConfiguration* Desk::next_to_compile() {
  for (const auto& [path, one] : open_) {
    if (!std::exchange(one->is_started, true)) return one.get();
  }
  return nullptr;
}

Compiler::Task Desk::task(const OpenConfiguration& one) const {
  return {one.path, one.model->source(), store_.snapshot()};
}

bool Desk::take(const std::string& document, std::shared_ptr<const Compiled> compiled) {
  OpenConfiguration* one = find(document);
  if (one == nullptr || one->model->source() != compiled->source) return false;
  one->compile_ms = compiled->problems.has_errors() ? -1.0 : compiled->took_ms;
  one->compiled = std::move(compiled);
  ++one->compiled_number;
  return true;
}

bool Desk::take(const std::string& document, std::shared_ptr<const CheckedCode> code) {
  OpenConfiguration* one = find(document);
  if (one == nullptr) return false;
  one->code = std::move(code);
  ++one->compiled_number;
  return true;
}

text::Result<OpenConfiguration*> Desk::open(const std::string& path, double now) {
  if (OpenConfiguration* one = find(path)) return one;
  if (path.empty() || is_new(path)) return open_new(path, now);
  if (path.starts_with(kLibrary)) {
    const auto found = project::library_text(path);
    if (!found) return refused("cannot-read", fmt::format("the library has no {}", shown(path)));
    const auto one = make(path, std::string(*found));
    one->is_detached = true;
    store_.add(one);
    return add(one);
  }
  text::Result<std::string> content = store_.read(path);
  if (!content) {
    const bool is_only_kept = !project_.is_file(path) && drafts().find(path);
    if (is_only_kept) return open_kept(path, now);
    return std::unexpected(content.error());
  }
  if (cdl_historic::looks_historic(*content)) return import(path, *content, now);
  const auto one = make(path, *content);
  one->saved = std::move(*content);
  store_.add(one);
  if (one->is_writable) {
    store_.restore_draft(*one, now);
    store_.drafts().add_recent(path, "");
  }
  return add(one);
}

/// @param path  of an unsaved one of before; empty: another one
text::Result<OpenConfiguration*> Desk::open_new(std::string path, double now) {
  if (path.empty()) {
    const std::vector<std::string> kept = drafts().paths();
    do {
      path = fmt::format("{}{}", kNew, ++last_new_);
    } while (find(path) != nullptr || std::ranges::find(kept, path) != kept.end());
  } else if (!drafts().find(path)) {
    return refused("cannot-read", fmt::format("there is no {}", shown(path)));
  }
  return open_kept(path, now);
}

// What there is no file of.
text::Result<OpenConfiguration*> Desk::open_kept(const std::string& path, double now) {
  const auto one = make(path, "");
  store_.add(one);
  store_.restore_draft(*one, now);
  return add(one);
}

// A configuration of the historic tools opens as a new one that says the same; its file stays as it is.
text::Result<OpenConfiguration*> Desk::import(const std::string& path, const std::string& content,
                                              double now) {
  const cdl_historic::Vocabulary vocabulary(robot::component_library(),
                                            robot::library_environment().built_in);
  text::Diagnostics sink;
  const auto source = std::make_shared<const text::Source>(source_name(path), content);
  std::string ours = cdl_historic::import_as_text(source, vocabulary, sink);
  for (const text::Diagnostic& d : sink.items()) {
    if (d.severity == text::Severity::kError)
      return refused("cannot-import", fmt::format("{} can't be imported: {}", shown(path), d.message));
  }
  text::Result<OpenConfiguration*> out = open("", now);
  if (!out) return out;
  store_.change(**out, spread_out(std::move(ours), environment()), "import " + path, now, false);
  changed(**out);
  return out;
}

text::Result<OpenConfiguration*> Desk::open_on_disk(const std::string& disk_path, double now) {
  if (!project_.name_of(disk_path)) project_.allow_outside(disk_path);
  const std::optional<std::string> name = project_.name_of(disk_path);
  if (!name) return refused("cannot-read", fmt::format("{} can't be opened", shown(disk_path)));
  return open(*name, now);
}

std::vector<std::string> Desk::losses() const {
  std::vector<std::string> out;
  for (const documents::Store::Loss& loss : store_.losses()) {
    const documents::Document& one = *loss.document;
    const std::string name =
        is_new(one.path) ? fmt::format("`{}`", unsaved_title(one.text.text())) : shown(one.path);
    out.push_back(fmt::format("{}: {}", name, loss.why));
  }
  return out;
}

std::string Desk::not_kept() const {
  const std::vector<std::string> lost = losses();
  return lost.empty() ? store_.folder_problem() : lost.front();
}

void Desk::close(std::string_view path) {
  OpenConfiguration* one = find(path);
  if (one == nullptr) return;
  store_.keep_draft(*one, 0.0, documents::DraftKeeper::When::kAtOnce);
  if (!one->draft.problem.empty()) return;
  store_.close(path);
  open_.erase(open_.find(path));
}

void Desk::discard(const std::string& path) {
  store_.close(path);
  if (const auto one = open_.find(path); one != open_.end()) open_.erase(one);
  store_.drafts().drop(path);
  ++lists_number_;
}

bool Desk::is_new(std::string_view path) {
  return path.starts_with(kNew);
}

// Whoever has to decide about the file, or had to, is told.
text::Result<std::string> Desk::save(OpenConfiguration& one, const Save& request) {
  using Disk = documents::Document::Disk;
  follow_texts();
  const Disk before = one.disk;
  text::Result<std::string> path = save_text(one, request);
  const bool is_news = path ? before != Disk::kSame : one.disk != Disk::kSame;
  if (is_news) ++one.file_news;
  return path;
}

text::Result<std::string> Desk::save_text(OpenConfiguration& one, const Save& request) {
  if (!request.library().empty()) {
    const text::Result<bool> done = save_to_library(one, request.library());
    if (!done) return std::unexpected(done.error());
    return one.path;
  }
  const std::string before = one.path;
  std::string path = request.as().empty() ? before : request.as();
  const bool is_other = path != before;
  if (!is_other && is_new(path)) return refused("no-name", "say under which name it is to be saved");
  if (!path.ends_with(".cdl") && (is_other || one.is_writable))
    return refused("cannot-write", "the name of a configuration ends in `.cdl`");
  const text::Result<bool> saved =
      is_other ? store_.save_as(one, path, request.overwrite()) : store_.save(one, request.overwrite());
  if (!saved) return std::unexpected(saved.error());
  if (is_other) {
    auto node = open_.extract(before);
    node.key() = path;
    open_.insert(std::move(node));
    changed(one);
    ++lists_number_;
  }
  store_.drafts().add_recent(path, "");
  look_beside();
  return path;
}

// The words of a declaration, its help and comments right above it included.
text::Result<bool> Desk::save_to_library(OpenConfiguration& one, const std::string& declaration) {
  const cdl::Assemblage* found = one.drawn->assemblage(declaration);
  if (found == nullptr)
    return refused("no-declaration", fmt::format("there is no assemblage {}", shown(declaration)));
  const std::string text = declaration_text(*one.drawn, declaration);
  OpenConfiguration* open = find(kProjectLibrary);
  const bool has_unsaved = open != nullptr ? open->is_dirty() : drafts().find(kProjectLibrary).has_value();
  if (has_unsaved)
    return refused("library-not-saved",
                   fmt::format("{} has changes that are not saved: save it first", shown(kProjectLibrary)));
  std::string library;
  if (open != nullptr) {
    library = open->text.text();
  } else if (project_.is_file(kProjectLibrary)) {
    text::Result<std::string> content = store_.read(kProjectLibrary);
    if (!content) return std::unexpected(content.error());
    library = std::move(*content);
  }
  const Model before(std::make_shared<const text::Source>(project_.disk_path(kProjectLibrary), library),
                     environment());
  if (!before.is_readable())
    return refused("library-has-errors",
                   fmt::format("{} has errors: mend them first", shown(kProjectLibrary)));
  if (before.assemblage(declaration) != nullptr) {
    const text::Span span = declaration_span(before, declaration);
    library.replace(span.begin, span.end - span.begin, text);
  } else {
    library += (library.empty() ? "" : "\n") + text + "\n";
  }
  return write_library(before.source()->text(), library);
}

// Through the store, which looks at what stands on disk.
text::Result<bool> Desk::write_library(std::string_view before, std::string_view after) {
  OpenConfiguration* open = find(kProjectLibrary);
  std::shared_ptr<documents::Document> passing;
  if (open == nullptr) {
    passing = make(kProjectLibrary, std::string(before));
    if (project_.is_file(kProjectLibrary)) passing->saved = std::string(before);
    store_.add(passing);
  }
  documents::Document& library = open != nullptr ? *open : *passing;
  store_.change(library, after, "save to library", 0.0, false);
  text::Result<bool> saved = store_.save(library);
  if (!saved) library.log->undo();
  if (open == nullptr) store_.close(kProjectLibrary);
  look_beside();
  if (open != nullptr) changed(*open);
  return saved;
}

text::Result<bool> Desk::reload(OpenConfiguration& one, bool merge, double now) {
  const bool was_asked = one.disk != documents::Document::Disk::kSame;
  const text::Result<bool> done = store_.reload(one, merge, now);
  if (done && was_asked) ++one.file_news;
  if (done) changed(one);
  return done;
}

void Desk::look_at_disk(double now) {
  look_beside();
  for (const auto& [path, one] : open_) {
    const bool misses_file = std::ranges::any_of(
        one->model->problems().items(), [](const text::Diagnostic& d) { return d.kind == "cannot-read"; });
    const bool may_have_come = misses_file && one->beside_seen != beside_number_;
    if (may_have_come || stamps(*one) != one->used) model(*one);
  }
  for (const documents::Store::Seen& seen : store_.look_at_disk(now)) {
    OpenConfiguration* one = find(seen.document->path);
    if (one != nullptr) ++one->file_news;
  }
  follow_texts();
}

std::vector<std::string> Desk::configurations(std::string_view folder) const {
  return project_.files(folder, ".cdl");
}

std::vector<std::string> Desk::overlays() const {
  std::vector<std::string> out = project_.files("", ".odl");
  for (std::string& one : project_.files("", ".ovl")) out.push_back(std::move(one));
  for (std::string& one : project_.files("examples:", ".odl")) out.push_back(std::move(one));
  return out;
}

}  // namespace mlab::designer
