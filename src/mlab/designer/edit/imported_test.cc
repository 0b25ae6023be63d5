// Configurations of the historic tools, as they are drawn.

#include <cstdlib>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/designer/drawing/drawing.h"
#include "mlab/designer/edit/spread.h"
#include "mlab/lang/cdl_historic/import.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/text/testing/golden.h"

namespace mlab::designer {
namespace {

namespace fs = std::filesystem;

constexpr double kLeastRoom = 16.0;  // [pixels]

fs::path corpus() {
  const char* named = std::getenv("MLAB_CORPUS");  // NOLINT(concurrency-mt-unsafe): nobody sets it here
  return (named != nullptr ? fs::path(named) : fs::path(base::source_folder()) / "../shared/corpus") /
         "configurations";
}

std::string imported(const fs::path& path) {
  static const cdl_historic::Vocabulary kVocabulary(robot::component_library(),
                                                    robot::library_environment().built_in);
  const auto source = text::read_source(path.string());
  text::Diagnostics sink;
  return source ? cdl_historic::import_as_text(*source, kVocabulary, sink) : "";
}

std::shared_ptr<Model> read_model(const std::string& text) {
  return std::make_shared<Model>(std::make_shared<const text::Source>("a.cdl", text),
                                 robot::library_environment());
}

/// All pages of a configuration that can be entered.
std::vector<Drawing> all_pages(const Model& model) {
  std::vector<Drawing> out;
  std::set<std::string> seen{""};
  std::vector<std::string> open{""};
  while (!open.empty()) {
    const std::string path = open.back();
    open.pop_back();
    out.push_back(draw(model, path, {"a.cdl", 1, false, [](std::string_view) { return std::string(); }}));
    const auto enter = [&](const Page& page) {
      if (page.document() == "a.cdl" && seen.insert(page.path()).second) open.push_back(page.path());
    };
    for (const Node& node : out.back().nodes()) enter(node.inner());
    for (const State& state : out.back().states()) enter(state.inner());
  }
  return out;
}

std::map<std::string, DrawnBox> places(const Model& model) {
  std::map<std::string, DrawnBox> out;
  for (const Drawing& drawing : all_pages(model)) {
    for (const DrawnBox& box : placed_boxes(drawing)) out[drawing.page().path() + " " + box.name] = box;
  }
  return out;
}

TEST(Imported, EveryFileOfTheCorpusIsDrawnWithoutOverlaps) {
  if (!fs::is_directory(corpus())) GTEST_SKIP() << "no corpus at " << corpus();
  std::size_t count = 0;
  for (const fs::path& path : text::testing::golden_files(corpus(), ".cdl")) {
    const std::string text = spread_out(imported(path), robot::library_environment());
    const auto model = read_model(text);
    ASSERT_TRUE(model->is_readable()) << path;
    for (const Drawing& drawing : all_pages(*model)) {
      const std::vector<DrawnBox> boxes = placed_boxes(drawing);
      count += boxes.size();
      for (auto a = boxes.begin(); a != boxes.end(); ++a) {
        for (auto b = boxes.begin(); b != a; ++b) {
          const bool is_beside =
              a->x >= b->x + b->size.width + kLeastRoom || b->x >= a->x + a->size.width + kLeastRoom ||
              a->y >= b->y + b->size.height + kLeastRoom || b->y >= a->y + a->size.height + kLeastRoom;
          EXPECT_TRUE(is_beside) << path << " " << drawing.page().path() << ": " << a->name << " on "
                                 << b->name;
        }
      }
    }
  }
  EXPECT_GT(count, 100U);
}

TEST(Imported, TheAuthorsOrderStays) {
  if (!fs::is_directory(corpus())) GTEST_SKIP() << "no corpus at " << corpus();
  for (const fs::path& path : text::testing::golden_files(corpus(), ".cdl")) {
    const std::string text = imported(path);
    const auto before = places(*read_model(text));
    const auto after = places(*read_model(spread_out(text, robot::library_environment())));
    ASSERT_EQ(before.size(), after.size()) << path;
    for (const auto& [name, one] : before) {
      const std::string page = name.substr(0, name.find(' '));
      for (const auto& [other_name, other] : before) {
        if (other_name.substr(0, other_name.find(' ')) != page) continue;
        if (one.x < other.x) {
          EXPECT_LE(after.at(name).x, after.at(other_name).x) << path << " " << name;
        }
        if (one.y < other.y) {
          EXPECT_LE(after.at(name).y, after.at(other_name).y) << path << " " << name;
        }
      }
    }
  }
}

TEST(Spread, LeavesWhatHasRoomWhereItIs) {
  std::vector<DrawnBox> boxes = {{"a", 0, 0, {100, 50}}, {"b", 200, 10, {100, 50}}, {"c", 0, 200, {100, 50}}};
  spread(boxes, 40, 24);
  EXPECT_EQ(boxes[0].x, 0);
  EXPECT_EQ(boxes[1].x, 200);
  EXPECT_EQ(boxes[1].y, 10);
  EXPECT_EQ(boxes[2].y, 200);
}

TEST(Spread, MovesWhatStandsInARowToTheRightAndTheRestDown) {
  std::vector<DrawnBox> boxes = {{"a", 0, 0, {100, 50}}, {"b", 20, 5, {100, 50}}, {"c", 10, 40, {100, 50}}};
  spread(boxes, 40, 24);
  EXPECT_EQ(boxes[1].x, 140);
  EXPECT_EQ(boxes[1].y, 5);
  EXPECT_EQ(boxes[2].y, 79);
}

TEST(Spread, PutsThingsOfOnePlaceBelowEachOther) {
  std::vector<DrawnBox> boxes(3, {"a", 5, 5, {100, 50}});
  spread(boxes, 40, 24);
  EXPECT_EQ(boxes[1].y, 79);
  EXPECT_EQ(boxes[2].y, 153);
}

}  // namespace
}  // namespace mlab::designer
