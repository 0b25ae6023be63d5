#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace mlab::sim {

/// A rectangle with its sides along the axes [m, world].
struct Box {
  double x0, y0, x1, y1;

  static Box around(double x, double y, double reach) { return {x - reach, y - reach, x + reach, y + reach}; }
  /// The smallest that holds both points, widened by reach on each side.
  static Box spanned(double xa, double ya, double xb, double yb, double reach) {
    return {std::min(xa, xb) - reach, std::min(ya, yb) - reach, std::max(xa, xb) + reach,
            std::max(ya, yb) + reach};
  }
};

template <class Point>
bool is_inside(const Box& box, Point p) {
  return p.x >= box.x0 && p.x <= box.x1 && p.y >= box.y0 && p.y <= box.y1;
}

/// The cells of an endless square grid, laid onto a table of fixed size as if on a torus: cell (x, y) is
/// stored at (x mod columns, y mod rows). So memory depends on how much is stored, never on how far apart it
/// lies, and cells that share a place only cost a look at something that is far away.
class TorusCells {
 public:
  /// @param places  how many places the table has at least, rounded up to a power of two
  /// @param cell    side of a cell [m], > 0
  void resize(std::size_t places, double cell) {
    int bits = 2;
    while ((std::size_t{1} << bits) < places && bits < 30) ++bits;
    column_bits_ = (bits + 1) / 2;
    columns_ = std::int64_t{1} << column_bits_;
    rows_ = std::int64_t{1} << (bits / 2);
    cell_ = cell;
    per_metre_ = 1.0 / cell;
  }
  std::size_t size() const { return static_cast<std::size_t>(columns_ * rows_); }
  double cell() const { return cell_; }
  double columns() const { return static_cast<double>(columns_); }
  double rows() const { return static_cast<double>(rows_); }
  std::int64_t index(double coordinate) const {
    // Without the call that std::floor is on processors of the oldest kind.
    const double cells = coordinate * per_metre_;
    const auto towards_zero = static_cast<std::int64_t>(cells);
    return towards_zero - (cells < static_cast<double>(towards_zero) ? 1 : 0);
  }
  std::uint32_t place(double x, double y) const { return place(index(x), index(y)); }

  /// Calls row(first, last) for runs of places next to each other that hold all cells of the box, none twice.
  template <class Row>
  void for_each_run(const Box& box, Row&& row) const {
    const std::int64_t y0 = index(box.y0);
    const std::int64_t y1 = std::min(index(box.y1), y0 + rows_ - 1);
    const std::int64_t x0 = index(box.x0);
    const std::int64_t x1 = index(box.x1);
    for (std::int64_t y = y0; y <= y1; ++y) for_each_run_of_row(y, x0, x1, row);
  }
  /// The same for the cells x0 .. x1 of one row of the endless grid.
  template <class Row>
  void for_each_run_of_row(std::int64_t y, std::int64_t x0, std::int64_t x1, Row&& row) const {
    const auto base = static_cast<std::uint32_t>((y & (rows_ - 1)) << column_bits_);
    const auto last_column = static_cast<std::uint32_t>(columns_ - 1);
    if (x1 - x0 >= columns_ - 1) {
      row(base, base + last_column);
      return;
    }
    const auto a = static_cast<std::uint32_t>(x0 & (columns_ - 1));
    const auto b = static_cast<std::uint32_t>(x1 & (columns_ - 1));
    if (a <= b) {
      row(base + a, base + b);
    } else {
      row(base + a, base + last_column);
      row(base, base + b);
    }
  }

 private:
  std::uint32_t place(std::int64_t x, std::int64_t y) const {
    return static_cast<std::uint32_t>(((y & (rows_ - 1)) << column_bits_) | (x & (columns_ - 1)));
  }

  int column_bits_ = 1;
  std::int64_t columns_ = 2;
  std::int64_t rows_ = 2;
  double cell_ = 1.0;
  double per_metre_ = 1.0;
};

/// The cells of an endless square grid, laid onto a table of fixed size along a lattice: one step along a row
/// is one place on, one row up is `stride` places on. Unlike on a torus, what stands in line, in whatever
/// direction, comes to places of its own all over the table.
class LatticeCells {
 public:
  /// As TorusCells.
  void resize(std::size_t places, double cell);
  std::size_t size() const { return static_cast<std::size_t>(mask_) + 1; }
  double cell() const { return cell_; }
  std::uint32_t place(double x, double y) const { return place(index(x), index(y)); }

  /// Calls row(first, last) for runs of places next to each other that hold all cells of the box, none twice.
  /// @return  false: so many cells would share places that everything has to be looked at; nothing was called
  template <class Row>
  bool for_each_run(const Box& box, Row&& row) const {
    const std::int64_t x0 = index(box.x0);
    const std::int64_t y0 = index(box.y0);
    const auto width = static_cast<std::uint64_t>(index(box.x1) - x0) + 1;
    const auto height = static_cast<std::uint64_t>(index(box.y1) - y0) + 1;
    if (height > gaps_.size() || width > gaps_[height - 1]) return false;
    std::uint32_t first = place(x0, y0);
    for (std::uint64_t y = 0; y < height; ++y, first = (first + stride_) & mask_) {
      const std::uint64_t last = first + width - 1;
      if (last <= mask_) {
        row(first, static_cast<std::uint32_t>(last));
      } else {
        row(first, mask_);
        row(std::uint32_t{0}, static_cast<std::uint32_t>(last & mask_));
      }
    }
    return true;
  }

 private:
  std::int64_t index(double coordinate) const {
    // Without the call that std::floor is on processors of the oldest kind.
    const double cells = coordinate * per_metre_;
    const auto towards_zero = static_cast<std::int64_t>(cells);
    return towards_zero - (cells < static_cast<double>(towards_zero) ? 1 : 0);
  }
  std::uint32_t place(std::int64_t x, std::int64_t y) const {
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(x) +
                                      static_cast<std::uint64_t>(y) * stride_) &
           mask_;
  }

  std::uint32_t mask_ = 0;
  std::uint32_t stride_ = 1;
  /// By one less than a number of rows: how long their runs may be at most without meeting each other.
  std::vector<std::uint32_t> gaps_;
  double cell_ = 1.0;
  double per_metre_ = 1.0;
};

/// Discs sorted into cells by their centres, to find those near a place. The size of the cells follows how
/// far and how densely they stand; it only makes a difference to speed. A handful has no cells: looking at
/// all of them is faster.
class PointGrid {
 public:
  struct Item {
    double x, y;   ///< centre [m]
    float radius;  ///< rounded up [m]
    std::uint32_t id;
  };

  /// Replaces everything. Takes the items as they are: no id may come twice.
  /// @param smallest_cell  cells get no smaller than this [m]. Where questions reach far: `cell_for` them,
  /// since
  ///                       what stands in pairs and fours would else be parted by cells so small that a
  ///                       question is more of them than the table has
  void build(std::span<const Item> items, double smallest_cell);
  /// Calls visit(item) for all items whose centre is in the box, and some others; none twice.
  template <class Visit>
  void visit(const Box& box, Visit&& visit) const {
    if (sorted_.empty()) return;
    const auto visit_places = [&](std::uint32_t first, std::uint32_t last) {
      const Item* const end = sorted_.data() + starts_[last + 1];
      for (const Item* item = sorted_.data() + starts_[first]; item != end; ++item) visit(*item);
    };
    if (has_cells_ && cells_.for_each_run(box, visit_places)) return;
    for (const Item& item : sorted_) visit(item);
  }
  /// The cell that answers questions about everything within this reach best, by trials with robots anywhere,
  /// in lines, columns and blocks [m].
  static double cell_for(double reach) { return std::min(8.0, 0.25 * reach); }
  /// The largest of all items [m].
  double max_radius() const { return max_radius_; }
  double cell() const { return cells_.cell(); }
  bool empty() const { return sorted_.empty(); }
  /// How often it was built.
  std::uint64_t builds() const { return builds_; }

 private:
  /// Sorts into cells of the present size. @return how many places of the table are in use
  std::size_t sort(std::span<const Item> items);

  std::uint64_t builds_ = 0;
  bool has_cells_ = false;
  LatticeCells cells_;
  int halvings_ = 0;  ///< of the cells that would just cover everything, because too many items shared one
  std::vector<std::uint32_t> starts_;  ///< by place: where its items begin in sorted_; two more for the end
  std::vector<std::uint32_t> places_;  ///< by item, while sorting
  std::vector<Item> sorted_;
  double max_radius_ = 0.0;
};

/// How far from a body all others stand, as its eyes saw.
struct Apart {
  std::uint64_t build = 0;  ///< of the grid that was asked, as its `builds`; 0: nobody has looked
  double away = 0.0;        ///< all others, at least [m]
};

/// How wide coordinates spread, a few that lie far outside left out: twice the distance between their
/// quartiles, which for evenly spread ones is all of it [m]. Puts them into another order.
double spread(std::span<double> coordinates);

/// The float that is at least `value`.
inline float rounded_up(double value) {
  const auto nearest = static_cast<float>(value);
  return static_cast<double>(nearest) < value ? std::nextafter(nearest, HUGE_VALF) : nearest;
}

}  // namespace mlab::sim
