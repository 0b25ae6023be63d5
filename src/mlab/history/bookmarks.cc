#include "mlab/history/bookmarks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include "mlab/text/utf8.h"

namespace mlab::history {
namespace {

constexpr double kSameMoment = 1e-6;  // [s]

// Where the character that begins here ends.
std::size_t character_end(std::string_view text, std::size_t at) {
  do ++at;
  while (at < text.size() && !text::is_character_boundary(text, at));
  return at;
}

// C0, DEL and C1 as well as the separators of lines and paragraphs, in UTF-8.
bool is_control(std::string_view character) {
  if (character.size() == 1) return static_cast<unsigned char>(character[0]) < 0x20 || character[0] == 0x7f;
  return (character.size() == 2 && character[0] == '\xc2' &&
          static_cast<unsigned char>(character[1]) < 0xa0) ||
         character == "\u2028" || character == "\u2029";
}

std::string no_such_bookmark(std::uint64_t id) {
  return fmt::format("there is no bookmark {}", id);
}

}  // namespace

bool move_into_run(Bookmark& one, const std::optional<RunExtent>& run) {
  const RunExtent most = run.value_or(RunExtent{Bookmarks::kMostNumber, std::numeric_limits<double>::max()});
  const bool has_time = one.time >= 0.0 && one.time <= most.time + kSameMoment;
  const bool has_cycle = one.cycle <= most.cycles;
  if (has_time && has_cycle) return false;
  // Cycles are equally long.
  const bool is_known = run && run->cycles > 0 && run->time > 0.0;
  const double cycle = is_known ? run->time / static_cast<double>(run->cycles) : 0.0;
  if (has_cycle) {
    one.time = static_cast<double>(one.cycle) * cycle;
  } else if (has_time) {
    one.cycle = is_known ? std::min(run->cycles, static_cast<std::uint64_t>(one.time / cycle + 1e-6)) : 0;
  } else {
    const bool is_late = is_known && one.time > 0.0;
    one.cycle = is_late ? run->cycles : 0;
    one.time = is_late ? run->time : 0.0;
  }
  return true;
}

std::string plain_note(std::string_view text, std::size_t most) {
  // Four bytes are the longest character: what is behind is cut off anyway.
  const std::string whole = text::as_utf8(text);
  std::string out;
  std::size_t count = 0;
  bool has_gap = false;
  for (std::size_t at = 0; at < whole.size() && count < most;) {
    const std::size_t end = character_end(whole, at);
    const std::string_view character = std::string_view(whole).substr(at, end - at);
    at = end;
    if (is_control(character) || character == " ") {
      has_gap = !out.empty();
      continue;
    }
    if (std::exchange(has_gap, false) && ++count < most) out += ' ';
    if (count++ < most) out += character;
  }
  while (out.ends_with(' ')) out.pop_back();
  return out;
}

std::expected<std::uint64_t, std::string> Bookmarks::add(Bookmark one) {
  if (all_.size() >= kMost)
    return std::unexpected(fmt::format("there are {} bookmarks already: remove one first", kMost));
  if (!std::isfinite(one.time) || one.time < 0.0 || one.cycle > kMostNumber)
    return std::unexpected("a bookmark is at a moment of the run");
  one.id = last_ + 1;
  if (!put(std::move(one))) return std::unexpected("there is no number left for another bookmark");
  return last_;
}

std::optional<std::string> Bookmarks::set_note(std::uint64_t id, std::string_view note) {
  const auto found = all_.find(id);
  if (found == all_.end()) return no_such_bookmark(id);
  found->second.note = plain_note(note);
  return std::nullopt;
}

std::optional<std::string> Bookmarks::remove(std::uint64_t id) {
  const auto found = all_.find(id);
  if (found == all_.end()) return no_such_bookmark(id);
  if (removed_.size() >= kMost) removed_.erase(removed_.begin());
  removed_.insert(all_.extract(found));
  return std::nullopt;
}

std::optional<std::string> Bookmarks::take_back(std::uint64_t id) {
  const auto found = removed_.find(id);
  if (found == removed_.end()) return fmt::format("bookmark {} can't be brought back", id);
  if (all_.size() >= kMost) return fmt::format("there are {} bookmarks already: remove one first", kMost);
  all_.insert(removed_.extract(found));
  return std::nullopt;
}

bool Bookmarks::put(Bookmark one) {
  const bool is_one = one.id > 0 && one.id <= kMostNumber && one.cycle <= kMostNumber &&
                      std::isfinite(one.time) && one.time >= 0.0;
  if (!is_one || (all_.size() >= kMost && !all_.contains(one.id))) return false;
  one.note = plain_note(one.note);
  one.by = plain_note(one.by, kMostName);
  last_ = std::max(last_, one.id);
  all_[one.id] = std::move(one);
  return true;
}

const Bookmark* Bookmarks::find(std::uint64_t id) const {
  const auto found = all_.find(id);
  return found == all_.end() ? nullptr : &found->second;
}

std::vector<Bookmark> Bookmarks::in_order() const {
  std::vector<Bookmark> out;
  for (const auto& [id, one] : all_) out.push_back(one);
  std::ranges::stable_sort(out, {},
                           [](const Bookmark& one) { return std::tuple(one.time, one.cycle, one.id); });
  return out;
}

}  // namespace mlab::history
