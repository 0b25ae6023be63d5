#pragma once

#include <ctime>
#include <utility>

namespace mlab::base {

/// How much longer work may take in this build than in the product: what sanitizers and missing optimisation
/// cost.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__OPTIMIZE__)
inline constexpr double kSlowness = 20.0;
#else
inline constexpr double kSlowness = 1.0;
#endif

/// The time that the processor spends on `work`, in all threads of this process: other programs on the
/// machine do not count [s]. For tests that something ends soon whatever it is given; how fast it is, a
/// benchmark tells.
template <class Work>
double processor_seconds(Work&& work) {
  const std::clock_t begin = std::clock();
  std::forward<Work>(work)();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

}  // namespace mlab::base
