#include "mlab/statistics/distributions.h"

#include <algorithm>
#include <numbers>

#include <boost/math/policies/policy.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <boost/math/special_functions/erf.hpp>
#include <boost/math/special_functions/gamma.hpp>

namespace mlab::statistics {
namespace {

namespace policies = boost::math::policies;
// What has no answer is no number, and nothing is thrown; no wider type than `double` is used on any machine,
// so that all give the same digits.
using Quiet =
    policies::policy<policies::domain_error<policies::ignore_error>,
                     policies::pole_error<policies::ignore_error>,
                     policies::overflow_error<policies::ignore_error>,
                     policies::evaluation_error<policies::ignore_error>, policies::promote_double<false>>;

}  // namespace

double beta_quantile(double a, double b, double share) {
  return boost::math::ibeta_inv(a, b, std::clamp(share, 0.0, 1.0), Quiet());
}

double binomial_at_most(std::uint64_t successes, std::uint64_t trials, double p) {
  if (successes >= trials) return 1.0;
  const auto k = static_cast<double>(successes);
  return boost::math::ibetac(k + 1.0, static_cast<double>(trials) - k, std::clamp(p, 0.0, 1.0), Quiet());
}

double normal_below(double z) {
  return 0.5 * boost::math::erfc(-z / std::numbers::sqrt2, Quiet());
}

double log_gamma(double x) {
  return boost::math::lgamma(x, Quiet());
}

}  // namespace mlab::statistics
