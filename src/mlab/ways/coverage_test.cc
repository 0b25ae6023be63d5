#include "mlab/ways/coverage.h"

#include <gtest/gtest.h>

namespace mlab::ways {
namespace {

TEST(Coverage, IsEmptyWhereNothingIsToBeSearched) {
  EXPECT_EQ(coverage_route({}, {}, 1.0, 10.0).end, CoverageEnd::kNothingToSearch);
}

}  // namespace
}  // namespace mlab::ways
