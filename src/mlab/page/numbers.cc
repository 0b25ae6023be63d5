#include "mlab/page/numbers.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

namespace mlab::page {
namespace {

// The number alone. What is not all is never rounded to it.
std::string percent_number(double share) {
  if (share <= 0.0 || share >= 1.0) return share <= 0.0 ? "0" : "100";
  const double near = std::min(share, 1.0 - share);
  int digits = 1;
  while (digits < 8 && near < 0.5 * std::pow(10.0, -2 - digits)) ++digits;
  return fmt::format("{:.{}f}", 100.0 * share, digits);
}

}  // namespace

std::string brief(double value) {
  if (std::abs(value) >= 1000.0 && std::abs(value) < 1e9) return fmt::format("{:.0f}", value);
  return fmt::format("{:.4g}", value);
}

std::string signed_number(double value) {
  return (value > 0.0 ? "+" : "") + brief(value);
}

std::string percent(double share) {
  return percent_number(share) + " %";
}

std::string percents(const statistics::Interval& interval) {
  return fmt::format("{} to {} %", percent_number(interval.low), percent_number(interval.high));
}

std::string median_and_range(const statistics::Sample& sample) {
  if (sample.empty()) return {};
  const std::string median = brief(statistics::quantile(sample, 0.5));
  const std::string low = brief(statistics::quantile(sample, 0.05));
  const std::string high = brief(statistics::quantile(sample, 0.95));
  return low == high && low == median ? median : fmt::format("{} ({} to {})", median, low, high);
}

std::string p_words(double p) {
  return p < 0.0001 ? "p < 0.0001" : fmt::format("p = {:.2g}", p);
}

}  // namespace mlab::page
