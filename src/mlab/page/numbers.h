#pragma once

#include <string>

#include "mlab/statistics/samples.h"
#include "mlab/statistics/shares.h"

// Numbers as people read them, on terminals and pages.
namespace mlab::page {

/// Four digits are more than most samples tell: `1.437`, `0`, `61230`.
std::string brief(double value);
/// The same with its sign: `+1.4`, `0`.
std::string signed_number(double value);
/// `98.2 %`; all and none are `100 %` and `0 %`, and nothing else is.
std::string percent(double share);
/// `98.2 to 100 %`
std::string percents(const statistics::Interval& interval);
/// The median and where nine of ten are: `327.7 (320.1 to 340)`; empty for an empty sample.
std::string median_and_range(const statistics::Sample& sample);
/// `p = 0.031`, `p < 0.0001`
std::string p_words(double p);

}  // namespace mlab::page
