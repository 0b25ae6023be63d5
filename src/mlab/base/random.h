#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "mlab/base/hash.h"

namespace mlab::base {

/// A random stream named by a key. Two streams with the same key give the same numbers, whoever asks and
/// whenever: so a result never depends on the order in which robots or threads come to draw.
/// Counter based (splitmix64), 16 bytes, trivially copyable, no heap.
class Random {
 public:
  Random() = default;
  explicit constexpr Random(std::uint64_t key) : key_(mix_bits(key)) {}
  /// The stream of one node of one robot in one cycle.
  static constexpr Random of(std::uint64_t seed, std::uint64_t robot, std::uint64_t path_hash,
                             std::uint64_t cycle) {
    return Random(combine_bits(combine_bits(seed, robot), combine_bits(path_hash, cycle)));
  }

  constexpr std::uint64_t bits() { return mix_bits(key_ + 0x9e3779b97f4a7c15ULL * ++count_); }
  /// In [0, 1), all 53 bits of the fraction random.
  constexpr double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }
  /// In [low, high).
  constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// In 0 .. n - 1; n > 0. The bias is below n / 2^64.
  constexpr std::uint64_t below(std::uint64_t n) {
    return static_cast<std::uint64_t>((static_cast<Wide>(bits()) * n) >> 64);
  }
  /// An angle in [-pi, pi) [rad].
  constexpr double angle() { return uniform(-std::numbers::pi, std::numbers::pi); }
  /// Mean 0, standard deviation 1 (Box and Muller, one of the pair).
  double normal() {
    const double u = 1.0 - uniform();
    return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::numbers::pi * uniform());
  }

 private:
  __extension__ using Wide = unsigned __int128;

  std::uint64_t key_ = 0;
  std::uint64_t count_ = 0;
};

}  // namespace mlab::base
