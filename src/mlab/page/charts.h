#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/statistics/samples.h"
#include "mlab/statistics/shares.h"

// Pieces of a page: rows of a label, a drawing that takes the width there is, and a figure. Letters are the
// page's own, so that they stay readable however narrow it is.
namespace mlab::page {

/// Where an axis begins and ends, and what stands at it.
struct Axis {
  double low = 0.0;
  double high = 1.0;
  std::vector<std::pair<double, std::string>> marks;

  /// In thousandths of the axis.
  double at(double value) const;
};
/// From nothing to all.
Axis share_axis();
/// That holds so much, with round marks.
Axis number_axis(double low, double high);
std::string axis_row(const Axis& axis);

/// A share as a point, and its interval as a line.
struct ShareRow {
  std::string label;
  statistics::Count count;
  std::optional<statistics::Interval> interval;  ///< nothing: it has none that would be true
  bool is_second = false;                        ///< in the second colour
};
std::string share_row(const ShareRow& row, const Axis& axis);

/// A sample as bars, and its median as a line.
struct SampleRow {
  std::string label;
  const statistics::Sample* sample = nullptr;
  bool is_second = false;
};
/// @param width  of the bars, in the axis' unit
std::string sample_row(const SampleRow& row, const Axis& axis, double width);

/// Places or values in a row; one that is no number interrupts it.
using Points = std::vector<std::pair<double, double>>;
struct Line {
  Points points;
  bool is_second = false;  ///< in the second colour
};

/// Values over an axis as lines, from 0 at the bottom to `top`.
struct LineRow {
  std::string label;
  std::vector<Line> lines;
  double top = 1.0;
  std::string figure;
  std::optional<double> mark;  ///< a place of the axis at which a line stands
};
std::string line_row(const LineRow& row, const Axis& axis);

/// Ways seen from above, in one scale for both axes, y upwards.
/// @param said  what there is to see, for who doesn't
std::string ways(const std::vector<Line>& lines, std::string_view said);

/// The rows of a table, the first one its head. On a narrow screen, and where there are many columns also
/// on one that is not wide, each row stands by itself, with a word for each of its cells. What is longer than
/// the page even so is scrolled by itself.
std::string table(std::string_view caption, const std::vector<std::vector<std::string>>& rows,
                  std::size_t left_columns);

}  // namespace mlab::page
