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

namespace {

// Of 1, 2 and 5 times a power of ten.
double nearest_round(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  double out = power;
  for (const double factor : {2.0, 5.0, 10.0}) {
    if (factor * power * out < length * length) out = factor * power;
  }
  return out;
}

}  // namespace

double bin_width(const Sample& sample, double span, std::size_t most) {
  const double narrowest = span / static_cast<double>(std::max<std::size_t>(most, 1));
  double width = narrowest;
  if (sample.size() > 1) {
    const auto n = static_cast<double>(sample.size());
    const double of_normal = 3.49 * sample.deviation;  // the same of values that are normally distributed
    const double half = 2.0 * (quantile(sample, 0.75) - quantile(sample, 0.25));
    const double range = sample.sorted.back() - sample.sorted.front();
    width = std::min((half > 0.0 ? half : of_normal) / std::pow(n, 1.0 / 3.0), range / (std::log2(n) + 1.0));
  }
  return std::max(nearest_round(std::clamp(width, narrowest, span)), round_step(span, most));
}

std::vector<std::uint64_t> histogram(const Sample& sample, double low, double high, double width) {
  const double bins = std::max(1.0, std::ceil((high - low) / width * (1.0 - 1e-9)));
  std::vector<std::uint64_t> out(static_cast<std::size_t>(bins));
  for (const double value : sample.sorted)
    ++out[static_cast<std::size_t>(std::clamp(std::floor((value - low) / width), 0.0, bins - 1.0))];
  return out;
}

}  // namespace mlab::statistics
