#include "mlab/ways/search_route.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>

namespace mlab::ways {
namespace {

// Shares of a swath: from stop to stop along a lane, and of the two at its ends; how far cells are from the
// first one that are looked at together.
constexpr double kStopEvery = 0.7;
constexpr double kStopsAtEnds = 0.25;
constexpr double kTogether = 0.6;
constexpr std::size_t kPlacesTried = 2;  // in the order, for a new stop
constexpr int kMostRounds = 6;
constexpr double kLeastSaved = 1e-6;    // [m]
constexpr double kLeastDrawnIn = 0.02;  // share of a swath
constexpr double kDrawnInBy = 0.4;      // share of how far a stop is from the straight way
constexpr double kBox = 4.0;            // swaths: a box in which stops are filed
constexpr double kStillWorth = 0.95;    // of what the next best is worth

double metres_of(double cells, const SearchGrid& grid) {
  return cells * grid.cell_area() / grid.swath();
}

}  // namespace

SearchRoute::SearchRoute(SearchGrid& grid, BendingPlanner& planner, std::span<const LaneShare> shares,
                         std::uint64_t most_effort)
    : grid_(grid), planner_(planner), most_effort_(most_effort) {
  for (const LaneShare& share : shares) {
    for (const LanePiece& piece : share) append(piece);
    end_share();
  }
  for (int row = 0; stops_.empty() && row < grid.rows(); ++row) {
    for (int column = 0; stops_.empty() && column < grid.columns(); ++column) {
      if (!grid.can_be_seen(grid.index(column, row))) continue;
      if (const auto at = grid.lookout(column, row)) append(*at);
    }
  }
}

std::optional<SearchRoute::Leg> SearchRoute::leg(geom::Point a, geom::Point b) {
  if (planner_.clearing().is_free(geom::Segment{a, b})) return Leg{{a, b}, distance(a, b)};
  auto way = planner_.find(a, b);
  if (!way) return std::nullopt;
  // With corners where it bends, as a robot follows it.
  double length = 0.0;
  for (std::size_t i = 1; i < way->corners.size(); ++i)
    length += distance(way->corners[i - 1], way->corners[i]);
  return Leg{std::move(way->corners), length};
}

void SearchRoute::see(const Leg& leg, int by) {
  if (grid_.sees_all_round()) {
    for (std::size_t i = 1; i < leg.corners.size(); ++i) grid_.see({leg.corners[i - 1], leg.corners[i]}, by);
    return;
  }
  if (leg.seen.empty()) {
    for (std::size_t i = 1; i < leg.corners.size(); ++i)
      grid_.add_seen({leg.corners[i - 1], leg.corners[i]}, leg.seen);
  }
  grid_.see(leg.seen, by);
}

/// What a way sees that has one stop and no leg.
void SearchRoute::see_only_stop(int by) {
  if (stops_.size() == 1) grid_.see({stops_.front().at, stops_.front().at}, by);
}

/// Who would have one stop only belongs to the share before.
void SearchRoute::end_share() {
  if (stops_.size() < 2) return;
  if (is_first(std::prev(stops_.end()))) {
    const geom::Point at = stops_.back().at;
    stops_.pop_back();
    is_new_share_ = false;
    append(at);
  }
  is_new_share_ = true;
}

void SearchRoute::append(geom::Point at) {
  const bool begins = std::exchange(is_new_share_, false);
  if (!stops_.empty() && !begins) {
    if (stops_.back().at == at) return;
    auto onward = leg(stops_.back().at, at);
    if (!onward) return;
    see(*onward, 1);
    see_only_stop(-1);
    stops_.back().onward = std::move(*onward);
    stops_.back().is_last = false;
  }
  stops_.push_back({at, {}});
  see_only_stop(1);
}

void SearchRoute::append(const LanePiece& piece) {
  const double length = distance(piece.a, piece.b);
  const geom::Offset along = unit(piece.b - piece.a);
  const double end = kStopsAtEnds * grid_.swath();
  append(piece.a);
  if (length > 2.0 * end) {
    const double between = length - 2.0 * end;
    const int count = std::max(1, static_cast<int>(std::ceil(between / (kStopEvery * grid_.swath()))));
    for (int i = 0; i <= count; ++i) append(piece.a + along * (end + between * i / count));
  }
  append(piece.b);
}

void SearchRoute::shorten(double price, std::size_t most_unseen) {
  const Bargain bargain{price, most_unseen};
  bool goes_on = true;
  for (int round = 0; goes_on && round < kMostRounds; ++round) {
    goes_on = false;
    for (auto stop = stops_.begin(); stop != stops_.end() && !is_tired();) {
      const auto here = stop++;
      // What wasn't worth it isn't now that less is seen.
      if (here->refused >= price) continue;
      here->refused = price;
      goes_on |= leave_out(here, bargain) || draw_in(here, bargain);
    }
  }
}

/// Sees from some legs and no longer from others, if that is worth it.
bool SearchRoute::exchange(std::span<const Leg* const> old, std::span<const Leg* const> instead,
                           const Bargain& bargain) {
  double saved = 0.0;
  for (const Leg* leg : old) saved += leg->length;
  for (const Leg* leg : instead) saved -= leg->length;
  if (saved < kLeastSaved) return false;
  const std::size_t unseen = grid_.unseen();
  for (const Leg* leg : instead) see(*leg, 1);
  for (const Leg* leg : old) see(*leg, -1);
  const double lost = static_cast<double>(grid_.unseen()) - static_cast<double>(unseen);
  if (lost <= 0.0 ||
      (grid_.unseen() <= bargain.most_unseen && metres_of(lost, grid_) <= bargain.price * saved))
    return true;
  for (const Leg* leg : old) see(*leg, 1);
  for (const Leg* leg : instead) see(*leg, -1);
  return false;
}

/// The way past a stop, as long as neither it nor those beside it change.
const SearchRoute::Leg* SearchRoute::shortcut(Place stop) {
  if (stop->shortcut) return &*stop->shortcut;
  const geom::Point a = std::prev(stop)->at;
  const geom::Point b = std::next(stop)->at;
  if (std::prev(stop)->onward.length + stop->onward.length - distance(a, b) < kLeastSaved) return nullptr;
  stop->shortcut = leg(a, b);
  return stop->shortcut ? &*stop->shortcut : nullptr;
}

void SearchRoute::has_changed(Place stop) {
  const auto forget = [](Stop& one) {
    one.shortcut.reset();
    one.refused = Stop::kNotYet;
  };
  if (stop == stops_.end()) return;
  forget(*stop);
  if (stop != stops_.begin()) forget(*std::prev(stop));
  if (std::next(stop) != stops_.end()) forget(*std::next(stop));
}

bool SearchRoute::leave_out(Place stop, const Bargain& bargain) {
  if (is_first(stop) || stop->is_last) {
    if (!leave_end_out(stop, bargain)) return false;
  } else {
    Leg& before = std::prev(stop)->onward;
    const Leg* instead = shortcut(stop);
    if (instead == nullptr || !exchange(std::array<const Leg*, 2>{&before, &stop->onward},
                                        std::array<const Leg*, 1>{instead}, bargain))
      return false;
    before = std::move(*stop->shortcut);
  }
  const auto after = stops_.erase(stop);
  has_changed(after);
  if (after != stops_.begin()) has_changed(std::prev(after));
  return true;
}

/// Whether the first or the last one of a share, which has two more, may go; where it may, its leg is gone.
bool SearchRoute::leave_end_out(Place stop, const Bargain& bargain) {
  const bool is_last = stop->is_last;
  if (is_last && is_first(stop)) return false;
  const auto beside = is_last ? std::prev(stop) : std::next(stop);
  if (is_last ? is_first(beside) : beside->is_last) return false;
  Leg& end = is_last ? beside->onward : stop->onward;
  if (!exchange(std::array<const Leg*, 1>{&end}, {}, bargain)) return false;
  end = {};
  if (is_last) beside->is_last = true;
  return true;
}

/// Moves a stop towards the straight way from the one before to the next.
bool SearchRoute::draw_in(Place stop, const Bargain& bargain) {
  if (is_first(stop) || stop->is_last) return false;
  const auto next = std::next(stop);
  const auto before = std::prev(stop);
  const geom::Point aim = nearest_point({before->at, next->at}, stop->at);
  if (distance(aim, stop->at) < kLeastDrawnIn * grid_.swath()) return false;
  const geom::Point at = stop->at + (aim - stop->at) * kDrawnInBy;
  const auto straight = [&](geom::Point a, geom::Point b) { return Leg{{a, b}, distance(a, b)}; };
  Leg to = straight(before->at, at);
  Leg from = straight(at, next->at);
  const Clearing& clearing = planner_.clearing();
  if (!clearing.is_free(geom::Segment{before->at, at}) || !clearing.is_free(geom::Segment{at, next->at}))
    return false;
  if (!exchange(std::array<const Leg*, 2>{&before->onward, &stop->onward},
                std::array<const Leg*, 2>{&to, &from}, bargain))
    return false;
  before->onward = std::move(to);
  stop->onward = std::move(from);
  stop->at = at;
  has_changed(stop);
  return true;
}

void SearchRoute::complete(std::size_t most_unseen) {
  for (int round = 0; round < kMostRounds && grid_.unseen() > most_unseen; ++round) {
    const std::size_t unseen = grid_.unseen();
    file_stops();
    auto patches = unseen_patches(round == 0 ? most_unseen / 2 : 0);
    add_for(patches, most_unseen);
    if (grid_.unseen() == unseen) return;
  }
}

/// All of them but the smallest, which together have no more cells than that.
std::vector<SearchRoute::Patch> SearchRoute::unseen_patches(std::size_t left_out) const {
  std::vector<std::uint8_t> was_met(static_cast<std::size_t>(grid_.columns()) *
                                    static_cast<std::size_t>(grid_.rows()));
  std::vector<Patch> out;
  for (int row = 0; row < grid_.rows(); ++row) {
    for (int column = 0; column < grid_.columns(); ++column) {
      const std::size_t cell = grid_.index(column, row);
      if (grid_.is_unseen(cell) && was_met[cell] == 0) out.push_back(unseen_round(column, row, was_met));
    }
  }
  std::ranges::stable_sort(out, std::greater<>(), &Patch::size);
  for (std::size_t gone = 0; !out.empty() && gone + out.back().size() <= left_out; out.pop_back())
    gone += out.back().size();
  return out;
}

/// The best bargain first; looked at once more when its turn comes, as others have changed the way since.
void SearchRoute::add_for(std::vector<Patch>& patches, std::size_t most_unseen) {
  using Offer = std::pair<double, std::size_t>;  // what it is worth, and its patch, later ones behind
  std::priority_queue<Offer> offers;
  const auto offer = [&](std::size_t patch) {
    if (const auto one = best_detour(patches[patch])) offers.emplace(one->worth(), patches.size() - patch);
  };
  for (std::size_t patch = 0; patch < patches.size() && !is_tired(); ++patch) offer(patch);
  while (!offers.empty() && grid_.unseen() > most_unseen && !is_tired()) {
    const std::size_t patch = patches.size() - offers.top().second;
    offers.pop();
    std::erase_if(patches[patch], [&](std::size_t cell) { return !grid_.is_unseen(cell); });
    if (patches[patch].empty()) continue;
    auto one = best_detour(patches[patch]);
    if (!one) continue;
    if (!offers.empty() && one->worth() < kStillWorth * offers.top().first) {
      offers.emplace(one->worth(), patches.size() - patch);
      continue;
    }
    insert(*one);
    std::erase_if(patches[patch], [&](std::size_t cell) { return !grid_.is_unseen(cell); });
    if (!patches[patch].empty()) offer(patch);
  }
}

/// Those that hang together with a cell, and aren't far from it.
SearchRoute::Patch SearchRoute::unseen_round(int column, int row, std::vector<std::uint8_t>& was_met) const {
  const geom::Point first = grid_.middle(column, row);
  Patch out;
  const auto add = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= grid_.columns() || y >= grid_.rows()) return;
    const std::size_t cell = grid_.index(x, y);
    if (was_met[cell] != 0 || !grid_.is_unseen(cell)) return;
    if (distance(grid_.middle(x, y), first) > kTogether * grid_.swath()) return;
    was_met[cell] = 1;
    out.push_back(cell);
  };
  add(column, row);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const int x = column_of(out[i]);
    const int y = row_of(out[i]);
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) add(x + dx, y + dy);
    }
  }
  return out;
}

void SearchRoute::file_stops() {
  const double size = kBox * grid_.swath();
  const Lanes& lanes = grid_.lanes();
  boxes_along_ = 1 + static_cast<int>(lanes.length / size);
  boxes_across_ = 1 + static_cast<int>(lanes.spacing * lanes.count / size);
  boxes_.assign(static_cast<std::size_t>(boxes_along_) * static_cast<std::size_t>(boxes_across_), {});
  for (auto stop = stops_.begin(); stop != stops_.end(); ++stop) file(stop);
}

void SearchRoute::file(Place stop) {
  boxes_[box_of(stop->at)].push_back(stop);
}

std::size_t SearchRoute::box_of(geom::Point p) const {
  const LanePlace at = grid_.lanes().to_lanes(p);
  const double size = kBox * grid_.swath();
  const auto along = static_cast<int>(std::clamp(at.along / size, 0.0, boxes_along_ - 1.0));
  const auto across = static_cast<int>(std::clamp(at.across / size, 0.0, boxes_across_ - 1.0));
  return static_cast<std::size_t>(across) * static_cast<std::size_t>(boxes_along_) +
         static_cast<std::size_t>(along);
}

/// Those in the box of a place and in the boxes around it; all where there are none.
template <class Visit>
void SearchRoute::each_stop_near(geom::Point p, const Visit& visit) const {
  const auto box = static_cast<int>(box_of(p));
  const int along = box % boxes_along_;
  const int across = box / boxes_along_;
  bool is_any = false;
  for (int y = std::max(across - 1, 0); y <= std::min(across + 1, boxes_across_ - 1); ++y) {
    for (int x = std::max(along - 1, 0); x <= std::min(along + 1, boxes_along_ - 1); ++x) {
      for (const auto stop : boxes_[static_cast<std::size_t>(y) * static_cast<std::size_t>(boxes_along_) +
                                    static_cast<std::size_t>(x)]) {
        is_any = true;
        visit(stop);
      }
    }
  }
  if (is_any) return;
  for (const auto& stops : boxes_) {
    for (const auto stop : stops) visit(stop);
  }
}

geom::Point SearchRoute::nearest(geom::Point p) const {
  geom::Point out = stops_.front().at;
  double least = distance(out, p);
  each_stop_near(p, [&](Place stop) {
    if (distance(stop->at, p) - stop->onward.length >= least) return;
    for (std::size_t i = 1; i < stop->onward.corners.size(); ++i) {
      const geom::Point at = nearest_point({stop->onward.corners[i - 1], stop->onward.corners[i]}, p);
      if (distance(at, p) >= least) continue;
      least = distance(at, p);
      out = at;
    }
  });
  return out;
}

/// Places from which some of the cells are seen: between their middle and the way as it is, and where it must
/// be.
std::vector<geom::Point> SearchRoute::candidates(const Patch& cells) const {
  const geom::Point origin = grid_.lanes().origin;
  geom::Offset sum;
  for (const std::size_t cell : cells) sum = sum + (grid_.middle(column_of(cell), row_of(cell)) - origin);
  const geom::Point center = origin + sum * (1.0 / static_cast<double>(cells.size()));
  const geom::Point from = nearest(center);
  const Clearing& clearing = planner_.clearing();
  std::vector<geom::Point> out;
  for (const double share : {0.5, 1.0}) {
    const auto at = clearing.nearest_free(from + (center - from) * share);
    if (at && std::ranges::find(out, *at) == out.end() && grid_.may_be_at(*at, clearing)) out.push_back(*at);
  }
  if (!out.empty()) return out;
  if (const auto at = grid_.lookout(column_of(cells.front()), row_of(cells.front()))) out.push_back(*at);
  return out;
}

std::optional<SearchRoute::Detour> SearchRoute::best_detour(const Patch& cells) {
  std::optional<Detour> best;
  const auto offer = [&](geom::Point at) {
    auto one = detour(at);
    if (!one) return;
    count_gain(*one);
    if (one->gain > 0 && (!best || one->worth() > best->worth())) best = std::move(one);
  };
  for (const geom::Point at : candidates(cells)) offer(at);
  if (best || grid_.sees_all_round()) return best;
  // All of those were behind walls.
  if (const auto at = grid_.lookout(column_of(cells.front()), row_of(cells.front()))) offer(*at);
  return best;
}

/// The shortest one to a place.
std::optional<SearchRoute::Detour> SearchRoute::detour(geom::Point at) {
  std::vector<Slot> slots;
  const auto offer = [&](const Slot& slot) {
    if (slots.size() == kPlacesTried && slot.extra >= slots.back().extra) return;
    if (slots.size() == kPlacesTried) slots.pop_back();
    slots.insert(std::ranges::upper_bound(slots, slot.extra, {}, &Slot::extra), slot);
  };
  each_stop_near(at, [&](Place stop) {
    ++effort_;
    const double here = distance(at, stop->at);
    if (is_first(stop)) offer({stop, false, true, here});
    const auto next = std::next(stop);
    if (stop->is_last)
      offer({next, true, false, here});
    else
      offer({next, true, true, here - stop->onward.length + distance(at, next->at)});
  });
  std::optional<Detour> out;
  for (const Slot& slot : slots) {
    if (out && slot.extra >= out->extra) break;
    auto one = detour(at, slot);
    if (one && (!out || one->extra < out->extra)) out = std::move(one);
  }
  return out;
}

std::optional<SearchRoute::Detour> SearchRoute::detour(geom::Point at, const Slot& slot) {
  Detour out{at, slot.before, {}, {}, 0.0, 0};
  if (slot.has_leg_to) {
    out.to = leg(std::prev(slot.before)->at, at);
    if (!out.to) return std::nullopt;
    out.extra += out.to->length - std::prev(slot.before)->onward.length;
  }
  if (slot.has_leg_from) {
    out.from = leg(at, slot.before->at);
    if (!out.from) return std::nullopt;
    out.extra += out.from->length;
  }
  return out;
}

/// The legs that a detour has, and instead of which one.
void SearchRoute::see(const Detour& detour, int by) {
  if (detour.to) see(*detour.to, by);
  if (detour.from) see(*detour.from, by);
  if (detour.to && detour.from) see(std::prev(detour.before)->onward, -by);
}

void SearchRoute::count_gain(Detour& detour) {
  const std::size_t unseen = grid_.unseen();
  see(detour, 1);
  detour.gain = grid_.unseen() < unseen ? unseen - grid_.unseen() : 0;
  see(detour, -1);
}

void SearchRoute::insert(Detour& detour) {
  see_only_stop(-1);
  see(detour, 1);
  Stop added{detour.at, {}};
  if (detour.to) {
    const auto last = std::prev(detour.before);
    last->onward = std::move(*detour.to);
    last->is_last = false;
  }
  if (detour.from) {
    added.onward = std::move(*detour.from);
    added.is_last = false;
  }
  const auto place = stops_.insert(detour.before, std::move(added));
  file(place);
  has_changed(place);
}

double SearchRoute::length() const {
  double out = 0.0;
  for (const Stop& stop : stops_) out += stop.onward.length;
  return out;
}

SearchRoute::Waypoints SearchRoute::waypoints() const {
  Waypoints out;
  bool begins = true;
  for (const Stop& stop : stops_) {
    if (begins) out.shares.push_back(out.stops.size());
    begins = stop.is_last;
    while (out.stops.size() >= out.shares.back() + 2) {
      const geom::Segment straight{out.stops[out.stops.size() - 2], stop.at};
      if (distance(nearest_point(straight, out.stops.back()), out.stops.back()) > 1e-6 ||
          !planner_.clearing().is_free(straight))
        break;
      out.stops.pop_back();
      out.corners.pop_back();
      out.corners.back().clear();
    }
    out.stops.push_back(stop.at);
    const std::vector<geom::Point>& way = stop.onward.corners;
    out.corners.emplace_back();
    if (way.size() > 2) out.corners.back().assign(way.begin() + 1, way.end() - 1);
  }
  return out;
}

}  // namespace mlab::ways
