#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/odl/odl.h"
#include "mlab/lang/odl/testing/check_print.h"
#include "mlab/text/testing/golden.h"

namespace mlab::odl {
namespace {

namespace fs = std::filesystem;

// Real files of the historic system, where they are at hand.
fs::path corpus() {
  const char* named = std::getenv("MLAB_CORPUS");  // NOLINT(concurrency-mt-unsafe): nobody sets it here
  return named != nullptr ? fs::path(named) : fs::path(base::source_folder()) / "../shared/corpus";
}

std::vector<fs::path> overlays() {
  std::vector<fs::path> out;
  for (const char* folder : {"overlays", "missions"}) {
    if (!fs::is_directory(corpus() / folder)) continue;
    for (const auto& path : text::testing::golden_files(corpus() / folder, ".ovl")) out.push_back(path);
  }
  return out;
}

// Counts features without the parser: lines whose first word is one.
std::size_t quick_count(const std::string& text) {
  static constexpr std::array kWords = {"AA", "ATK", "AXIS", "BOUNDARY", "ATTRACTOR", "OBJECT",   "BASKET",
                                        "BP", "GAP", "LDLC", "LD/LC",    "OBJ",       "OBSTACLE", "PL",
                                        "PP", "SP",  "WALL", "ROOM",     "DOOR",      "HALLWAY"};
  std::istringstream lines(text);
  std::string line;
  std::size_t count = 0;
  while (std::getline(lines, line)) {
    std::string word;
    std::istringstream(line) >> word;
    std::ranges::transform(word, word.begin(), [](unsigned char c) { return std::toupper(c); });
    count += static_cast<std::size_t>(std::ranges::count(kWords, word));
  }
  return count;
}

TEST(OdlCorpus, LoadsWithoutErrorsAndWithEveryFeature) {
  const auto files = overlays();
  if (files.empty()) GTEST_SKIP() << "no corpus at " << corpus();
  std::size_t features = 0;
  for (const fs::path& path : files) {
    text::Diagnostics sink;
    overlay::Overlay o;
    EXPECT_TRUE(load_overlay(path.string(), o, sink)) << text::render(sink);
    EXPECT_EQ(o.measures.size() + o.obstacles.size() + o.objects.size(),
              quick_count(text::testing::read_all(path)))
        << path;
    features += o.measures.size();
  }
  std::cout << files.size() << " overlays, " << features << " control measures\n";
}

TEST(OdlCorpus, IsFormattedWithoutLoss) {
  const auto files = overlays();
  if (files.empty()) GTEST_SKIP() << "no corpus at " << corpus();
  for (const fs::path& path : files) {
    bool had_errors = true;
    EXPECT_EQ(what_print_changes(text::testing::read_all(path), had_errors), "") << path;
    EXPECT_FALSE(had_errors) << path;
  }
}

}  // namespace
}  // namespace mlab::odl
