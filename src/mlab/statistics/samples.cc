#include "mlab/statistics/samples.h"

#include <algorithm>
#include <cmath>

namespace mlab::statistics {

Sample sample_of(std::span<const double> values) {
  Sample out;
  std::ranges::copy_if(values, std::back_inserter(out.sorted), [](double v) { return std::isfinite(v); });
  std::ranges::sort(out.sorted);
  if (out.empty()) return out;
  const auto n = static_cast<double>(out.size());
  double sum = 0.0;
  for (const double value : out.sorted) sum += value;
  out.mean = sum / n;
  double squares = 0.0;
  for (const double value : out.sorted) squares += (value - out.mean) * (value - out.mean);
  if (out.size() > 1) out.deviation = std::sqrt(squares / (n - 1.0));
  return out;
}

double quantile(const Sample& sample, double share) {
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(sample.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sample.size() - 1);
  return std::lerp(sample.sorted[below], sample.sorted[above], place - static_cast<double>(below));
}

double round_step(double length, std::size_t most_steps) {
  if (!(length > 0.0) || most_steps == 0) return 1.0;
  const double least = length / static_cast<double>(most_steps);
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1.0 - 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

Histogram histogram(std::span<const double> values, double low, double high, std::size_t most_bins) {
  Histogram out;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  // The first and the last bin may begin before and end behind what is spanned.
  out.width = round_step(high - low, std::max<std::size_t>(most_bins, 3) - 2);
  out.low = std::floor(low / out.width) * out.width;
  const auto bin = [&](double value) {
    return static_cast<std::size_t>(std::max(0.0, std::floor((value - out.low) / out.width)));
  };
  out.counts.resize(bin(high) + 1);
  for (const double value : values) {
    if (std::isfinite(value)) ++out.counts[std::min(bin(value), out.counts.size() - 1)];
  }
  return out;
}

}  // namespace mlab::statistics
