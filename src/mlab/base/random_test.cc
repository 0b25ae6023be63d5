#include "mlab/base/random.h"

#include <gtest/gtest.h>

namespace mlab::base {
namespace {

TEST(Random, GivesTheSameNumbersForTheSameKey) {
  Random a = Random::of(7, 3, hash_text("noise"), 100);
  Random b = Random::of(7, 3, hash_text("noise"), 100);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(a.bits(), b.bits());
}

TEST(Random, DiffersWhenAnyPartOfItsKeyDiffers) {
  const auto first = [](Random r) { return r.bits(); };
  const std::uint64_t reference = first(Random::of(7, 3, hash_text("noise"), 100));
  EXPECT_NE(reference, first(Random::of(8, 3, hash_text("noise"), 100)));
  EXPECT_NE(reference, first(Random::of(7, 4, hash_text("noise"), 100)));
  EXPECT_NE(reference, first(Random::of(7, 3, hash_text("noisf"), 100)));
  EXPECT_NE(reference, first(Random::of(7, 3, hash_text("noise"), 101)));
}

TEST(Random, UniformHasTheMeanAndVarianceOfTheUnitInterval) {
  Random r(42);
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kDraws = 100'000;
  for (int i = 0; i < kDraws; ++i) {
    const double u = r.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    squares += u * u;
  }
  const double mean = sum / kDraws;
  EXPECT_NEAR(mean, 0.5, 0.005);
  EXPECT_NEAR(squares / kDraws - mean * mean, 1.0 / 12.0, 0.002);
}

TEST(Random, NormalHasMeanZeroAndVarianceOne) {
  Random r(43);
  double sum = 0.0;
  double squares = 0.0;
  constexpr int kDraws = 100'000;
  for (int i = 0; i < kDraws; ++i) {
    const double n = r.normal();
    sum += n;
    squares += n * n;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 0.02);
  EXPECT_NEAR(squares / kDraws, 1.0, 0.02);
}

TEST(Random, BelowReachesEveryNumberAndNoOther) {
  Random r(44);
  int seen[5] = {};
  for (int i = 0; i < 1000; ++i) ++seen[r.below(5)];
  for (const int count : seen) EXPECT_GT(count, 100);
}

}  // namespace
}  // namespace mlab::base
