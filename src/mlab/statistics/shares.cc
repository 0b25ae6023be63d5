#include "mlab/statistics/shares.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "mlab/statistics/distributions.h"

namespace mlab::statistics {
namespace {

constexpr int kHalvings = 60;  // a double has no more digits

// n log(p), where nothing of an impossible thing is possible.
double times_log(double n, double p) {
  return n == 0.0 ? 0.0 : n * std::log(p);
}

// The end of the interval between a share that is refuted and one that is not.
double border(double refuted, double kept, Count count, double threshold) {
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (refuted + kept);
    (log_evidence_against(middle, count) >= threshold ? refuted : kept) = middle;
  }
  return refuted;  // the wider of the two
}

}  // namespace

Interval clopper_pearson(Count count, double confidence) {
  const auto s = static_cast<double>(count.successes);
  const auto n = static_cast<double>(count.trials);
  const double tail = 0.5 * (1.0 - confidence);
  Interval out;
  if (count.successes > 0) out.low = beta_quantile(s, n - s + 1.0, tail);
  if (count.successes < count.trials) out.high = beta_quantile(s + 1.0, n - s, 1.0 - tail);
  return out;
}

double log_evidence_against(double share, Count count) {
  const auto s = static_cast<double>(count.successes);
  const double f = static_cast<double>(count.trials) - s;
  const double likelihood = times_log(s, share) + times_log(f, 1.0 - share);
  if (!(likelihood > -std::numeric_limits<double>::infinity()))
    return std::numeric_limits<double>::infinity();
  // B(s + 1/2, f + 1/2) / B(1/2, 1/2)
  const double mixture =
      log_gamma(s + 0.5) + log_gamma(f + 0.5) - log_gamma(s + f + 1.0) - std::log(std::numbers::pi);
  return mixture - likelihood;
}

Interval confidence_sequence(Count count, double confidence) {
  const double threshold = -std::log1p(-confidence);
  const double seen = count.share();  // the share that is spoken against least
  Interval out;
  if (count.trials == 0) return out;
  if (log_evidence_against(0.0, count) >= threshold) out.low = border(0.0, seen, count, threshold);
  if (log_evidence_against(1.0, count) >= threshold) out.high = border(1.0, seen, count, threshold);
  return out;
}

}  // namespace mlab::statistics
