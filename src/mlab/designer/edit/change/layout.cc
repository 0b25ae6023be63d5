#include "mlab/designer/edit/change/layout.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <utility>

#include <fmt/core.h>

#include "mlab/designer/edit/find/devices.h"
#include "mlab/designer/edit/find/pages.h"
#include "mlab/designer/edit/values.h"

namespace mlab::designer {
namespace {

constexpr double kFarthest = 1e6;  // [px]

double rounded(double value) {
  return std::isfinite(value) ? std::round(std::clamp(value, -kFarthest, kFarthest)) + 0.0 : 0.0;
}

// `$movement` is no name of CDL.
std::string layout_name(const std::string& node) {
  if (!node.starts_with('$')) return node;
  // `$body.drive` of a class has a name below another one already.
  return node.find('.') == std::string::npos ? "actuator." + node.substr(1) : node.substr(1);
}

bool is_layout_name(std::string_view name) {
  while (!name.empty()) {
    const std::size_t dot = std::min(name.find('.'), name.size());
    if (!is_cdl_name(name.substr(0, dot))) return false;
    if (dot == name.size()) return true;
    name.remove_prefix(dot + 1);
  }
  return false;
}

// As a text may stand in a file.
std::string quotable(std::string line) {
  for (char& c : line) {
    if (c == '"') c = '\'';
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return line;
}

std::vector<std::string> split_lines(std::string_view text) {
  std::vector<std::string> out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    out.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

Done change_layout(Workspace& work, const std::string& page, const std::function<void(cdl::Layout&)>& how) {
  const bool has_no_graph = page.empty() || work.model().society(page) != nullptr ||
                            is_equipment(work.model(), page) || work.model().binding(page) != nullptr;
  if (!has_no_graph) {
    const text::Result<PageView> view = find_page(work.model(), page);
    if (!view) return std::unexpected(view.error());
  }
  if (const cdl::Layout* layout = work.model().layout(page)) {
    work.changes().change<cdl::Layout>(*layout, how);
  } else {
    cdl::Layout fresh;
    fresh.owner.text = page;
    how(fresh);
    if (!fresh.entries.empty() || !fresh.notes.empty()) work.add(std::move(fresh));
  }
  return work.commit();
}

}  // namespace

Done arrange(Workspace& work, const Arrange& change) {
  std::vector<cdl::LayoutEntry> entries;
  std::set<std::string> seen;
  for (const Arrange::At& at : change.nodes()) {
    const std::string name = layout_name(at.node());
    if (is_layout_name(name) && seen.insert(name).second)
      entries.push_back({{name, {}}, rounded(at.x()), rounded(at.y())});
  }
  if (entries.empty()) return true;
  return change_layout(work, change.page(), [entries](cdl::Layout& now) {
    for (const cdl::LayoutEntry& one : entries) {
      const auto known = std::ranges::find_if(
          now.entries, [&](const cdl::LayoutEntry& entry) { return entry.node.text == one.node.text; });
      if (known == now.entries.end())
        now.entries.push_back(one);
      else
        *known = {known->node, one.x, one.y};
    }
  });
}

Done set_note(Workspace& work, const SetNote& change) {
  const bool is_gone = change.text().empty() && change.width() == 0.0 && change.height() == 0.0;
  const cdl::Layout* layout = work.model().layout(change.page());
  const cdl::LayoutNote* old = nullptr;
  for (std::size_t i = 0; layout != nullptr && i < layout->notes.size(); ++i) {
    if (fmt::format("{}", i + 1) == change.id()) old = &layout->notes[i];
  }
  if (!change.id().empty() && old == nullptr) return refusal("the note has gone");
  if (is_gone) {
    if (old != nullptr) work.changes().remove(*old);
    return work.commit();
  }
  cdl::LayoutNote note;
  note.is_frame = change.is_frame();
  note.x = rounded(change.x());
  note.y = rounded(change.y());
  note.width = rounded(change.width());
  note.height = rounded(change.height());
  for (const std::string& line : split_lines(change.text())) note.lines.push_back(quotable(line));
  if (old == nullptr)
    return change_layout(work, change.page(), [note](cdl::Layout& now) { now.notes.push_back(note); });
  work.changes().change<cdl::LayoutNote>(*old, [note](cdl::LayoutNote& now) {
    const text::Place place = now.place;
    now = note;
    now.place = place;
  });
  return work.commit();
}

}  // namespace mlab::designer
