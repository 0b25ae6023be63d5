#include "mlab/comparison/as_recorded.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include <fmt/core.h>

#include "mlab/base/angle.h"

namespace mlab::comparison {
namespace {

using history::History;
using history::MarkEntry;
using history::PosesEntry;

constexpr std::size_t kMostRobotsRecorded = 2000;
constexpr std::size_t kMostSamplesRecorded = 1000;
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

struct Place {
  float x = kNone;
  float y = kNone;
  float heading = kNone;
};
using Places = std::map<std::uint32_t, Place>;

// The last word counts where a robot is named twice.
Places places_of(const PosesEntry& entry) {
  Places out;
  const wire::HistoryPoses& poses = entry.poses;
  for (int i = 0; i < poses.robots_size(); ++i)
    out[poses.robots(i)] = {poses.x(i), poses.y(i), poses.heading(i)};
  return out;
}

std::string text_of(const Place& place) {
  return fmt::format("({}, {}) heading {}", place.x, place.y,
                     base::degrees(static_cast<double>(place.heading)));
}

float distance_between(const Place& a, const Place& b) {
  const double x = static_cast<double>(a.x) - static_cast<double>(b.x);
  const double y = static_cast<double>(a.y) - static_cast<double>(b.y);
  return static_cast<float>(std::sqrt(x * x + y * y));
}

bool is_same(const Place& a, const Place& b) {
  const auto bits = [](float value) { return std::bit_cast<std::uint32_t>(value); };
  return bits(a.x) == bits(b.x) && bits(a.y) == bits(b.y) && bits(a.heading) == bits(b.heading);
}

// The last cycle of which both have the same mark.
std::optional<std::uint64_t> same_mark(const Both<const History*>& histories) {
  std::optional<std::uint64_t> out;
  const std::vector<MarkEntry>& a = histories[0]->marks();
  const std::vector<MarkEntry>& b = histories[1]->marks();
  for (std::size_t i = 0, k = 0; i < a.size() && k < b.size();) {
    if (a[i].cycle != b[k].cycle) {
      (a[i].cycle < b[k].cycle ? i : k) += 1;
      continue;
    }
    if (a[i].digest != b[k].digest) break;
    out = a[i].cycle;
    ++i, ++k;
  }
  return out;
}

class RecordedRows {
 public:
  RecordedRows(const Both<const History*>& histories, Comparison& out) : out_(out) {
    const std::size_t count = std::min(histories[0]->poses().size(), histories[1]->poses().size());
    stride_ = count / kMostSamplesRecorded + 1;
  }

  void add(const PosesEntry& a, const PosesEntry& b) {
    const Both<Places> places = {places_of(a), places_of(b)};
    if (!out_.parting) part(a, places);
    const bool is_sample = count_++ % stride_ == 0;
    if (is_sample) out_.times.push_back(a.time);
    for (const std::size_t side : kSides) {
      for (const auto& [id, place] : places[side]) {
        if (rows_.size() < kMostRobotsRecorded || rows_.contains(id)) rows_[id].is_there[side] = true;
      }
    }
    for (auto& [id, row] : rows_) note(places, id, a.time, is_sample, row);
  }
  std::vector<RobotRow> take() {
    std::vector<RobotRow> out;
    for (auto& [id, row] : rows_) out.push_back(std::move(row));
    return out;
  }

 private:
  static Place place_in(const Places& places, std::uint32_t id) {
    const auto found = places.find(id);
    return found == places.end() ? Place{} : found->second;
  }
  void note(const Both<Places>& places, std::uint32_t id, double time, bool is_sample, RobotRow& row) const {
    row.id = id;
    const Place a = place_in(places[0], id);
    const Place b = place_in(places[1], id);
    const float apart = distance_between(a, b);
    if (std::isfinite(apart)) {
      row.apart_at_end = static_cast<double>(apart);
      if (row.apart_at_end > row.most_apart) {
        row.most_apart = row.apart_at_end;
        row.most_apart_at = time;
      }
    }
    if (!is_sample) return;
    const std::size_t before = out_.times.size() - 1;
    row.apart.resize(before, kNone);
    row.apart.push_back(std::isfinite(apart) ? apart : kNone);
    row.ways[0].resize(before, {kNone, kNone});
    row.ways[1].resize(before, {kNone, kNone});
    row.ways[0].emplace_back(a.x, a.y);
    row.ways[1].emplace_back(b.x, b.y);
  }
  void part(const PosesEntry& entry, const Both<Places>& places) {
    Parting parting;
    for (const std::size_t side : kSides) {
      for (const auto& [id, place] : places[side]) {
        const auto other = places[1 - side].find(id);
        if (other != places[1 - side].end() && (side == 1 || is_same(place, other->second))) continue;
        parting.robots.push_back(id);
      }
    }
    if (parting.robots.empty()) return;
    std::ranges::sort(parting.robots);
    parting.what = Parting::What::kPlace;
    parting.cycle = entry.cycle;
    parting.time = entry.time;
    parting.robot = parting.robots.front();
    parting.value.path = "where it is";
    for (const std::size_t side : kSides) {
      const auto found = places[side].find(parting.robot);
      parting.value.values[side] = found == places[side].end() ? "not in the world" : text_of(found->second);
    }
    parting.values = 1;
    out_.parting = std::move(parting);
  }

  Comparison& out_;
  std::map<std::uint32_t, RobotRow> rows_;
  std::size_t stride_ = 1;
  std::size_t count_ = 0;
};

// Two that were told to have ended otherwise are not the same, wherever robots were.
void compare_ends(const Both<const History*>& histories, Comparison& out) {
  const std::optional<history::EndEntry>& a = histories[0]->end();
  const std::optional<history::EndEntry>& b = histories[1]->end();
  const bool is_same_end =
      a.has_value() == b.has_value() &&
      (!a || (a->cycle == b->cycle && a->outcome == b->outcome && a->digest == b->digest)) &&
      histories[0]->last_cycle() == histories[1]->last_cycle();
  if (out.parting || is_same_end) return;
  Parting parting;
  parting.what = Parting::What::kEnd;
  parting.cycle = std::min(histories[0]->last_cycle(), histories[1]->last_cycle());
  parting.time = std::min(histories[0]->last_time(), histories[1]->last_time());
  parting.value.path = "the end";
  for (const std::size_t side : kSides) {
    const std::optional<history::EndEntry>& end = histories[side]->end();
    parting.value.values[side] =
        fmt::format("{} after {} cycles", end ? end->outcome : "cut off", histories[side]->last_cycle());
  }
  out.parting = std::move(parting);
}

}  // namespace

void compare_recorded(const Both<const History*>& histories, Comparison& out) {
  RecordedRows rows(histories, out);
  const std::vector<PosesEntry>& a = histories[0]->poses();
  const std::vector<PosesEntry>& b = histories[1]->poses();
  for (std::size_t i = 0, k = 0; i < a.size() && k < b.size();) {
    // Only of the same moment: between two of them nobody knows.
    const double ahead = a[i].time - b[k].time;
    if (std::abs(ahead) > 1e-9) {
      (ahead < 0.0 ? i : k) += 1;
      continue;
    }
    rows.add(a[i++], b[k++]);
  }
  out.robots = rows.take();
  compare_ends(histories, out);
  if (out.parting) out.parting->same_until = same_mark(histories);
}

}  // namespace mlab::comparison
