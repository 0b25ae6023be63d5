#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace mlab::statistics {

/// Numbers of one kind, without those that are none, summed up.
struct Sample {
  std::vector<double> sorted;  ///< ascending
  double mean = 0.0;
  double deviation = 0.0;  ///< of the sample, by n - 1

  std::size_t size() const { return sorted.size(); }
  bool empty() const { return sorted.empty(); }
};
Sample sample_of(std::span<const double> values);

/// The value below which this share of the sample lies, between two values in proportion (type 7 of
/// R. J. Hyndman, Y. Fan, "Sample quantiles in statistical packages", American Statistician 50, 1996).
/// @param sample  not empty
/// @param share   from 0 to 1
double quantile(const Sample& sample, double share);

/// How wide the bins of a histogram are to be: a round width (1, 2 or 5 times a power of ten) near twice the
/// middle half over the third root of the number (D. Freedman, P. Diaconis, "On the histogram as a density
/// estimator", 1981), of which enough fit between the least value and the greatest for so many values (H. A.
/// Sturges, "The choice of a class interval", 1926). Where the middle half is of one value, the deviation
/// says how wide. Few values give few bins, and equal ones the narrowest.
/// @param span  what is covered with bins, above 0
/// @param most  there are at most so many on it
double bin_width(const Sample& sample, double span, std::size_t most);

/// How many values are in each bin. The last bin has its upper edge as well; what lies outside is in the bin
/// next to it.
/// @param low, high  where the first bin begins and the last one ends, or a little later; high above low
/// @param width      above 0
std::vector<std::uint64_t> histogram(const Sample& sample, double low, double high, double width);

/// The round width (1, 2 or 5 times a power of ten) with which at most so many steps cover a length.
double round_step(double length, std::size_t most_steps);

}  // namespace mlab::statistics
