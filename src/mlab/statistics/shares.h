#pragma once

#include <cstdint>

namespace mlab::statistics {

/// Where a share lies.
struct Interval {
  double low = 0.0;
  double high = 1.0;

  double width() const { return high - low; }
  bool contains(double share) const { return low <= share && share <= high; }
  friend bool operator==(const Interval&, const Interval&) = default;
};

/// So many of so many.
struct Count {
  std::uint64_t successes = 0;
  std::uint64_t trials = 0;  ///< no fewer than successes

  double share() const {
    return trials == 0 ? 0.0 : static_cast<double>(successes) / static_cast<double>(trials);
  }
  friend bool operator==(const Count&, const Count&) = default;
};

/// The exact interval of a share: the true one lies in it with at least this probability, whatever it is, for
/// a number of trials that was settled before (C. J. Clopper, E. S. Pearson, "The use of confidence or
/// fiducial limits illustrated in the case of the binomial", Biometrika 26, 1934). Who looks at it after each
/// trial and stops when he likes it is wrong far more often: for that there is `confidence_sequence`.
/// @param confidence  above 0 and below 1: 0.95
Interval clopper_pearson(Count count, double confidence);

/// How much a share is spoken against by what was counted: a bet against it that began with 1 and, were it
/// the true share, would on average stay there. The bets are those of a beta(1/2, 1/2) mixture.
/// @return its logarithm; infinite where the share is impossible
double log_evidence_against(double share, Count count);

/// The interval for who looks after every trial: the true share lies in all of the intervals of a whole
/// sequence of trials, however long, with at least this probability; so one may stop whenever one likes. They
/// are the shares that `log_evidence_against` has not refuted (J. Ville's inequality, 1939; H. Robbins,
/// "Statistical methods related to the law of the iterated logarithm", Annals of Mathematical Statistics 41,
/// 1970; as a confidence sequence: S. R. Howard, A. Ramdas, J. McAuliffe, J. Sekhon, "Time-uniform,
/// nonparametric, nonasymptotic confidence sequences", Annals of Statistics 49, 2021).
/// @param confidence  above 0 and below 1
Interval confidence_sequence(Count count, double confidence);

}  // namespace mlab::statistics
