#include "mlab/robot/wire/arithmetic.h"

#include <bit>
#include <cmath>

#include "mlab/base/random.h"

namespace mlab::robot_wire {
namespace {

constexpr int kSamples =
    4096;  // of each of eleven functions, that differ once in some thousand values where they differ

std::uint64_t sample() {
  base::Random random(1);
  std::uint64_t key = 0;
  for (int i = 0; i < kSamples; ++i) {
    const double angle = 2.0 * random.angle();
    const double share = random.uniform(-1.0, 1.0);
    const double length = 100.0 * (1.0 - random.uniform());
    for (const double value : {std::sin(angle), std::cos(angle), std::tan(angle), std::asin(share),
                               std::acos(share), std::atan(angle), std::atan2(angle, share), std::log(length),
                               std::log10(length), std::exp(angle), std::pow(length, share)})
      key = base::combine_bits(key, std::bit_cast<std::uint64_t>(value));
  }
  return key;
}

}  // namespace

std::uint64_t arithmetic() {
  static const std::uint64_t kSampled = sample();
  return kSampled;
}

}  // namespace mlab::robot_wire
