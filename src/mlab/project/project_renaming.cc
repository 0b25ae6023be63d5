#include "mlab/project/project_renaming.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/core.h>

#include "mlab/documents/enclosed_file.h"
#include "mlab/documents/merge.h"
#include "mlab/text/shown.h"

namespace mlab::project {
namespace {

std::unexpected<text::Diagnostic> not_renamed(std::string message) {
  return std::unexpected(
      text::Diagnostic{text::Severity::kError, "cannot-rename", std::move(message), {}, {}, {}, {}});
}

std::vector<std::string> parts_of(std::string_view path) {
  std::vector<std::string> out;
  while (true) {
    const std::size_t slash = std::min(path.find('/'), path.size());
    out.emplace_back(path.substr(0, slash));
    if (slash == path.size()) return out;
    path.remove_prefix(slash + 1);
  }
}

}  // namespace

// As it is expected to stand.
text::Result<bool> ProjectRenaming::check(const Step& step) const {
  bool is_same = false;
  if (step.is_open) {
    const documents::Document* document = store().find(step.path);
    is_same = document != nullptr && document->text.text() == step.before;
  } else {
    const text::Result<std::string> now = store().project().read(step.path);
    is_same = now && *now == step.before;
  }
  if (is_same) return true;
  return not_renamed(fmt::format("`{}` has changed meanwhile", text::shown(step.path, 200)));
}

text::Result<bool> ProjectRenaming::write_file(const std::string& path, const std::string& text) const {
  using documents::EnclosedFolder;
  const std::vector<std::string> parts = parts_of(path);
  const std::string problem =
      EnclosedFolder::of_file(store().project().folder(), parts).write(parts.back(), text);
  if (problem.empty()) {
    texts_.open().wrote_file(path);
    return true;
  }
  return not_renamed(fmt::format("cannot write `{}`: {}", text::shown(path, 200), problem));
}

// All files on disk, or as they were.
text::Result<bool> ProjectRenaming::write(const Steps& steps) const {
  for (const Step& step : steps) {
    if (const auto fits = check(step); !fits) return fits;
  }
  std::vector<const Step*> written;
  for (const Step& step : steps) {
    if (step.is_open) continue;
    const text::Result<bool> done = write_file(step.path, step.after);
    if (done) {
      written.push_back(&step);
      continue;
    }
    for (const Step* one : written) {
      if (const auto back = write_file(one->path, one->before); !back) return back;
    }
    return done;
  }
  return true;
}

void ProjectRenaming::save(const std::vector<std::string>& paths) const {
  for (const std::string& path : paths) {
    documents::Document* document = store().find(path);
    if (document != nullptr && document->is_dirty()) texts_.open().save(*document);
  }
}

// Of what is open: where nothing is unsaved.
std::vector<std::string> ProjectRenaming::saved_now(const Steps& steps) const {
  std::vector<std::string> out;
  for (Step step : steps) {
    look_whether_open(step);
    if (step.was_saved) out.push_back(step.path);
  }
  return out;
}

// What somebody has changed since is not lost: his change and this become one, or the file stays as it is.
bool ProjectRenaming::exchange_file(const std::string& path, const std::string& from,
                                    const std::string& to) const {
  const text::Result<std::string> now = store().project().read(path);
  if (!now) return false;
  const std::optional<std::string> text =
      *now == from ? std::optional(to) : documents::merged(from, to, *now);
  return text && write_file(path, *text).has_value();
}

void ProjectRenaming::exchange_files(const Steps& steps, std::string Step::* from,
                                     std::string Step::* to) const {
  for (const Step& step : steps) {
    if (step.is_open) continue;
    // Opened since: its text is what counts.
    if (documents::Document* document = store().find(step.path)) {
      const std::string now(document->text.text());
      const auto text =
          now == step.*from ? std::optional(step.*to) : documents::merged(step.*from, step.*to, now);
      if (text) {
        document->text.set(*text);
        continue;
      }
    } else if (exchange_file(step.path, step.*from, step.*to)) {
      continue;
    }
    texts_.open().tell(
        fmt::format("{} has changed meanwhile, and stays as it is", text::shown(step.path, 200)));
  }
}

void ProjectRenaming::edit(const Steps& steps, const std::string& name, double now) const {
  std::vector<documents::Store::Change> changes;
  std::vector<std::string> saved;
  for (const Step& step : steps) {
    if (!step.is_open) continue;
    documents::Document& document = *store().find(step.path);
    changes.push_back({&document, text::difference(document.text.text(), step.after)});
    if (step.was_saved) saved.push_back(step.path);
  }
  const std::shared_ptr<documents::EditLog> log = texts_.open().log();
  if (log == nullptr) {
    texts_.open().change(changes, name, now);
    save(saved);
    return;
  }
  // One entry: files are exchanged before the open texts while undoing, after them while doing again, and
  // what was saved is so again at the end of both.
  struct Undoing {
    Steps steps;
    std::vector<std::string> saved;
  };
  const auto undoing = std::make_shared<Undoing>(Undoing{steps, {}});
  log->separate();
  log->add({name, [this, undoing] { save(undoing->saved); },
            [this, undoing] { undoing->saved = saved_now(undoing->steps); }},
           now);
  texts_.open().change(changes, name, now);
  log->add({name,
            [this, undoing] {
              undoing->saved = saved_now(undoing->steps);
              exchange_files(undoing->steps, &Step::after, &Step::before);
            },
            [this, undoing] {
              exchange_files(undoing->steps, &Step::before, &Step::after);
              save(undoing->saved);
            }},
           now);
  log->separate();
  save(saved);
}

void ProjectRenaming::look_whether_open(Step& step) const {
  const documents::Document* document = store().find(step.path);
  step.is_open = document != nullptr;
  step.was_saved = document != nullptr && document->saved && !document->is_dirty();
}

text::Result<bool> ProjectRenaming::carry_out(const assist::Renaming& what, const std::string& to,
                                              double now) {
  Steps steps;
  OpenTexts& open = texts_.open();
  for (const assist::Change& change : what.changes) {
    Step& step = steps.emplace_back();
    step.path = texts_.path_of(change.source->name());
    // What is kept of unsaved work is edited where it was begun.
    if (store().find(step.path) == nullptr && open.is_edited_here(step.path) &&
        store().drafts().find(step.path)) {
      if (const auto opened = open.open(step.path, now); !opened) return std::unexpected(opened.error());
    }
    look_whether_open(step);
    step.before = change.source->text();
    step.after = assist::changed_text(change);
  }
  if (const auto done = write(steps); !done) return done;
  name_ = fmt::format("rename {} to {}", what.from, to);
  edit(steps, name_, now);
  last_ = std::move(steps);
  return true;
}

text::Result<bool> ProjectRenaming::take_back(double now) {
  if (last_.empty()) return not_renamed("there is no renaming to take back");
  Steps steps = last_;
  for (Step& step : steps) {
    std::swap(step.before, step.after);
    // Opened since, or closed: what counts is where its text stands now.
    look_whether_open(step);
    if (step.is_open) continue;
    const bool is_there = store().project().is_file(step.path);
    if (!is_there) return not_renamed(fmt::format("`{}` is not there any more", text::shown(step.path, 200)));
  }
  if (const auto done = write(steps); !done) return done;
  edit(steps, "take back: " + name_, now);
  last_.clear();
  return true;
}

}  // namespace mlab::project
