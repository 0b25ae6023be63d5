#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

using geom::Point;
using geom::Vector;

template <class T>
T answer_of(flow::BehaviorProbe& probe) {
  probe.step();
  return probe.output<T>();
}

double number_of(const char* name, double a, double b) {
  return answer_of<double>(probe(name).set("a", a).set("b", b));
}
bool truth_of(const char* name, double a, double b) {
  return answer_of<bool>(probe(name).set("a", a).set("b", b));
}

TEST(Numbers, AreComputed) {
  EXPECT_EQ(number_of("AddNumbers", 2.0, 0.5), 2.5);
  EXPECT_EQ(number_of("SubtractNumbers", 2.0, 0.5), 1.5);
  EXPECT_EQ(number_of("MultiplyNumbers", 2.0, 0.5), 1.0);
  EXPECT_EQ(number_of("DivideNumbers", 2.0, 0.5), 4.0);
  EXPECT_EQ(answer_of<double>(probe("NegateNumber").set("a", 2.0)), -2.0);
  EXPECT_EQ(answer_of<double>(probe("InRadians").set("angle", 2.0)), 2.0);
}

TEST(Numbers, DividedByZeroAreNone) {
  EXPECT_TRUE(std::isnan(number_of("DivideNumbers", 2.0, 0.0)));
  EXPECT_TRUE(std::isnan(number_of("DivideNumbers", -2.0, -0.0)));
  EXPECT_TRUE(std::isnan(number_of("DivideNumbers", 0.0, 0.0)));
  const auto by_zero =
      answer_of<Vector>(probe("DivideVector").set("v", Vector{1.0, 0.0}).set("divisor", 0.0));
  EXPECT_TRUE(std::isnan(by_zero.x) && std::isnan(by_zero.y));
}

// A fault has to reach the actuator: what limits it would hide it.
TEST(Numbers, ThatAreNoneStayNoneHoweverTheyAreLimited) {
  const double none = number_of("DivideNumbers", 1.0, 0.0);
  for (const char* name : {"Minimum", "Maximum"}) {
    EXPECT_TRUE(std::isnan(number_of(name, none, 1.0))) << name;
    EXPECT_TRUE(std::isnan(number_of(name, 1.0, none))) << name;
  }
  for (int i = 0; i < 3; ++i) {
    const double x = i == 0 ? none : 0.5;
    const double low = i == 1 ? none : 0.0;
    const double high = i == 2 ? none : 1.0;
    EXPECT_TRUE(std::isnan(answer_of<double>(probe("Clamp").set("x", x).set("low", low).set("high", high))))
        << i;
  }
}

TEST(Numbers, HaveALesserAndAGreater) {
  EXPECT_EQ(number_of("Minimum", 2.0, -3.0), -3.0);
  EXPECT_EQ(number_of("Minimum", 2.0, 2.0), 2.0);
  EXPECT_EQ(number_of("Maximum", 2.0, -3.0), 2.0);
  EXPECT_EQ(answer_of<double>(probe("Absolute").set("x", -3.5)), 3.5);
}

TEST(Clamp, KeepsWithinTheRange) {
  const auto clamped = [](double x, double low, double high) {
    return answer_of<double>(probe("Clamp").set("x", x).set("low", low).set("high", high));
  };
  EXPECT_EQ(clamped(0.5, 0.0, 1.0), 0.5);
  EXPECT_EQ(clamped(-2.0, 0.0, 1.0), 0.0);
  EXPECT_EQ(clamped(2.0, 0.0, 1.0), 1.0);
  EXPECT_EQ(clamped(0.5, 1.0, 0.0), 0.0);
}

TEST(Comparisons, AreThoseOfNumbers) {
  EXPECT_TRUE(truth_of("IsLess", 1.0, 2.0));
  EXPECT_FALSE(truth_of("IsLess", 2.0, 2.0));
  EXPECT_TRUE(truth_of("IsLessOrEqual", 2.0, 2.0));
  EXPECT_FALSE(truth_of("IsLessOrEqual", 2.5, 2.0));
  EXPECT_TRUE(truth_of("AreEqual", 2.0, 2.0));
  EXPECT_FALSE(truth_of("AreEqual", 2.0, std::nextafter(2.0, 3.0)));
  EXPECT_TRUE(truth_of("AreUnequal", 2.0, 3.0));
}

TEST(Vectors, AreComputed) {
  const Vector a{3.0, 4.0, 1.0};
  const Vector b{1.0, -2.0, 0.0};
  EXPECT_EQ(answer_of<Vector>(probe("AddVectors").set("a", a).set("b", b)), (Vector{4.0, 2.0, 1.0}));
  EXPECT_EQ(answer_of<Vector>(probe("NegateVector").set("v", a)), (Vector{-3.0, -4.0, -1.0}));
  EXPECT_EQ(answer_of<Vector>(probe("DivideVector").set("v", a).set("divisor", 2.0)),
            (Vector{1.5, 2.0, 0.5}));
}

TEST(UnitVector, IsOfLengthOneAndOfZeroStaysZero) {
  EXPECT_EQ(answer_of<Vector>(probe("UnitVector").set("v", Vector{3.0, 4.0})), (Vector{0.6, 0.8}));
  EXPECT_EQ(answer_of<Vector>(probe("UnitVector").set("v", Vector{})), Vector{});
}

TEST(DirectionOf, CountsFromStraightAhead) {
  EXPECT_DOUBLE_EQ(answer_of<double>(probe("DirectionOf").set("v", Vector{0.0, 2.0})),
                   std::numbers::pi / 2.0);
  EXPECT_EQ(answer_of<double>(probe("DirectionOf").set("v", Vector{})), 0.0);
}

TEST(Distance, IsThatOfTwoPlaces) {
  EXPECT_EQ(answer_of<double>(probe("DistanceOfPoints").set("a", Point{1.0, 1.0}).set("b", Point{4.0, 5.0})),
            5.0);
  EXPECT_EQ(
      answer_of<double>(probe("DistanceOfVectors").set("a", Vector{1.0, 1.0}).set("b", Vector{4.0, 5.0})),
      5.0);
}

}  // namespace
}  // namespace mlab::library_test
