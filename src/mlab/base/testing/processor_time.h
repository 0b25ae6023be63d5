#pragma once

#include <algorithm>
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

/// How many of a test's examples are tried: a slow build, which looks for other mistakes, tries a quarter.
constexpr int examples(int all) {
  return kIsSlowBuild ? (all + 3) / 4 : all;
}

/// How many steps it is to the next of examples that are many and alike: a slow build tries every fourth.
inline constexpr std::size_t kNextExample = kIsSlowBuild ? 4 : 1;

/// The length of a text that tests of speed call a megabyte. A slow build, which looks for other mistakes,
/// reads a thirty-second of it.
inline constexpr std::size_t kMegabyte = std::size_t{1} << (kIsSlowBuild ? 15U : 20U);

/// The time that the processor spends on `work`, in all threads of this process: other programs on the
/// machine do not count [s].
template <class Work>
double processor_seconds(Work&& work) {
  const std::clock_t begin = std::clock();
  std::forward<Work>(work)();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// What other work is compared with: so a test can tell that something ends soon whatever it is given, on any
/// machine and in any build. How fast it is, a benchmark tells.
class Yardstick {
 public:
  /// @param work  what is known to be quick enough; done three times
  template <class Work>
  explicit Yardstick(const Work& work) : seconds_(least_of(3, 0.0, work)) {}

  /// How many times as long other work takes: the least of some tries, since what else the machine does takes
  /// from its caches.
  /// @param enough  at this it is not tried again
  template <class Work>
  double times(const Work& work, double enough) const {
    return least_of(5, enough * seconds_, work) / seconds_;
  }

 private:
  template <class Work>
  static double least_of(int tries, double enough, const Work& work) {
    double least = processor_seconds(work);
    for (int i = 1; i < tries && least > enough; ++i) least = std::min(least, processor_seconds(work));
    return std::max(least, 1.0 / CLOCKS_PER_SEC);
  }

  double seconds_;
};

/// More than `growth` of what grows with the size, with room for caches that it outgrows; less than its
/// square.
inline constexpr double kGrowthOfLine = 32.0;

/// How many times as long as an ordinary text any other of the same size may take to be answered. What grows
/// with the square of a size takes thousands of times as long there.
inline constexpr double kPatience = 30.0;

/// How many times as long `work(8 * size)` takes as `work(size)`: some 8 where time grows with the size, some
/// 64 with its square.
template <class Work>
double growth(const Work& work, std::size_t size) {
  return Yardstick([&] { work(size); }).times([&] { work(8 * size); }, kGrowthOfLine);
}

}  // namespace mlab::base
