#include "mlab/designer/session/project_renaming.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "mlab/documents/enclosed_file.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
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
    const OpenConfiguration* one = desk_.find(step.path);
    is_same = one != nullptr && one->text.text() == step.before;
  } else {
    const text::Result<std::string> now = desk_.project().read(step.path);
    is_same = now && *now == step.before;
  }
  if (is_same) return true;
  return not_renamed(fmt::format("`{}` has changed meanwhile", text::shown(step.path, 200)));
}

text::Result<bool> ProjectRenaming::write_file(const std::string& path, const std::string& text) const {
  using documents::EnclosedFolder;
  const std::vector<std::string> parts = parts_of(path);
  const std::string problem =
      EnclosedFolder::of_file(desk_.project().folder(), parts).write(parts.back(), text);
  if (problem.empty()) return true;
  return not_renamed(fmt::format("cannot write `{}`: {}", text::shown(path, 200), problem));
}

// All files on disk, or as they were.
text::Result<bool> ProjectRenaming::write(const std::vector<Step>& steps) {
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

void ProjectRenaming::edit(const Step& step, const std::string& name, double now) {
  OpenConfiguration& one = *desk_.find(step.path);
  desk_.store().change(one, step.after, name, now, false);
  if (!step.was_saved) return;
  Save save;
  save.set_document(step.path);
  // Where that fails it stays unsaved, which everybody sees.
  [[maybe_unused]] const text::Result<std::string> saved = desk_.save(one, save);
}

text::Result<bool> ProjectRenaming::carry_out(const assist::Renaming& what, const std::string& to,
                                              double now) {
  std::vector<Step> steps;
  for (const assist::Change& change : what.changes) {
    Step& step = steps.emplace_back();
    step.path = texts_.path_of(change.source);
    // What is kept of unsaved work is edited where it was begun.
    if (desk_.find(step.path) == nullptr && step.path.ends_with(".cdl") && desk_.drafts().find(step.path)) {
      if (const auto opened = desk_.open(step.path, now); !opened) return std::unexpected(opened.error());
    }
    const OpenConfiguration* open = desk_.find(step.path);
    step.is_open = open != nullptr;
    step.was_saved = open != nullptr && open->saved && !open->is_dirty();
    step.before = change.source->text();
    step.after = assist::changed_text(change);
  }
  if (const auto done = write(steps); !done) return done;
  name_ = fmt::format("rename {} to {}", what.from, to);
  for (const Step& step : steps) {
    if (step.is_open) edit(step, name_, now);
  }
  last_ = std::move(steps);
  return true;
}

text::Result<bool> ProjectRenaming::take_back(double now) {
  if (last_.empty()) return not_renamed("there is no renaming to take back");
  std::vector<Step> steps = last_;
  for (Step& step : steps) {
    std::swap(step.before, step.after);
    const OpenConfiguration* open = desk_.find(step.path);
    // Opened since, or closed: what counts is where its text stands now.
    step.is_open = open != nullptr;
    step.was_saved = open != nullptr && open->saved && !open->is_dirty();
    if (step.is_open) continue;
    const bool is_there = desk_.project().is_file(step.path);
    if (!is_there) return not_renamed(fmt::format("`{}` is not there any more", text::shown(step.path, 200)));
  }
  if (const auto done = write(steps); !done) return done;
  for (const Step& step : steps) {
    if (step.is_open) edit(step, "take back: " + name_, now);
  }
  last_.clear();
  return true;
}

}  // namespace mlab::designer
