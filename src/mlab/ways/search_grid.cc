#include "mlab/ways/search_grid.h"

#include <array>
#include <limits>
#include <utility>

namespace mlab::ways {
namespace {

constexpr double kFine = 0.025;          // a cell is no smaller than this share of a swath
constexpr double kCoarse = 0.2;          // and no larger
constexpr double kUsualCells = 300'000;  // in between, so that there are about so many
constexpr double kUnsure = 0.25;  // of a cell, that is not counted on: what its middle is, isn't all of it
constexpr std::size_t kMostParts = 64;  // of the ground that are joined, the largest ones

}  // namespace

std::optional<SearchGrid> SearchGrid::over(const Lanes& lanes, double swath) {
  SearchGrid out;
  out.lanes_ = lanes;
  out.swath_ = swath;
  const double width = lanes.spacing * lanes.count;
  const double wanted = std::sqrt(lanes.length * width / kUsualCells);
  const double step = std::clamp(wanted, kFine * swath, kCoarse * swath);
  out.rows_of_lane_ = 2 * static_cast<int>(std::ceil(0.5 * (lanes.spacing / step - 1.0))) + 1;
  out.step_across_ = lanes.spacing / out.rows_of_lane_;
  // Odd as well, so that what is smaller than a cell holds the middle of one.
  const double columns = 2.0 * std::ceil(0.5 * (lanes.length / step - 1.0)) + 1.0;
  if (!(columns < static_cast<double>(kMostCells))) return std::nullopt;
  out.step_along_ = lanes.length / columns;
  out.reach_ = 0.5 * swath - kUnsure * std::max(out.step_along_, out.step_across_);
  out.margin_columns_ = static_cast<int>(std::ceil(0.5 * swath / out.step_along_)) + 1;
  out.margin_rows_ = static_cast<int>(std::ceil(0.5 * swath / out.step_across_)) + 1;
  out.columns_ = static_cast<int>(columns) + 2 * out.margin_columns_;
  out.rows_ = out.rows_of_lane_ * lanes.count + 2 * out.margin_rows_;
  const double cells = 1.0 * out.columns_ * out.rows_;
  if (!(cells <= static_cast<double>(kMostCells))) return std::nullopt;
  const auto count = static_cast<std::size_t>(cells);
  out.is_inside_.assign(count, 0);
  out.is_visible_.assign(count, 0);
  out.can_be_seen_.assign(count, 0);
  out.seen_.assign(count, 0);
  out.part_.assign(count, 0);
  return out;
}

int SearchGrid::cell_of(double at, int count) {
  return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(count - 1)));
}

bool SearchGrid::enter(std::span<const geom::Point> outline, const Ground& ground,
                       std::span<const geom::Segment> opaque, BendingPlanner& planner,
                       std::optional<geom::Point> from, std::uint64_t most_effort) {
  enter_inside(outline);
  const Clearing things(ground, 0.0);
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      std::uint8_t& inside = is_inside_[index(column, row)];
      if (inside != 0 && !things.is_free(middle(column, row))) inside = 0;
      to_search_ += inside;
    }
  }
  if (to_search_ == 0) return true;
  sight_ = Sight(lanes_, opaque, 0.5 * swath_);
  if (!enter_parts(planner, from, most_effort)) return false;
  enter_edges(ground, planner.clearing());
  visible_ = static_cast<std::size_t>(std::ranges::count(is_visible_, 1));
  unseen_ = to_see_ = static_cast<std::size_t>(std::ranges::count(can_be_seen_, 1));
  return true;
}

/// By the crossings of each row with the outline: between an odd one and the next is inside.
void SearchGrid::enter_inside(std::span<const geom::Point> outline) {
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(rows_));
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const LanePlace a = lanes_.to_lanes(outline[i]);
    const LanePlace b = lanes_.to_lanes(outline[(i + 1) % outline.size()]);
    const auto row_above = [&](double across) {
      return cell_of(std::ceil(across / step_across_ - 0.5) + margin_rows_, rows_);
    };
    const int last = row_above(std::max(a.across, b.across));
    for (int row = row_above(std::min(a.across, b.across)); row < last; ++row) {
      const double share = (place(0, row).across - a.across) / (b.across - a.across);
      crossings[static_cast<std::size_t>(row)].push_back(a.along + share * (b.along - a.along));
    }
  }
  for (int row = 0; row < rows_; ++row) {
    auto& at = crossings[static_cast<std::size_t>(row)];
    std::ranges::sort(at);
    for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
      const auto column_above = [&](double along) {
        return cell_of(std::ceil(along / step_along_ - 0.5) + margin_columns_, columns_);
      };
      for (int column = column_above(at[i]); column < column_above(at[i + 1]); ++column)
        is_inside_[index(column, row)] = 1;
    }
  }
}

bool SearchGrid::enter_parts(BendingPlanner& planner, std::optional<geom::Point> from,
                             std::uint64_t most_effort) {
  const Clearing& clearing = planner.clearing();
  constexpr std::int32_t kFree = -1;
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      if (clearing.is_free(middle(column, row))) part_[index(column, row)] = kFree;
    }
  }
  std::vector<std::size_t> sizes{0, 0};  // by part: cells to be seen in it
  std::vector<geom::Point> places(2);    // by part: one in it
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      if (part_[index(column, row)] != kFree) continue;
      sizes.push_back(fill_part(column, row, static_cast<std::int32_t>(sizes.size()), clearing));
      places.push_back(middle(column, row));
    }
  }
  room_ = part_;
  return join_parts(sizes, places, planner, from, most_effort);
}

/// All cells that a robot comes to from there through cells, and how many of them are to be seen.
std::size_t SearchGrid::fill_part(int column, int row, std::int32_t part, const Clearing& clearing) {
  // Nothing that has grown so much is missed between two cells.
  const bool is_sure = clearing.clearance() > 0.75 * std::max(step_along_, step_across_);
  std::size_t out = 0;
  std::vector<std::pair<int, int>> open{{column, row}};
  part_[index(column, row)] = part;
  while (!open.empty()) {
    const auto [x, y] = open.back();
    open.pop_back();
    out += is_inside_[index(x, y)];
    constexpr std::array<std::pair<int, int>, 4> kBeside = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
    for (const auto& [dx, dy] : kBeside) {
      if (x + dx < 0 || y + dy < 0 || x + dx >= columns_ || y + dy >= rows_) continue;
      std::int32_t& other = part_[index(x + dx, y + dy)];
      if (other != -1 || (!is_sure && !clearing.is_free(geom::Segment{middle(x, y), middle(x + dx, y + dy)})))
        continue;
      other = part;
      open.emplace_back(x + dx, y + dy);
    }
  }
  return out;
}

/// Parts between which ways lead outside of the grid, through gaps narrower than a cell, or at a less
/// clearance, are one.
bool SearchGrid::join_parts(const std::vector<std::size_t>& sizes, const std::vector<geom::Point>& places,
                            BendingPlanner& planner, std::optional<geom::Point> from,
                            std::uint64_t most_effort) {
  std::vector<std::size_t> order;
  for (std::size_t part = 2; part < sizes.size(); ++part) order.push_back(part);
  std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t part) { return sizes[part]; });
  if (order.size() > kMostParts) order.resize(kMostParts);
  std::vector<std::int32_t> to(sizes.size(), 0);
  if (from) from = planner.nearest_free(*from);
  for (const std::size_t part : order) {
    if (!from) from = places[part];
    // From the part, which is small where no way leads: then that is found out soon.
    const std::uint64_t before = planner.effort();
    const auto way = planner.find(places[part], *from, most_effort);
    if (!way && !way.error().is_certain) return false;
    if (way) to[part] = kMain;
    most_effort -= std::min(most_effort, planner.effort() - before);
  }
  for (std::int32_t& part : part_) part = to[static_cast<std::size_t>(part)];
  return true;
}

bool SearchGrid::is_rim(int column, int row) const {
  for (int y = std::max(0, row - 1); y <= std::min(rows_ - 1, row + 1); ++y) {
    for (int x = std::max(0, column - 1); x <= std::min(columns_ - 1, column + 1); ++x) {
      if (!may_be_at(index(x, y))) return true;
    }
  }
  return false;
}

/// What is seen from the cells of robots, and from close to things, where those are too coarse.
void SearchGrid::enter_edges(const Ground& ground, const Clearing& clearing) {
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const std::size_t cell = index(column, row);
      if (!may_be_at(cell)) continue;
      can_be_seen_[cell] = is_inside_[cell];
      is_visible_[cell] = is_inside_[cell];
    }
  }
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      if (may_be_at(index(column, row)) && is_rim(column, row)) look_from(place(column, row));
    }
  }
  const double outside = 2.0 * Clearing::kTolerance;
  for (std::uint32_t round = 0; round < clearing.rounds().size(); ++round) {
    const auto [center, radius] = clearing.rounds()[round];
    for (const Arc& arc : clearing.free_arcs(round)) {
      const int pieces =
          static_cast<int>(std::min(1000.0, std::ceil((arc.end - arc.begin) * radius / step_along_)));
      for (int i = 0; i <= pieces; ++i) {
        const double angle = arc.begin + (arc.end - arc.begin) * i / std::max(pieces, 1);
        enter_edge(center + geom::Offset{std::cos(angle), std::sin(angle)} * (radius + outside), clearing);
      }
    }
  }
  for (const geom::Segment& wall : ground.walls) {
    const geom::Offset aside = unit(wall.b - wall.a) * (clearing.clearance() + outside);
    const int pieces = static_cast<int>(std::min(1000.0, std::ceil(distance(wall.a, wall.b) / step_along_)));
    for (int i = 0; i <= pieces; ++i) {
      const geom::Point at = wall.a + (wall.b - wall.a) * (1.0 * i / std::max(pieces, 1));
      enter_edge(at + geom::Offset{-aside.y, aside.x}, clearing);
      enter_edge(at + geom::Offset{aside.y, -aside.x}, clearing);
    }
  }
}

void SearchGrid::enter_edge(geom::Point at, const Clearing& clearing) {
  if (!may_be_at(at, clearing)) return;
  on_edges_.push_back(at);
  look_from(lanes_.to_lanes(at));
}

void SearchGrid::look_from(LanePlace at) {
  // Most of what is near is known by now, and walls are only asked for the rest.
  const auto look = [&](double reach, auto& known) {
    each_span(at, at, reach, [&](std::size_t first, std::size_t last) {
      const auto row = static_cast<int>(first / static_cast<std::size_t>(columns_));
      for (std::size_t one = first; one <= last; ++one) {
        if (is_inside_[one] == 0 || known[one] != 0) continue;
        if (!sight_.hides(place(static_cast<int>(one - index(0, row)), row), at)) known[one] = 1;
      }
    });
  };
  look(reach_, can_be_seen_);
  look(0.5 * swath_, is_visible_);
}

template <class IsFor>
std::optional<std::size_t> SearchGrid::cell_beside(geom::Point at, const Clearing& clearing,
                                                   IsFor&& is_for) const {
  const LanePlace p = lanes_.to_lanes(at);
  const double column = std::floor(p.along / step_along_) + margin_columns_;
  const double row = std::floor(p.across / step_across_) + margin_rows_;
  if (!(column >= 1 && row >= 1 && column < columns_ - 1 && row < rows_ - 1)) return std::nullopt;
  if (!clearing.is_free(at)) return std::nullopt;
  for (int y = static_cast<int>(row) - 1; y <= static_cast<int>(row) + 1; ++y) {
    for (int x = static_cast<int>(column) - 1; x <= static_cast<int>(column) + 1; ++x) {
      if (is_for(index(x, y)) && clearing.is_free(geom::Segment{middle(x, y), at})) return index(x, y);
    }
  }
  return std::nullopt;
}

bool SearchGrid::may_be_at(geom::Point at, const Clearing& clearing) const {
  return cell_beside(at, clearing, [&](std::size_t cell) { return may_be_at(cell); }).has_value();
}

std::int32_t SearchGrid::room_of(geom::Point at, const Clearing& clearing) const {
  const auto cell = cell_beside(at, clearing, [&](std::size_t one) { return room_[one] != 0; });
  return cell ? room_[*cell] : -1;
}

std::optional<geom::Point> SearchGrid::lookout(int column, int row) const {
  const geom::Point here = middle(column, row);
  std::optional<geom::Point> out;
  const auto offer = [&](geom::Point at) {
    if (distance(at, here) > reach_ || (out && distance(at, here) >= distance(*out, here))) return;
    if (!sight_.hides(place(column, row), lanes_.to_lanes(at))) out = at;
  };
  const int far_along = margin_columns_ - 1;
  const int far_across = margin_rows_ - 1;
  for (int y = std::max(0, row - far_across); y <= std::min(rows_ - 1, row + far_across); ++y) {
    for (int x = std::max(0, column - far_along); x <= std::min(columns_ - 1, column + far_along); ++x) {
      if (may_be_at(index(x, y))) offer(middle(x, y));
    }
  }
  for (const geom::Point at : on_edges_) offer(at);
  return out;
}

template <class Visit>
void SearchGrid::each_span(LanePlace a, LanePlace b, double reach, Visit&& visit) const {
  const geom::Offset along = unit(geom::Offset{b.along - a.along, b.across - a.across});
  const geom::Offset aside = geom::Offset{-along.y, along.x} * reach;
  const std::array<LanePlace, 4> corners = {{{a.along + aside.x, a.across + aside.y},
                                             {b.along + aside.x, b.across + aside.y},
                                             {b.along - aside.x, b.across - aside.y},
                                             {a.along - aside.x, a.across - aside.y}}};
  const double low = (std::min(a.across, b.across) - reach) / step_across_ + margin_rows_;
  const double high = (std::max(a.across, b.across) + reach) / step_across_ + margin_rows_;
  const int last_row = cell_of(high, rows_);
  for (int row = cell_of(low, rows_); row <= last_row; ++row) {
    const double across = place(0, row).across;
    double from = std::numeric_limits<double>::infinity();
    double to = -from;
    for (const LanePlace end : {a, b}) {
      const double off = across - end.across;
      if (std::abs(off) > reach) continue;
      const double half = std::sqrt(reach * reach - off * off);
      from = std::min(from, end.along - half);
      to = std::max(to, end.along + half);
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const LanePlace& p = corners[i];
      const LanePlace& q = corners[(i + 1) % corners.size()];
      if ((p.across <= across) == (q.across <= across)) continue;
      const double at = p.along + (q.along - p.along) * ((across - p.across) / (q.across - p.across));
      from = std::min(from, at);
      to = std::max(to, at);
    }
    const double first = std::max(std::ceil(from / step_along_ - 0.5) + margin_columns_, 0.0);
    const double last = std::min(std::floor(to / step_along_ - 0.5) + margin_columns_, columns_ - 1.0);
    if (first <= last) visit(index(static_cast<int>(first), row), index(static_cast<int>(last), row));
  }
}

template <class Visit>
void SearchGrid::each_seen(LanePlace a, LanePlace b, double reach, Visit&& visit) const {
  each_span(a, b, reach, [&](std::size_t first, std::size_t last) {
    std::size_t begin = first;  // of a run of cells that are seen
    const auto row = static_cast<int>(first / static_cast<std::size_t>(columns_));
    for (std::size_t cell = first; cell <= last && !sight_.is_open(); ++cell) {
      const auto column = static_cast<int>(cell - index(0, row));
      if (sight_.sees(place(column, row), a, b, reach)) continue;
      if (begin < cell) visit(begin, cell - 1);
      begin = cell + 1;
    }
    if (begin <= last) visit(begin, last);
  });
}

void SearchGrid::count(std::size_t first, std::size_t last, int by) {
  int less = 0;
  for (std::size_t cell = first; cell <= last; ++cell) {
    const std::uint16_t before = seen_[cell];
    const auto after = static_cast<std::uint16_t>(before + by);
    seen_[cell] = after;
    less += can_be_seen_[cell] * (static_cast<int>(before == 0) - static_cast<int>(after == 0));
  }
  unseen_ -= static_cast<std::size_t>(less);
}

void SearchGrid::see(geom::Segment piece, int by) {
  each_seen(lanes_.to_lanes(piece.a), lanes_.to_lanes(piece.b), reach_,
            [&](std::size_t first, std::size_t last) { count(first, last, by); });
}

void SearchGrid::see(std::span<const Run> runs, int by) {
  for (const auto& [first, last] : runs) count(first, last, by);
}

void SearchGrid::add_seen(geom::Segment piece, std::vector<Run>& out) const {
  each_seen(lanes_.to_lanes(piece.a), lanes_.to_lanes(piece.b), reach_,
            [&](std::size_t first, std::size_t last) { out.emplace_back(first, last); });
}

}  // namespace mlab::ways
