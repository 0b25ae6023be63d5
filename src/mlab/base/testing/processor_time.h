#pragma once

#include <cstddef>
#include <ctime>
#include <utility>

#ifdef __has_feature
#define MLAB_HAS_FEATURE(name) __has_feature(name)  // how clang tells its sanitizers
#else
#define MLAB_HAS_FEATURE(name) 0
#endif

namespace mlab::base {

/// Whether this build is many times slower than the product: by sanitizers, or because nothing was optimised.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || MLAB_HAS_FEATURE(address_sanitizer) || \
    MLAB_HAS_FEATURE(thread_sanitizer) || !defined(__OPTIMIZE__)
inline constexpr bool kIsSlowBuild = true;
#else
inline constexpr bool kIsSlowBuild = false;
#endif
#undef MLAB_HAS_FEATURE

/// How much longer work may take in this build than in the product.
inline constexpr double kSlowness = kIsSlowBuild ? 20.0 : 1.0;

/// The length of a text that tests of speed call a megabyte. A slow build, which looks for other mistakes,
/// reads a sixteenth of it.
inline constexpr std::size_t kMegabyte = std::size_t{1} << (kIsSlowBuild ? 16U : 20U);

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
