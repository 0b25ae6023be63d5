#include "mlab/designer/session/mark_keeper.h"

#include <optional>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/trial/live_paths.h"
#include "mlab/text/shown.h"

namespace mlab::designer {
namespace {

using Way = std::vector<Hop>;

// What the trial has added is in no text that somebody could change.
std::optional<Way> own_way(const Model& trial, const std::string& robot, const std::string& page,
                           const std::string& place, const OpenConfiguration& document) {
  std::optional<Way> way = way_to(trial, robot, page, place);
  if (!way) return way;
  for (Hop& hop : *way) {
    if (document.drawn->page(hop.page).graph == nullptr) hop.page.clear();
  }
  return way;
}

}  // namespace

void MarkKeeper::set(const SetMark& request, Answer& out) {
  constexpr std::size_t kLongest = 4000;  // bytes
  const OpenConfiguration* document = opened(desk_, request.document(), out);
  if (document == nullptr) return;
  if (const std::size_t size = request.mark().ByteSizeLong(); size > kLongest) {
    fail(out, not_live(fmt::format("the mark has {} bytes; at most {} are kept", size, kLongest)));
    return;
  }
  if (document->drawn->page(request.mark().page()).graph == nullptr) {
    fail(out, not_live(fmt::format("there is no page `{}`", text::shown(request.mark().page()))));
    return;
  }
  Marks& marks = marks_[document->path];
  if (marks.size() >= Marks::kMost) {
    fail(out, not_live(fmt::format("there are {} marks, and more are not kept", Marks::kMost)));
    return;
  }
  std::optional<Way> way;
  if (const Trials::Last* last = trials_.last(document->path)) {
    for (const auto& [robot, count] : last->configuration.robots) {
      if (!way) way = own_way(*last->model, robot, request.mark().page(), request.mark().place(), *document);
    }
  }
  out.set_text(fmt::format("{}", marks.add(request.mark(), document->drawn, std::move(way))));
  keep(document->path, marks);
}

void MarkKeeper::remove(const RemoveMark& request, Answer& out) {
  const auto marks = marks_.find(request.document());
  if (marks == marks_.end() || !marks->second.remove(request.id())) {
    fail(out, not_live("there is no such mark"));
    return;
  }
  keep(marks->first, marks->second);
}

const Marks* MarkKeeper::find(const std::string& document) const {
  const auto found = marks_.find(document);
  return found == marks_.end() ? nullptr : &found->second;
}

void MarkKeeper::follow() {
  const bool is_new_trial = std::exchange(followed_trial_, trials_.number()) != trials_.number();
  for (auto& [path, marks] : marks_) {
    const OpenConfiguration* document = desk_.find(path);
    if (document == nullptr) continue;
    bool is_changed = marks.follow(document->drawn);
    if (is_new_trial) is_changed = follow_trial(*document, marks) || is_changed;
    if (is_changed) keep(path, marks);
  }
}

bool MarkKeeper::follow_trial(const OpenConfiguration& document, Marks& marks) {
  const Trials::Last* last = trials_.last(document.path);
  if (last == nullptr) return false;
  const Model& model = *last->model;
  return marks.move_to(
      *document.drawn, [&](const std::string& page, const std::string& place) -> std::optional<Marks::Run> {
        std::optional<Marks::Run> first;
        for (const auto& [robot, count] : last->configuration.robots) {
          for (const std::string& path : live_paths(model, robot, model.source()->name(), page)) {
            std::optional<Way> way = own_way(model, robot, page, path, document);
            if (path == place) return Marks::Run{path, std::move(way)};
            if (!first) first = Marks::Run{path, std::move(way)};
          }
        }
        return first;
      });
}

// ---- keeping

void MarkKeeper::keep(const std::string& document, const Marks& marks) {
  const std::string why = store_.keep(document, marks);
  if (why.empty())
    not_kept_.erase(document);
  else
    not_kept_[document] = fmt::format("marks of `{}`: {}", text::shown(document, 200), why);
}

void MarkKeeper::keep_again() {
  constexpr double kPause = 1.0;  // [s]
  if (not_kept_.empty() || wall_time() - tried_ < kPause) return;
  tried_ = wall_time();
  for (const auto& [document, why] : std::map(not_kept_)) {
    const auto marks = marks_.find(document);
    if (marks != marks_.end()) keep(document, marks->second);
  }
}

void MarkKeeper::restore(const OpenConfiguration& document) {
  if (marks_.contains(document.path)) return;
  std::optional<Marks> kept = store_.find(document.path, desk_.environment());
  if (kept) marks_.emplace(document.path, *std::move(kept));
}

void MarkKeeper::drop(const std::string& document) {
  marks_.erase(document);
  store_.drop(document);
  not_kept_.erase(document);
}

void MarkKeeper::rename(const std::string& from, const std::string& to) {
  auto marks = marks_.extract(from);
  if (marks.empty()) return;
  const auto moved = marks_.insert_or_assign(to, std::move(marks.mapped())).first;
  keep(to, moved->second);
  store_.drop(from);
}

std::vector<std::string> MarkKeeper::losses() const {
  std::vector<std::string> out;
  out.reserve(not_kept_.size());
  for (const auto& [document, why] : not_kept_) out.push_back(why);
  return out;
}

}  // namespace mlab::designer
