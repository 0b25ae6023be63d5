#include "mlab/ways/search_route.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace mlab::ways {
namespace {

// Shares of a swath: from stop to stop along a lane, and of the two at its ends; how far cells are from the
// first one that are looked at together.
constexpr double kStopEvery = 0.7;
constexpr double kStopsAtEnds = 0.25;
constexpr double kTogether = 0.6;
constexpr std::size_t kPlacesTried = 3;  // in the order, for a new stop
constexpr int kMostRounds = 6;

double metres_of(double cells, const SearchGrid& grid) {
  return cells * grid.cell_area() / grid.swath();
}

}  // namespace

SearchRoute::SearchRoute(SearchGrid& grid, Planner& planner, std::span<const LanePiece> pieces)
    : grid_(grid), planner_(planner) {
  for (const LanePiece& piece : pieces) append(piece);
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
  for (std::size_t i = 1; i < leg.corners.size(); ++i) grid_.see({leg.corners[i - 1], leg.corners[i]}, by);
}

/// What a way sees that has one stop and no leg.
void SearchRoute::see_only_stop(int by) {
  if (stops_.size() == 1) grid_.see({stops_.front().at, stops_.front().at}, by);
}

void SearchRoute::append(geom::Point at) {
  if (!stops_.empty()) {
    if (stops_.back().at == at) return;
    auto onward = leg(stops_.back().at, at);
    if (!onward) return;
    see(*onward, 1);
    see_only_stop(-1);
    stops_.back().onward = std::move(*onward);
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
    const double count = std::max(1.0, std::ceil(between / (kStopEvery * grid_.swath())));
    for (double i = 0.0; i <= count; ++i) append(piece.a + along * (end + between * i / count));
  }
  append(piece.b);
}

void SearchRoute::shorten(double price, std::size_t most_unseen) {
  bool goes_on = true;
  for (int round = 0; goes_on && round < kMostRounds; ++round) {
    goes_on = false;
    for (auto stop = stops_.begin(); stop != stops_.end();) {
      const auto here = stop++;
      goes_on |= leave_out(here, price, most_unseen);
    }
  }
}

bool SearchRoute::leave_out(Place stop, double price, std::size_t most_unseen) {
  if (stops_.size() < 3) return false;
  const bool is_first = stop == stops_.begin();
  const bool is_last = std::next(stop) == stops_.end();
  const auto before = is_first ? stops_.end() : std::prev(stop);
  double saved = stop->onward.length + (is_first ? 0.0 : before->onward.length);
  Leg instead;
  if (!is_first && !is_last) {
    if (saved - distance(before->at, std::next(stop)->at) < 1e-6) return false;
    auto found = leg(before->at, std::next(stop)->at);
    if (!found) return false;
    instead = std::move(*found);
  }
  saved -= instead.length;
  if (saved < 1e-6) return false;
  const std::size_t unseen = grid_.unseen();
  see(instead, 1);
  see(stop->onward, -1);
  if (!is_first) see(before->onward, -1);
  const double lost = static_cast<double>(grid_.unseen()) - static_cast<double>(unseen);
  if (lost <= 0.0 || (grid_.unseen() <= most_unseen && metres_of(lost, grid_) <= price * saved)) {
    if (!is_first) before->onward = std::move(instead);
    stops_.erase(stop);
    return true;
  }
  see(instead, -1);
  see(stop->onward, 1);
  if (!is_first) see(before->onward, 1);
  return false;
}

void SearchRoute::complete(double price, std::size_t most_unseen) {
  bool goes_on = true;
  for (int round = 0; goes_on && round < kMostRounds; ++round) {
    goes_on = false;
    std::vector<std::uint8_t> was_tried(static_cast<std::size_t>(grid_.columns()) *
                                        static_cast<std::size_t>(grid_.rows()));
    for (int row = 0; row < grid_.rows(); ++row) {
      for (int column = 0; column < grid_.columns(); ++column) {
        if (grid_.unseen() <= most_unseen) return;
        const std::size_t cell = grid_.index(column, row);
        if (grid_.is_unseen(cell) && was_tried[cell] == 0) goes_on |= add_for(column, row, price, was_tried);
      }
    }
  }
}

/// Those that hang together with a cell, and aren't far from it.
std::vector<std::size_t> SearchRoute::unseen_round(int column, int row,
                                                   std::vector<std::uint8_t>& was_tried) const {
  const geom::Point first = grid_.middle(column, row);
  std::vector<std::size_t> out;
  const auto add = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= grid_.columns() || y >= grid_.rows()) return;
    const std::size_t cell = grid_.index(x, y);
    if (was_tried[cell] != 0 || !grid_.is_unseen(cell)) return;
    if (distance(grid_.middle(x, y), first) > kTogether * grid_.swath()) return;
    was_tried[cell] = 1;
    out.push_back(cell);
  };
  add(column, row);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const int x = static_cast<int>(out[i] % static_cast<std::size_t>(grid_.columns()));
    const int y = static_cast<int>(out[i] / static_cast<std::size_t>(grid_.columns()));
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) add(x + dx, y + dy);
    }
  }
  return out;
}

geom::Point SearchRoute::nearest(geom::Point p) const {
  geom::Point out = stops_.front().at;
  for (const Stop& stop : stops_) {
    for (std::size_t i = 1; i < stop.onward.corners.size(); ++i) {
      const geom::Point at = nearest_point({stop.onward.corners[i - 1], stop.onward.corners[i]}, p);
      if (distance(at, p) < distance(out, p)) out = at;
    }
  }
  return out;
}

/// Places from which some of the cells are seen: between their middle and the way as it is, and where it must
/// be.
std::vector<geom::Point> SearchRoute::candidates(const std::vector<std::size_t>& cells) const {
  geom::Offset sum;
  const geom::Point origin = grid_.lanes().origin;
  const auto columns = static_cast<std::size_t>(grid_.columns());
  const auto middle = [&](std::size_t cell) {
    return grid_.middle(static_cast<int>(cell % columns), static_cast<int>(cell / columns));
  };
  for (const std::size_t cell : cells) sum = sum + (middle(cell) - origin);
  const geom::Point center = origin + sum * (1.0 / static_cast<double>(cells.size()));
  const geom::Point from = nearest(center);
  std::vector<geom::Point> out;
  for (const double share : {0.3, 0.5, 0.75, 1.0}) {
    const auto at = planner_.clearing().nearest_free(from + (center - from) * share);
    if (at && grid_.may_be_at(*at, planner_.clearing())) out.push_back(*at);
  }
  const auto columns_int = grid_.columns();
  const int first = static_cast<int>(cells.front() % columns);
  const int row = static_cast<int>(cells.front()) / columns_int;
  if (out.empty()) {
    if (const auto at = grid_.lookout(first, row)) out.push_back(*at);
  }
  return out;
}

bool SearchRoute::add_for(int column, int row, double price, std::vector<std::uint8_t>& was_tried) {
  const auto cells = unseen_round(column, row, was_tried);
  std::optional<Detour> best;
  const auto worth = [](const Detour& one) { return static_cast<double>(one.gain) / (one.extra + 1e-6); };
  for (const geom::Point at : candidates(cells)) {
    auto one = detour(at);
    if (!one) continue;
    count_gain(*one);
    if (one->gain > 0 && (!best || worth(*one) > worth(*best))) best = std::move(one);
  }
  if (!best || metres_of(static_cast<double>(best->gain), grid_) < price * best->extra) return false;
  insert(*best);
  return true;
}

/// The shortest one to a place.
std::optional<SearchRoute::Detour> SearchRoute::detour(geom::Point at) {
  std::vector<std::pair<double, Place>> places;  // what it costs at least
  const auto offer = [&](double extra, Place before) {
    if (places.size() == kPlacesTried && extra >= places.back().first) return;
    if (places.size() == kPlacesTried) places.pop_back();
    const auto after = std::ranges::upper_bound(places, extra, {}, [](const auto& one) { return one.first; });
    places.insert(after, {extra, before});
  };
  for (auto stop = stops_.begin(); stop != stops_.end(); ++stop) {
    double extra = distance(at, stop->at);
    if (stop != stops_.begin()) extra += distance(at, std::prev(stop)->at) - std::prev(stop)->onward.length;
    offer(extra, stop);
  }
  offer(distance(at, stops_.back().at), stops_.end());
  std::optional<Detour> out;
  for (const auto& [least, before] : places) {
    if (out && least >= out->extra) break;
    Detour one{at, before, {}, {}, 0.0, 0};
    if (before != stops_.begin()) {
      auto to = leg(std::prev(before)->at, at);
      if (!to) continue;
      one.to = std::move(*to);
      one.extra -= std::prev(before)->onward.length;
    }
    if (before != stops_.end()) {
      auto from = leg(at, before->at);
      if (!from) continue;
      one.from = std::move(*from);
    }
    one.extra += one.to.length + one.from.length;
    if (!out || one.extra < out->extra) out = std::move(one);
  }
  return out;
}

void SearchRoute::count_gain(Detour& detour) {
  const bool has_leg = detour.before != stops_.begin();
  const std::size_t unseen = grid_.unseen();
  see(detour.to, 1);
  see(detour.from, 1);
  if (has_leg) see(std::prev(detour.before)->onward, -1);
  detour.gain = grid_.unseen() < unseen ? unseen - grid_.unseen() : 0;
  if (has_leg) see(std::prev(detour.before)->onward, 1);
  see(detour.to, -1);
  see(detour.from, -1);
}

void SearchRoute::insert(Detour& detour) {
  see_only_stop(-1);
  see(detour.to, 1);
  see(detour.from, 1);
  if (detour.before != stops_.begin()) {
    see(std::prev(detour.before)->onward, -1);
    std::prev(detour.before)->onward = std::move(detour.to);
  }
  stops_.insert(detour.before, {detour.at, std::move(detour.from)});
}

double SearchRoute::length() const {
  double out = 0.0;
  for (const Stop& stop : stops_) out += stop.onward.length;
  return out;
}

std::vector<geom::Point> SearchRoute::waypoints() const {
  std::vector<geom::Point> out;
  for (const Stop& stop : stops_) {
    while (out.size() >= 2) {
      const geom::Segment straight{out[out.size() - 2], stop.at};
      if (distance(nearest_point(straight, out.back()), out.back()) > 1e-6 ||
          !planner_.clearing().is_free(straight))
        break;
      out.pop_back();
    }
    out.push_back(stop.at);
  }
  return out;
}

}  // namespace mlab::ways
