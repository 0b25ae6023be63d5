#include <gtest/gtest.h>

#include "../testing/library_probe.h"

namespace mlab::library_test {
namespace {

bool of_two(const char* name, bool a, bool b) {
  flow::BehaviorProbe p = probe(name);
  p.set("a", a).set("b", b).step();
  return p.output<bool>();
}

TEST(Logic, HasItsTruthTables) {
  for (const bool a : {false, true}) {
    for (const bool b : {false, true}) {
      EXPECT_EQ(of_two("And", a, b), a && b);
      EXPECT_EQ(of_two("Or", a, b), a || b);
      EXPECT_EQ(of_two("Nor", a, b), !(a || b));
    }
    flow::BehaviorProbe p = probe("Not");
    p.set("a", a).step();
    EXPECT_EQ(p.output<bool>(), !a);
  }
}

TEST(Constant, IsTrueUnlessTold) {
  flow::BehaviorProbe p = probe("Constant");
  p.step();
  EXPECT_TRUE(p.output<bool>());
  p.set("value", false).step();
  EXPECT_FALSE(p.output<bool>());
}

TEST(EqualIntegers, ComparesThem) {
  flow::BehaviorProbe p = probe("EQUAL_INT");
  p.set("a", 100).set("b", 100).step();
  EXPECT_TRUE(p.output<bool>());
  p.set("b", 115).step();
  EXPECT_FALSE(p.output<bool>());
}

}  // namespace
}  // namespace mlab::library_test
