#pragma once

#include <cstdint>

// Distributions that the tests and intervals of this folder are made of.
namespace mlab::statistics {

/// The x below which a beta distribution has so much of its mass.
/// @param a, b   more than 0
/// @param share  from 0 to 1
double beta_quantile(double a, double b, double share);

/// The probability of at most `successes` among so many trials.
/// @param p  of a success, from 0 to 1
double binomial_at_most(std::uint64_t successes, std::uint64_t trials, double p);

/// The probability that a standard normal variable is at most z.
double normal_below(double z);

/// The logarithm of the gamma function, of x above 0; the same on every machine, and on any thread.
double log_gamma(double x);

}  // namespace mlab::statistics
