#include "mlab/base/fields.h"

#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace mlab::base {
namespace {

struct Inner {
  double x = 0.0;
  double y = 0.0;
};

struct Outer {
  int number = 1;
  Inner inner;
  bool flag = true;
  std::span<const int> list;
};

static_assert(count_fields<Inner>() == 2);
static_assert(count_fields<Outer>() == 4);

TEST(Fields, AreVisitedInTheirOrder) {
  std::vector<std::size_t> sizes;
  const Outer outer;
  for_each_field(outer, [&](const auto& field) { sizes.push_back(sizeof field); });
  EXPECT_EQ(sizes, (std::vector<std::size_t>{sizeof(int), sizeof(Inner), sizeof(bool),
                                             sizeof(std::span<const int>)}));
}

TEST(Fields, CanBeChanged) {
  Inner inner;
  for_each_field(inner, [](double& field) { field += 2.0; });
  EXPECT_EQ(inner.x, 2.0);
  EXPECT_EQ(inner.y, 2.0);
}

}  // namespace
}  // namespace mlab::base
