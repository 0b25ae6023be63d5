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

struct Histogram {
  double low = 0.0;    ///< where the first bin begins
  double width = 1.0;  ///< of each bin, above 0
  std::vector<std::uint64_t> counts;

  double high() const { return low + width * static_cast<double>(counts.size()); }
};
/// Bins of a round width (1, 2 or 5 times a power of ten) that hold all of the values, at most so many.
/// @param low, high  what the bins are to span at least; high is no less than low
Histogram histogram(std::span<const double> values, double low, double high, std::size_t most_bins);

/// The round width (1, 2 or 5 times a power of ten) with which at most so many steps cover a length.
double round_step(double length, std::size_t most_steps);

}  // namespace mlab::statistics
