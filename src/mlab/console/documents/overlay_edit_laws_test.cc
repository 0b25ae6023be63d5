#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "mlab/base/random.h"
#include "mlab/base/testing/source_folder.h"
#include "mlab/console/testing/map_of_texts.h"
#include "mlab/console/testing/random_change.h"
#include "mlab/text/testing/golden.h"

namespace mlab::console {
namespace {

namespace fs = std::filesystem;
using testing::MapOfTexts;

// A map in all the ways of writing that there are.
const std::string kMissionWithOverlays =
    "MISSION NAME x OVERLAY a.odl SP start 1 2 -- SP\nOVERLAY b.odl\nOBSTACLE 3 4 5 OBSTACLE 6 7 8\nUNIT <u> "
    "ROBOT\nCOMMAND LIST:\n 0. UNIT u START aa-one\n 1. UNIT u MOVETO PP-two PHASE-LINE three\n";
const std::string kFirst =
    "-- a\nORIGIN UTM LAT 33.7774 LON -84.3973\nMISSION-AREA 800 600\nControl Measures:\nOBSTACLE 7 7 2 "
    "ROUTE UTM LAT 33.7783 LON "
    "-84.3973 9 9 SPEED 1 AA One* UTM LAT "
    "33.7783 LON "
    "-84.3973 -- utm\n UTM LON -84.39 LAT 33.77 20 20 35\nPP two UTM LAT 33.778 LON -84.397\nWALL w 0 0, 5 "
    "5; 6 6 2 -- "
    "strays\n";
const std::string kSecond =
    "ORIGIN 10 -20\r\nCONTROL MEASURES:\r\nPL three 0 0 -- c\r\n  10 10\r\n\r\n  20 0\r\nHALLWAY h "
    "CENTERLINE 1 2 3 4 "
    "WIDTH 2 EXTENTS 1 1 3 3\r\nOBJECT 1 2 3 fixed red FLAG 4 4 route 5 5 speed 1 BASKET 5 5 1\r\nOBSTACLE 1 "
    "2 3 4 obstacle 5 "
    "5 1 route 9 5 "
    "-- r\r\n 5 5 speed 2.0 GAP Door 1 1 2 2";

std::vector<std::string> comments_of(const std::string& text) {
  std::vector<std::string> out;
  for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at + 2)) {
    std::string comment = text.substr(at, text.find('\n', at) - at);
    while (comment.ends_with(' ') || comment.ends_with('\r')) comment.pop_back();
    out.push_back(comment);
  }
  return out;
}

std::string all_of(const MapOfTexts& texts, const std::vector<std::string>& names) {
  std::string out = texts.mission();
  for (const std::string& name : names) out += texts.overlay(name);
  return out;
}

// After each change the texts are as free of mistakes as before, keep their comments, and mean what was asked
// for.
void change_at_random(MapOfTexts& texts, base::Random& random, int count,
                      const std::vector<std::string>& names) {
  for (int i = 0; i < count; ++i) {
    const Scene before = texts.scene();
    const auto was_right = !texts.has_errors();
    const std::string old = all_of(texts, names);
    std::vector<std::string> comments;
    for (const std::string& name : names) {
      for (const std::string& comment : comments_of(texts.overlay(name))) comments.push_back(comment);
    }
    const MapChange change = testing::random_change(before, random);
    if (!texts.change({change}).empty()) continue;
    std::vector<std::string> now;
    for (const std::string& name : names) {
      for (const std::string& comment : comments_of(texts.overlay(name))) now.push_back(comment);
    }
    ASSERT_EQ(now, comments) << change.ShortDebugString();
    const bool may_miss_a_place = change.has_remove_measure();
    if (was_right && !may_miss_a_place) {
      ASSERT_FALSE(texts.has_errors()) << change.ShortDebugString() << "\n" << texts.said();
    }
    ASSERT_EQ(testing::difference(before, change, texts.scene()), "")
        << change.ShortDebugString() << "\nbefore:\n"
        << old << "\nnow:\n"
        << all_of(texts, names);
  }
}

RC_GTEST_PROP(OverlayEditLaws, AfterAnyChangesTheMapIsAsAsked, (std::uint32_t seed)) {
  MapOfTexts texts(kMissionWithOverlays, {{"a.odl", kFirst}, {"b.odl", kSecond}});
  ASSERT_FALSE(texts.has_errors()) << texts.said();
  base::Random random(seed);
  change_at_random(texts, random, 12, {"a.odl", "b.odl"});
  RC_ASSERT(!::testing::Test::HasFatalFailure());
}

fs::path corpus() {
  const char* named = std::getenv("MLAB_CORPUS");  // NOLINT(concurrency-mt-unsafe): nobody sets it here
  return named != nullptr ? fs::path(named) : fs::path(base::source_folder()) / "../shared/corpus";
}

TEST(OverlayEditCorpus, SurvivesRandomChanges) {
  int files = 0;
  for (const char* folder : {"overlays", "missions"}) {
    if (!fs::is_directory(corpus() / folder)) continue;
    for (const fs::path& path : text::testing::golden_files(corpus() / folder, ".ovl")) {
      MapOfTexts texts(text::testing::read_all(path));
      base::Random random(static_cast<std::uint64_t>(++files));
      change_at_random(texts, random, 15, {"o.odl"});
      ASSERT_FALSE(::testing::Test::HasFatalFailure()) << path;
    }
  }
  if (files == 0) GTEST_SKIP() << "no corpus at " << corpus();
  std::cout << files << " overlays\n";
}

}  // namespace
}  // namespace mlab::console
