#include "mlab/difference/layouts.h"

#include <map>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "mlab/difference/compare_owner.h"
#include "mlab/difference/match.h"

namespace mlab::difference {
namespace {

using Layouts = std::map<std::string, const cdl::Layout*, std::less<>>;

Layouts layouts_of(const cdl::Tree& tree) {
  Layouts out;
  for (const cdl::Item& item : tree.items) {
    if (const auto* layout = std::get_if<cdl::Layout>(&item)) out.try_emplace(layout->owner.text, layout);
  }
  return out;
}

std::string_view owner_of(std::string_view page) {
  return page.substr(0, page.find('.'));
}

/// What pages and what stands on them is called afterwards.
class Called {
 public:
  explicit Called(const Comparison& comparison) {
    for (const auto& [was, is] : comparison.owners) {
      owners_.emplace(was, is);
      before_.emplace(is, was);
      file_.emplace(was, is);
    }
    for (const SamePage& page : comparison.pages) {
      drawn_.insert(std::string(owner_of(page.before)));
      pages_.emplace(page.before, &page);
      pages_before_.emplace(page.after, page.before);
    }
  }

  /// Nothing: it has gone.
  std::optional<std::string> page(const std::string& was) const {
    if (was.empty()) return was;
    const std::string owner(owner_of(was));
    const auto found = owners_.find(owner);
    if (found == owners_.end()) return std::nullopt;
    if (!drawn_.contains(owner)) return found->second + was.substr(owner.size());
    const auto same = pages_.find(was);
    return same == pages_.end() ? std::nullopt : std::optional(same->second->after);
  }
  /// The other way round.
  std::optional<std::string> page_before(const std::string& is) const {
    if (is.empty()) return is;
    const std::string owner(owner_of(is));
    const auto found = before_.find(owner);
    if (found == before_.end()) return std::nullopt;
    if (!drawn_.contains(found->second)) return found->second + is.substr(owner.size());
    const auto same = pages_before_.find(is);
    return same == pages_before_.end() ? std::nullopt : std::optional(same->second);
  }
  Renames::Names names(const std::string& was) const {
    if (was.empty()) return file_;
    const auto same = pages_.find(was);
    Renames::Names out;
    if (same != pages_.end()) out.insert(same->second->names.begin(), same->second->names.end());
    return out;
  }
  /// Nothing of the owner differs: all names are what they were.
  bool is_untouched(const std::string& was) const {
    return !was.empty() && !drawn_.contains(std::string(owner_of(was)));
  }

 private:
  std::map<std::string, std::string, std::less<>> owners_;
  Renames::Names before_;
  Renames::Names pages_before_;
  Renames::Names file_;
  std::set<std::string, std::less<>> drawn_;
  std::map<std::string, const SamePage*, std::less<>> pages_;
};

class LayoutComparison {
 public:
  LayoutComparison(const cdl::Layout& before, const cdl::Layout& after, Renames::Names names,
                   bool keeps_names, Comparison& out)
      : before_(before), after_(after), names_(std::move(names)), keeps_names_(keeps_names), out_(out) {}

  void run() {
    compare_entries();
    compare_notes();
  }

 private:
  Difference on_page(Thing thing, What what) const {
    Difference out;
    out.thing = thing;
    out.what = what;
    out.page_before = before_.owner.text;
    out.page_after = after_.owner.text;
    return out;
  }

  // In a layout an actuator is called `actuator.movement`, on its page `$movement`.
  static std::string on_drawing(const std::string& name) {
    return name.starts_with("actuator.") ? "$" + name.substr(9) : name;
  }

  void compare_entries() {
    std::map<std::string, const cdl::LayoutEntry*, std::less<>> now;
    for (const cdl::LayoutEntry& entry : after_.entries) now.try_emplace(on_drawing(entry.node.text), &entry);
    std::set<std::string, std::less<>> seen;
    for (const cdl::LayoutEntry& was : before_.entries) {
      const std::string name = on_drawing(was.node.text);
      if (!seen.insert(name).second) continue;
      const auto same = names_.find(name);
      if (same == names_.end() && !keeps_names_) continue;
      const auto found = now.find(same == names_.end() ? name : same->second);
      if (found == now.end()) continue;
      const cdl::LayoutEntry& is = *found->second;
      if (was.x == is.x && was.y == is.y) continue;
      Difference one = on_page(Thing::kNode, What::kMoved);
      one.name_before = name;
      one.name_after = found->first;
      one.place_before = was.node.place;
      one.place_after = is.node.place;
      one.details.push_back(
          {"place", fmt::format("{}, {}", was.x, was.y), fmt::format("{}, {}", is.x, is.y)});
      out_.layout.push_back(std::move(one));
    }
  }

  static std::string words(const cdl::LayoutNote& one) {
    return fmt::format("{}", fmt::join(one.lines, "\n"));
  }
  static std::string place(const cdl::LayoutNote& one) {
    return fmt::format("{}, {} ({} x {})", one.x, one.y, one.width, one.height);
  }

  void compare_notes() {
    const auto& olds = before_.notes;
    const auto& news = after_.notes;
    Pairs same(olds.size(), news.size());
    const auto by = [&](const auto& key) {
      pair_by(same, [&](std::size_t i) { return key(olds[i]); }, [&](std::size_t k) { return key(news[k]); });
    };
    const auto kind = [](const cdl::LayoutNote& one) { return one.is_frame ? "frame " : "note "; };
    by([&](const cdl::LayoutNote& one) { return kind(one) + words(one) + '\n' + place(one); });
    by([&](const cdl::LayoutNote& one) { return kind(one) + words(one); });
    by([&](const cdl::LayoutNote& one) { return kind(one) + place(one); });
    for (std::size_t i = 0; i < olds.size(); ++i)
      if (same.to_after[i] < 0) tell(olds[i], What::kRemoved);
    for (std::size_t k = 0; k < news.size(); ++k) {
      if (same.to_before[k] < 0)
        tell(news[k], What::kAdded);
      else
        compare_note(olds[static_cast<std::size_t>(same.to_before[k])], news[k]);
    }
  }

  void tell(const cdl::LayoutNote& note_alone, What what) {
    Difference one = on_page(Thing::kNote, what);
    one.kind = note_alone.is_frame ? "frame" : "note";
    (what == What::kAdded ? one.name_after : one.name_before) = words(note_alone);
    (what == What::kAdded ? one.place_after : one.place_before) = note_alone.place;
    out_.layout.push_back(std::move(one));
  }

  void compare_note(const cdl::LayoutNote& was, const cdl::LayoutNote& is) {
    Difference one = on_page(Thing::kNote, What::kMoved);
    one.kind = is.is_frame ? "frame" : "note";
    one.name_before = words(was);
    one.name_after = words(is);
    one.place_before = was.place;
    one.place_after = is.place;
    note(one, "words", one.name_before, one.name_after);
    if (!one.details.empty()) one.what = What::kChanged;
    note(one, "place", place(was), place(is));
    if (!one.details.empty()) out_.layout.push_back(std::move(one));
  }

  const cdl::Layout& before_;
  const cdl::Layout& after_;
  Renames::Names names_;
  bool keeps_names_ = false;
  Comparison& out_;
};

}  // namespace

void compare_layouts(const cdl::Tree& before, const cdl::Tree& after, Comparison& out) {
  const Called called(out);
  const Layouts now = layouts_of(after);
  const Layouts were = layouts_of(before);
  const auto compare_with = [&](const cdl::Layout& was, const cdl::Layout& is) {
    const std::string& path = was.owner.text;
    LayoutComparison(was, is, called.names(path), called.is_untouched(path), out).run();
  };
  for (const auto& [path, layout] : were) {
    const std::optional<std::string> is = called.page(path);
    if (!is) continue;
    const auto found = now.find(*is);
    cdl::Layout none;
    none.owner.text = *is;
    compare_with(*layout, found == now.end() ? none : *found->second);
  }
  // Where nothing was laid out before, notes may have come.
  for (const auto& [path, layout] : now) {
    const std::optional<std::string> was = called.page_before(path);
    if (!was || were.contains(*was)) continue;
    cdl::Layout none;
    none.owner.text = *was;
    compare_with(none, *layout);
  }
}

}  // namespace mlab::difference
