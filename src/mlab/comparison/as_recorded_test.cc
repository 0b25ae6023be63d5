#include "mlab/comparison/as_recorded.h"

#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mlab/comparison/report.h"
#include "mlab/comparison/testing/two_runs.h"
#include "mlab/comparison/words.h"

namespace mlab::comparison {
namespace {

using history::testing::WrittenRun;
using testing::compared;
using testing::HistoryPtr;

// A run of which nothing can be computed again.
std::vector<wire::HistoryEntry> of_vehicles(std::uint64_t seed) {
  WrittenRun written("demo_c/demo_c.mdl", seed, true);
  written.run().post(mission::event::Execute{});
  for (int i = 0; i < 250; ++i) written.step();
  written.end();
  std::vector<wire::HistoryEntry> out = written.entries();
  for (wire::HistoryEntry& entry : out) {
    if (!entry.has_beginning()) continue;
    entry.mutable_beginning()->set_is_in_real_time(true);
    entry.mutable_beginning()->set_holds_answers(false);
  }
  return out;
}

TEST(AsRecorded, TheSameIsTheSame) {
  const HistoryPtr one = testing::of_entries(of_vehicles(1));
  const Comparison is = compared(one, testing::of_entries(of_vehicles(1)));
  EXPECT_FALSE(is.is_recomputed);
  EXPECT_TRUE(is.is_same()) << report_of(is);
  EXPECT_EQ(verdict(is), "the same run, as far as they were recorded");
  EXPECT_NE(report_of(is).find("it can't be computed again: its robots were elsewhere"), std::string::npos);
}

TEST(AsRecorded, PlacesAndMarksSayWhereTheyPart) {
  const Comparison is = compared(testing::of_entries(of_vehicles(1)), testing::of_entries(of_vehicles(2)));
  ASSERT_TRUE(is.parting);
  EXPECT_EQ(is.parting->what, Parting::What::kPlace);
  EXPECT_EQ(is.parting->same_until, 200U);
  EXPECT_NE(report_of(is).find("Only what was recorded is compared"), std::string::npos);
  ASSERT_EQ(is.robots.size(), 4U);
  EXPECT_GT(is.robots[0].most_apart, 0.0);
  EXPECT_EQ(is.robots[0].apart.size(), is.times.size());
}

TEST(AsRecorded, WhatIsNoNumberIsNoPlace) {
  std::vector<wire::HistoryEntry> entries = of_vehicles(1);
  for (wire::HistoryEntry& entry : entries) {
    if (!entry.has_poses() || entry.poses().robots_size() == 0) continue;
    entry.mutable_poses()->set_x(0, std::numeric_limits<float>::quiet_NaN());
    entry.mutable_poses()->add_robots(4'000'000'000U);
    entry.mutable_poses()->add_x(std::numeric_limits<float>::infinity());
    entry.mutable_poses()->add_y(1e30F);
    entry.mutable_poses()->add_heading(0.0F);
  }
  const Comparison is = compared(testing::of_entries(entries), testing::of_entries(of_vehicles(1)));
  ASSERT_TRUE(is.parting);
  const auto json = nlohmann::json::parse(json_of(is));
  EXPECT_TRUE(json["robots"][0]["apart_m"].back().is_null());
  EXPECT_FALSE(page_of(is, "test").empty());
}

TEST(AsRecorded, OneThatWasCutOffIsComparedUpToThere) {
  std::vector<wire::HistoryEntry> entries = of_vehicles(1);
  const HistoryPtr whole = testing::of_entries(entries);
  entries.resize(entries.size() / 2);
  const Comparison is = compared(testing::of_entries(entries), whole);
  ASSERT_TRUE(is.parting);
  EXPECT_EQ(is.parting->what, Parting::What::kEnd);
}

}  // namespace
}  // namespace mlab::comparison
