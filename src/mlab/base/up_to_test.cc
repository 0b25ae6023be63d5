#include "mlab/base/up_to.h"

#include <vector>

#include <gtest/gtest.h>

namespace mlab::base {
namespace {

TEST(UpTo, KeepsWhatIsAddedInItsOrderAsLongAsThereIsRoom) {
  UpTo<int, 3> list;
  EXPECT_EQ(list.size(), 0U);
  EXPECT_TRUE(list.all().empty());
  for (const int value : {7, 5}) list.add(value);
  EXPECT_FALSE(list.is_full());
  for (const int value : {6, 4}) list.add(value);
  EXPECT_TRUE(list.is_full());
  EXPECT_EQ(std::vector<int>(list.begin(), list.end()), (std::vector<int>{7, 5, 6}));
  EXPECT_EQ(list.all().size(), list.capacity());
  EXPECT_EQ(list[1], 5);
}

}  // namespace
}  // namespace mlab::base
