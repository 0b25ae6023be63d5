#include "mlab/schema/historic.h"

#include <gtest/gtest.h>

namespace mlab::schema {
namespace {

using geom::Vector;

TEST(HistoricNames, ComputeTheGoalVectorOfThe1995Report) {
  Vector output{3.0, 4.0};
  EXPECT_DOUBLE_EQ(len_2d(output), 5.0);
  unit_2d(output);
  EXPECT_EQ(output, (Vector{0.6, 0.8, 0.0}));
  VECTOR_ZERO(output);
  EXPECT_EQ(output, Vector{});
}

TEST(HistoricNames, AddInPlaceOrIntoAThird) {
  Vector a{1.0, 2.0, 3.0};
  plus_2d(a, {10.0, 20.0, 30.0});
  EXPECT_EQ(a, (Vector{11.0, 22.0, 3.0}));
  add_3d(a, Vector{0.0, 0.0, 1.0});
  EXPECT_EQ(a, (Vector{11.0, 22.0, 4.0}));
  Vector out;
  minus_2d(out, a, {1.0, 2.0, 0.0});
  EXPECT_EQ(out, (Vector{10.0, 20.0, 0.0}));
}

TEST(HistoricNames, ReturnTheResultForInputsThatMayNotChange) {
  const Vector input{3.0, 0.0, 1.0};
  EXPECT_EQ(unit_2d(input), (Vector{1.0, 0.0, 1.0}));
  EXPECT_EQ(mult_2d(input, 2.0), (Vector{6.0, 0.0, 1.0}));
  EXPECT_EQ(times_3d(input, 2.0), (Vector{6.0, 0.0, 2.0}));
}

TEST(HistoricNames, TurnByDegrees) {
  Vector v{1.0, 0.0, 5.0};
  rotate_z(v, 90.0);
  EXPECT_NEAR(v.x, 0.0, 1e-12);
  EXPECT_NEAR(v.y, 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(v.z, 5.0);
}

TEST(HistoricNames, LeaveVectorsWithoutDirectionAtZero) {
  Vector v{1e-6, 0.0, 0.0};
  EXPECT_EQ(unit_2d(v), Vector{});
  Vector w{0.0, 0.0, 1e-6};
  EXPECT_EQ(unit_3d(w), Vector{});
}

}  // namespace
}  // namespace mlab::schema
