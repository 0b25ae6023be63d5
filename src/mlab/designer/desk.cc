#include "mlab/designer/desk.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

#include <fmt/core.h>

#include "mlab/console/enclosed_file.h"
#include "mlab/console/utf8.h"
#include "mlab/designer/spans.h"
#include "mlab/designer/spread.h"
#include "mlab/lang/cdl/lexer.h"
#include "mlab/lang/cdl/parser.h"
#include "mlab/lang/cdl_historic/import.h"
#include "mlab/library/library.h"
#include "mlab/robot/configuration_file.h"
#include "mlab/robot/robot_program.h"
#include "mlab/text/line_ends.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kLibrary = "library:";
constexpr std::string_view kLibraryFolder = "library/";
constexpr std::string_view kNew = "new:";

std::unexpected<text::Diagnostic> refused(std::string kind, std::string message) {
  return std::unexpected(
      text::Diagnostic{text::Severity::kError, std::move(kind), std::move(message), {}, {}, {}, {}});
}

std::string shown(std::string_view path) {
  return fmt::format("`{}`", text::shown(path, 200));
}

// The folders and the name of a path inside of the project; nothing where it is none.
std::optional<std::vector<std::string>> plain_parts(std::string_view path) {
  constexpr std::size_t kLongest = 240;
  std::vector<std::string> out;
  while (true) {
    const std::size_t slash = std::min(path.find('/'), path.size());
    const std::string_view part = path.substr(0, slash);
    const bool is_plain = !part.empty() && part.front() != '.' && part.size() <= kLongest &&
                          part.find_first_of(":\\\n\r") == std::string_view::npos &&
                          part.find('\0') == std::string_view::npos;
    if (!is_plain) return std::nullopt;
    out.emplace_back(part);
    if (slash == path.size()) return out;
    path.remove_prefix(slash + 1);
  }
}

const library::ConfigurationText* library_text(std::string_view path) {
  if (!path.starts_with(kLibrary)) return nullptr;
  const std::string file = std::string(kLibraryFolder) + std::string(path.substr(kLibrary.size()));
  for (const library::ConfigurationText& one : library::configuration_texts()) {
    if (one.file == file) return &one;
  }
  return nullptr;
}

}  // namespace

Desk::Desk(const Settings& settings)
    : project_({settings.project_folder, settings.example_folder}),
      drafts_(settings.state_folder.empty() ? "" : settings.state_folder + "/designer", project_.folder()),
      keeper_(drafts_),
      files_(files()) {}

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

// What texts use is read as it stands in the editor, where it is open.
text::Files Desk::files() {
  text::Files out;
  out.is_file = [this](const std::string& path) {
    const std::optional<std::string> name = project_.name_of(path);
    return name && (find(*name) != nullptr || project_.is_file(*name));
  };
  out.read = [this](const std::string& path) -> text::Result<text::SourcePtr> {
    const std::optional<std::string> name = project_.name_of(path);
    if (!name) return refused("cannot-read", fmt::format("{} is not in the project", shown(path)));
    if (const OpenConfiguration* one = find(*name))
      return std::make_shared<const text::Source>(path, one->text.text());
    text::Result<std::string> content = project_.read(*name);
    if (!content) return std::unexpected(content.error());
    return std::make_shared<const text::Source>(path, std::move(*content));
  };
  return out;
}

std::shared_ptr<const text::Files> Desk::snapshot() const {
  struct Kept {
    console::ProjectFolder project;
    std::map<std::string, text::SourcePtr, std::less<>> open;
  };
  auto kept = std::make_shared<Kept>(Kept{project_, {}});
  for (const auto& [path, one] : open_) {
    if (one->model) kept->open[path] = one->model->source();
  }
  auto out = std::make_shared<text::Files>();
  out->is_file = [kept](const std::string& path) {
    const std::optional<std::string> name = kept->project.name_of(path);
    return name && (kept->open.contains(*name) || kept->project.is_file(*name));
  };
  out->read = [kept](const std::string& path) -> text::Result<text::SourcePtr> {
    const std::optional<std::string> name = kept->project.name_of(path);
    if (!name) return refused("cannot-read", fmt::format("{} is not in the project", shown(path)));
    if (const auto found = kept->open.find(*name); found != kept->open.end())
      return std::make_shared<const text::Source>(path, std::string(found->second->text()));
    text::Result<std::string> content = kept->project.read(*name);
    if (!content) return std::unexpected(content.error());
    return std::make_shared<const text::Source>(path, std::move(*content));
  };
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
      name ? project_.list(*name) : text::Result<std::vector<console::ProjectFolder::Entry>>();
  if (!entries) return out;
  for (const console::ProjectFolder::Entry& entry : *entries) {
    if (!entry.is_folder) out.push_back(fs::path(entry.path).filename().string());
  }
  return out;
}

language::Surroundings Desk::surroundings() {
  language::Surroundings out;
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
  if (path.starts_with(kLibrary)) return std::string(kLibraryFolder) + path.substr(kLibrary.size());
  if (path.starts_with(kNew))
    return (fs::path(project_.folder()) / (path.substr(kNew.size()) + ".new.cdl")).string();
  return project_.disk_path(path);
}

std::string Desk::document_of(std::string_view source_name) const {
  if (source_name.starts_with(kLibraryFolder)) {
    std::string path = std::string(kLibrary) + std::string(source_name.substr(kLibraryFolder.size()));
    if (library_text(path) != nullptr) return path;
  }
  for (const auto& [path, one] : open_) {
    if (one->model && one->model->source()->name() == source_name) return path;
  }
  return project_.name_of(std::string(source_name)).value_or("");
}

DrawingContext Desk::context(const OpenConfiguration& one) const {
  return {one.path, one.text.revision(), !one.is_writable,
          [this](std::string_view source_name) { return document_of(source_name); }};
}

bool Desk::is_writable(std::string_view path) const {
  return !project_.folder().empty() && path.ends_with(".cdl") && plain_parts(path).has_value();
}

// As ProjectFolder writes missions: as a whole or not at all, and through no link.
text::Result<bool> Desk::write(const std::string& path, const std::string& text,
                               const std::string& lines_of) const {
  const std::optional<std::vector<std::string>> parts = plain_parts(path);
  if (!parts || !is_writable(path)) {
    return refused("cannot-write",
                   fmt::format("{} can't be written: only configurations (.cdl) inside of the project "
                               "folder can",
                               shown(path)));
  }
  using console::EnclosedFolder;
  const std::string problem =
      EnclosedFolder::of_file(project_.folder(), *parts, EnclosedFolder::Missing::kMake)
          .write(parts->back(), text::lines_as_in(project_.read(lines_of).value_or(""), text));
  if (!problem.empty())
    return refused("cannot-write", fmt::format("cannot write {}: {}", shown(path), problem));
  return true;
}

text::Result<std::string> Desk::read(const std::string& path) const {
  if (path.starts_with(kLibrary)) {
    if (const library::ConfigurationText* found = library_text(path)) return std::string(found->text);
    return refused("cannot-read", fmt::format("the library has no {}", shown(path)));
  }
  text::Result<std::string> content = project_.read(path);
  if (content) *content = text::unix_lines(console::as_utf8(*content));
  return content;
}

OpenConfiguration* Desk::add(std::unique_ptr<OpenConfiguration> one) {
  OpenConfiguration* out = one.get();
  open_[out->path] = std::move(one);
  model(*out);
  look_beside();
  return out;
}

void Desk::model(OpenConfiguration& one) {
  auto source = std::make_shared<const text::Source>(source_name(one.path), one.text.text());
  one.model = std::make_shared<Model>(std::move(source), environment());
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

OpenConfiguration* Desk::next_to_compile() {
  for (const auto& [path, one] : open_) {
    if (!std::exchange(one->is_started, true)) return one.get();
  }
  return nullptr;
}

Compiler::Task Desk::task(const OpenConfiguration& one) const {
  return {one.path, one.model->source(), snapshot()};
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
  if (path.empty() || path.starts_with(kNew)) {
    auto one = std::make_unique<OpenConfiguration>("");
    one->path = path;
    if (path.empty()) {
      const std::vector<std::string> kept = drafts_.new_files();
      do {
        one->path = fmt::format("{}{}", kNew, ++last_new_);
      } while (find(one->path) != nullptr || std::ranges::find(kept, one->path) != kept.end());
    } else if (!drafts_.find(path)) {
      return refused("cannot-read", fmt::format("there is no {}", shown(path)));
    }
    restore_draft(*one, now);
    return add(std::move(one));
  }
  text::Result<std::string> content = read(path);
  if (!content) return std::unexpected(content.error());
  if (cdl_historic::looks_historic(*content)) return import(path, *content, now);
  auto one = std::make_unique<OpenConfiguration>(*content);
  one->path = path;
  one->saved = std::move(*content);
  one->is_writable = is_writable(path);
  if (one->is_writable) {
    restore_draft(*one, now);
    drafts_.add_recent(path, "");
  }
  return add(std::move(one));
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
  (*out)->text.change(spread_out(std::move(ours), environment()), "import " + path, now);
  changed(**out);
  return out;
}

text::Result<OpenConfiguration*> Desk::open_on_disk(const std::string& disk_path, double now) {
  if (!project_.name_of(disk_path)) project_.allow_outside(disk_path);
  const std::optional<std::string> name = project_.name_of(disk_path);
  if (!name) return refused("cannot-read", fmt::format("{} can't be opened", shown(disk_path)));
  return open(*name, now);
}

// What was not saved comes back as the first step, so that undoing gives what stands on disk.
void Desk::restore_draft(OpenConfiguration& one, double now) {
  const std::optional<console::Drafts::Draft> draft = drafts_.find(one.path);
  if (!draft) return;
  if (draft->text != one.text.text()) one.text.change(draft->text, "restore unsaved work", now);
  one.draft.kept = one.text.revision();
}

void Desk::keep_draft(OpenConfiguration& one, double now, console::DraftKeeper::When when) {
  if (!one.is_writable) return;
  const std::string* file = one.saved ? &*one.saved : nullptr;
  keeper_.follow({one.path, one.text.text(), file, one.text.revision(), one.is_dirty()}, one.draft, now,
                 when);
}

void Desk::keep_drafts(double now, console::DraftKeeper::When when) {
  keeper_.look(now);
  for (const auto& [path, one] : open_) keep_draft(*one, now, when);
}

void Desk::sync_drafts(double now) {
  keep_drafts(now, console::DraftKeeper::When::kAtOnce);
  for (const auto& [path, one] : open_) keeper_.sync(path, one->draft);
}

std::vector<std::string> Desk::losses() const {
  std::vector<std::string> out;
  for (const auto& [path, one] : open_) {
    if (one->draft.problem.empty()) continue;
    const std::string name =
        is_new(path) ? fmt::format("`{}`", unsaved_title(one->text.text())) : shown(path);
    out.push_back(fmt::format("{}: {}", name, one->draft.problem));
  }
  return out;
}

std::string Desk::not_kept() const {
  const std::vector<std::string> lost = losses();
  return lost.empty() ? keeper_.folder_problem() : lost.front();
}

void Desk::close(std::string_view path) {
  OpenConfiguration* one = find(path);
  if (one == nullptr) return;
  keep_draft(*one, 0.0, console::DraftKeeper::When::kAtOnce);
  if (one->draft.problem.empty()) open_.erase(open_.find(path));
}

void Desk::discard(const std::string& path) {
  if (const auto one = open_.find(path); one != open_.end()) open_.erase(one);
  drafts_.drop(path);
}

bool Desk::is_new(std::string_view path) {
  return path.starts_with(kNew);
}

text::Result<std::string> Desk::save(OpenConfiguration& one, const Save& request) {
  if (!request.library().empty()) {
    const text::Result<bool> done = save_to_library(one, request.library());
    if (!done) return std::unexpected(done.error());
    return one.path;
  }
  std::string path = request.as().empty() ? one.path : request.as();
  const bool is_other = path != one.path;
  if (!is_other && path.starts_with(kNew))
    return refused("no-name", "say under which name it is to be saved");
  if (!is_other && !one.is_writable)
    return refused("read-only", fmt::format("{} can't be changed: save it under another name", shown(path)));
  if (!path.ends_with(".cdl")) return refused("cannot-write", "the name of a configuration ends in `.cdl`");
  if (is_other && find(path) != nullptr)
    return refused("file-exists", fmt::format("{} is open already", shown(path)));
  if (!request.overwrite()) {
    const bool is_there = project_.is_file(path);
    if (is_there && (is_other || !one.saved))
      return refused("file-exists", fmt::format("there is {} already", shown(path)));
    const text::Result<std::string> on_disk = is_there ? read(path) : text::Result<std::string>("");
    if (is_there && (!on_disk || *on_disk != *one.saved))
      return refused("changed-on-disk",
                     fmt::format("{} has been changed by somebody else since it was opened", shown(path)));
  }
  const text::Result<bool> written = write(path, one.text.text(), one.path);
  if (!written) return std::unexpected(written.error());
  one.draft = {};
  one.draft.problem = drafts_.drop(one.path);
  one.saved = one.text.text();
  one.asked.reset();
  one.is_writable = true;
  one.text.separate();
  if (is_other) {
    auto node = open_.extract(one.path);
    node.key() = path;
    one.path = path;
    open_.insert(std::move(node));
    changed(one);
  }
  drafts_.add_recent(path, "");
  look_beside();
  return path;
}

// The words of a declaration, its help and comments right above it included.
text::Result<bool> Desk::save_to_library(OpenConfiguration& one, const std::string& declaration) {
  const cdl::Assemblage* found = one.drawn->assemblage(declaration);
  if (found == nullptr)
    return refused("no-declaration", fmt::format("there is no assemblage {}", shown(declaration)));
  const std::string text = declaration_text(*one.drawn, declaration);
  std::string library;
  OpenConfiguration* open = find(kProjectLibrary);
  if (open != nullptr) {
    library = open->text.text();
  } else if (project_.is_file(kProjectLibrary)) {
    text::Result<std::string> content = read(kProjectLibrary);
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
  const text::Result<bool> written = write(kProjectLibrary, library, kProjectLibrary);
  if (!written) return written;
  look_beside();
  if (open != nullptr) {
    open->text.change(library, "save to library", 0.0);
    open->saved = library;
    changed(*open);
  }
  return true;
}

text::Result<bool> Desk::reload(OpenConfiguration& one, bool merge, double now) {
  text::Result<std::string> content = read(one.path);
  if (!content) return std::unexpected(content.error());
  if (merge && one.saved) {
    std::optional<std::string> both = merged(*one.saved, one.text.text(), *content);
    if (!both)
      return refused("conflict",
                     "the same lines were changed here and on disk: one of the two has to give way");
    one.text.change(std::move(*both), "merge with the file", now);
  } else {
    one.text.change(*content, "load the file anew", now);
  }
  one.saved = std::move(*content);
  one.asked.reset();
  changed(one);
  return true;
}

std::vector<Desk::Change> Desk::look_at_disk(double now) {
  std::vector<Change> out;
  look_beside();
  for (const auto& [path, one] : open_) {
    const bool misses_file = std::ranges::any_of(
        one->model->problems().items(), [](const text::Diagnostic& d) { return d.kind == "cannot-read"; });
    const bool may_have_come = misses_file && one->beside_seen != beside_number_;
    if (may_have_come || stamps(*one) != one->used) model(*one);
  }
  for (const auto& [path, one] : open_) {
    if (!one->saved || !one->is_writable) continue;
    if (!project_.is_file(path)) {
      if (!one->asked || !one->asked->empty()) out.push_back({one.get(), true, true});
      one->asked = "";
      continue;
    }
    text::Result<std::string> content = read(path);
    if (!content || *content == *one->saved || (one->asked && *one->asked == *content)) continue;
    one->asked = *content;
    const bool is_dirty = one->is_dirty() && one->text.text() != *content;
    if (!is_dirty) {
      one->text.change(*content, "take over the changed file", now);
      one->saved = std::move(*content);
      one->asked.reset();
      model(*one);
    }
    out.push_back({one.get(), false, is_dirty});
  }
  return out;
}

std::vector<std::string> Desk::found(std::string_view folder, std::string_view ending, int depth) const {
  std::vector<std::string> out;
  const auto entries = project_.list(folder);
  if (!entries || depth > console::ProjectFolder::kMaxDepth) return out;
  for (const console::ProjectFolder::Entry& entry : *entries) {
    if (out.size() >= console::ProjectFolder::kMaxMissions) break;
    if (entry.is_folder) {
      for (std::string& inner : found(entry.path, ending, depth + 1)) out.push_back(std::move(inner));
    } else if (entry.path.ends_with(ending)) {
      out.push_back(entry.path);
    }
  }
  return out;
}

std::vector<std::string> Desk::configurations(std::string_view folder) const {
  return found(folder, ".cdl", 0);
}

std::map<std::string, std::string> Desk::open_texts() const {
  std::map<std::string, std::string> out;
  for (const auto& [path, one] : open_) out[one->model->source()->name()] = one->text.text();
  return out;
}

std::vector<std::string> Desk::overlays() const {
  std::vector<std::string> out = found("", ".odl", 0);
  for (std::string& one : found("", ".ovl", 0)) out.push_back(std::move(one));
  for (std::string& one : found("examples:", ".odl", 0)) out.push_back(std::move(one));
  return out;
}

}  // namespace mlab::designer
