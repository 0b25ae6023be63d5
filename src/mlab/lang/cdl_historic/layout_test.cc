#include "mlab/lang/cdl_historic/layout.h"

#include <cmath>
#include <cstddef>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

namespace mlab::cdl_historic {
namespace {

TEST(HistoricLayout, LeavesWhatDoesNotOverlapWhereItWas) {
  const cdl::Layout layout = laid_out({"A", {{"a", 50, 50}, {"b", 400, 60}, {"c", 50, 300}}});
  ASSERT_EQ(layout.entries.size(), 3U);
  EXPECT_EQ(layout.entries[1].x, 400);
  EXPECT_EQ(layout.entries[2].y, 300);
}

TEST(HistoricLayout, PutsNodesThatStandOnEachOtherBelowEachOther) {
  const cdl::Layout layout = laid_out({"A", {{"a", 50, 50}, {"b", 50, 50}}});
  EXPECT_EQ(layout.entries[1].x, 50);
  EXPECT_EQ(layout.entries[1].y, 50 + kNodeHeight);
}

RC_GTEST_PROP(HistoricLayout, KeepsTheOrderAndLeavesNoOverlap, ()) {
  Drawing drawing{"A", {}};
  for (int i = *rc::gen::inRange(0, 30); i > 0; --i) {
    drawing.nodes.push_back({"n", static_cast<double>(*rc::gen::inRange(-50, 900)),
                             static_cast<double>(*rc::gen::inRange(-50, 900))});
  }
  const cdl::Layout layout = laid_out(drawing);
  for (std::size_t i = 0; i < drawing.nodes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Node& a = drawing.nodes[i];
      const Node& b = drawing.nodes[j];
      const cdl::LayoutEntry& p = layout.entries[i];
      const cdl::LayoutEntry& q = layout.entries[j];
      if (a.x < b.x) RC_ASSERT(p.x <= q.x);
      if (a.y < b.y) RC_ASSERT(p.y <= q.y);
      RC_ASSERT(std::abs(p.x - q.x) >= kNodeWidth - 1 || std::abs(p.y - q.y) >= kNodeHeight - 1);
    }
  }
}

}  // namespace
}  // namespace mlab::cdl_historic
