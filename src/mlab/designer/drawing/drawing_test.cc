#include "mlab/designer/drawing/drawing.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "mlab/base/testing/processor_time.h"
#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/cdl/lower/lower.h"
#include "mlab/robot/program/configuration_file.h"

namespace mlab::designer {
namespace {

std::string read(const std::string& path) {
  std::ifstream in(base::source_folder() + "/" + path);
  std::stringstream out;
  out << in.rdbuf();
  return out.str();
}

std::unique_ptr<Model> model_of(const std::string& text) {
  return std::make_unique<Model>(std::make_shared<const text::Source>("test.cdl", text),
                                 robot::library_environment());
}

DrawingContext context() {
  return {"test.cdl", 1, false, [](std::string_view name) { return "library:" + std::string(name); }};
}

const Node* find(const Drawing& drawing, std::string_view name) {
  const auto found = std::ranges::find(drawing.nodes(), name, &Node::name);
  return found == drawing.nodes().end() ? nullptr : &*found;
}

TEST(Drawing, ShowsAnAssemblageAsADataflow) {
  const auto model = model_of(read("missions/forage/forager.cdl"));
  const Drawing drawing = draw(*model, "Wander", context());
  EXPECT_EQ(drawing.kind(), Drawing::DATAFLOW);
  EXPECT_EQ(drawing.result_node(), "cooperate");
  const Node* noise = find(drawing, "value.Noise");
  ASSERT_NE(noise, nullptr) << drawing.DebugString();
  EXPECT_EQ(noise->shape(), Node::BEHAVIOR);
  EXPECT_EQ(noise->type(), "Vector");
}

TEST(Drawing, ShowsASequenceAsStates) {
  const auto model = model_of(read("missions/forage/forager.cdl"));
  const Drawing drawing = draw(*model, "Forage", context());
  EXPECT_EQ(drawing.kind(), Drawing::STATES);
  ASSERT_EQ(drawing.states_size(), 6);
  EXPECT_TRUE(drawing.states(0).is_start());
  EXPECT_EQ(drawing.states(0).calls().path(), "Wander");
  EXPECT_EQ(drawing.transitions_size(), 8);
  EXPECT_NE(find(drawing, "target"), nullptr);
  const Drawing inside = draw(*model, "Forage.Acquiring", context());
  ASSERT_NE(find(inside, "Acquire"), nullptr) << inside.DebugString();
  ASSERT_NE(find(inside, "target"), nullptr);
  EXPECT_EQ(inside.way_size(), 3);
}

TEST(Drawing, ShowsWhatARobotIsBoundTo) {
  const auto model = model_of(read("missions/forage/forager.cdl"));
  const Drawing drawing = draw(*model, "Forager", context());
  EXPECT_EQ(drawing.kind(), Drawing::ROBOT);
  ASSERT_NE(find(drawing, "movement"), nullptr);
  ASSERT_NE(find(drawing, "$movement"), nullptr);
  EXPECT_EQ(drawing.robot().class_name(), "Collector");
  const auto own = std::ranges::find(drawing.robot().classes(), "Collector", &Robot::Class::name);
  ASSERT_NE(own, drawing.robot().classes().end());
  EXPECT_EQ(own->verdict(), "");
}

TEST(Drawing, ShowsAFileAndASociety) {
  const auto model = model_of(read("missions/forage/forager.cdl"));
  EXPECT_EQ(draw(*model, "", context()).kind(), Drawing::FILE);
  const Drawing society = draw(*model, "Foragers", context());
  EXPECT_EQ(society.kind(), Drawing::SOCIETY);
  ASSERT_EQ(society.nodes_size(), 1);
  EXPECT_EQ(society.nodes(0).shape(), Node::TEAM);
  EXPECT_EQ(society.nodes(0).count(), 3);
}

// All names that the pages of an owner give, by the place of what they stand for.
void add_names(const Model& model, const std::string& owner, const std::string& prefix,
               std::set<std::string>& out) {
  const OwnerGraph* graph = model.graph(owner);
  if (graph == nullptr) return;
  for (const GraphPage& page : graph->pages) {
    for (const GraphNode& node : page.nodes) {
      if (node.expression != nullptr) out.insert(node.path.empty() ? prefix : prefix + "." + node.path);
    }
  }
}

TEST(Drawing, NamesNodesAsLoweringDoes) {
  const auto model = model_of(read("missions/forage/forager.cdl"));
  text::Diagnostics sink;
  cdl::EarlierFindings said;
  const cdl::LoweredRobot lowered =
      cdl::lower(model->configuration(), *model->robot("Forager"), model->library(), sink, said);
  std::set<std::string> names;
  for (const flow::Node& node : lowered.network.nodes) names.insert(node.name);
  std::set<std::string> drawn;
  add_names(*model, "Forage", "movement", drawn);
  add_names(*model, "Wander", "movement.Searching", drawn);
  add_names(*model, "Deliver", "movement.Delivering", drawn);
  for (const std::string& name : drawn) EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Drawing, DrawsEveryPageOfTheLibrary) {
  for (const auto& tree : robot::library_environment().built_in) {
    const auto model = model_of(std::string(tree->source->text()));
    for (const cdl::Item& item : model->tree().items) {
      const auto* assemblage = std::get_if<cdl::Assemblage>(&item);
      if (assemblage == nullptr) continue;
      const OwnerGraph* graph = model->graph(assemblage->name.text);
      for (const GraphPage& page : graph->pages) {
        const Drawing drawing = draw(*model, page.path, context());
        EXPECT_GT(drawing.way_size(), 1) << page.path;
        std::set<std::string> names;
        for (const Node& node : drawing.nodes()) {
          EXPECT_TRUE(names.insert(node.name()).second) << page.path << " " << node.name();
          EXPECT_FALSE(node.name().empty());
          EXPECT_NE(node.shape(), Node::UNKNOWN) << page.path << " " << node.name();
        }
        for (const Wire& wire : drawing.wires())
          EXPECT_TRUE(names.contains(wire.from())) << page.path << " " << wire.from();
      }
    }
  }
}

TEST(Drawing, DrawsThousandsOfNodesInTimeThatGrowsWithThem) {
  constexpr std::size_t kFew = 500;
  const auto large_model = [](std::size_t count) {
    std::string text = "assemblage A() {\n";
    for (std::size_t i = 0; i < count; ++i) text += "let n" + std::to_string(i) + " = Noise();\n";
    text += "cooperate {\n";
    for (std::size_t i = 0; i < count; ++i) text += "1: AvoidStaticObstacles(sphere = 2 m);\n";
    text += "}\n}\nlayout A {\n";
    for (std::size_t i = 0; i < count; ++i) text += "n" + std::to_string(i) + " 1 2;\n";
    return model_of(text + "}\n");
  };
  const auto few = large_model(kFew);
  const auto many = large_model(8 * kFew);
  const auto draw_it = [&](std::size_t count) {
    EXPECT_EQ(draw(count == kFew ? *few : *many, "A", context()).nodes_size(),
              static_cast<int>(2 * count + 1));
  };
  EXPECT_LT(base::growth(draw_it, kFew), base::kGrowthOfLine);
}

TEST(Palette, GroupsWhatCanBePlaced) {
  const auto model = model_of(read("missions/forage/forager.cdl"));
  const Palette palette = palette_of(*model, context());
  std::map<std::string, std::string> groups;
  for (const Component& one : palette.components()) groups[one.name()] = one.group();
  EXPECT_EQ(groups["Noise"], "Motor schemas");
  EXPECT_EQ(groups["cooperate"], "Operators");
  EXPECT_EQ(groups["coordinate by WeightedSum"], "Operators");
  EXPECT_EQ(groups["Holding"], "Triggers");
  EXPECT_EQ(groups["Wander"], "This file");
  EXPECT_EQ(groups["sense_obstacles"], "Sensors");
  EXPECT_EQ(groups["ClosestObject"], "Perception");
}

TEST(Problems, AreFoundOnTheirPage) {
  const auto model = model_of("assemblage A() {\n  cooperate {\n    1: Noise(persistence = 3 m);\n  }\n}\n");
  model->check();
  ASSERT_FALSE(model->problems().items().empty());
  const Problem problem = problem_of(model->problems().items().front(), *model, context());
  EXPECT_EQ(problem.page(), "A");
  EXPECT_EQ(problem.node(), "Noise");
  EXPECT_EQ(problem.port(), "persistence");
}

TEST(Problems, OfAnotherFileStandAtNothingThatIsDrawnHere) {
  const std::string text = "assemblage A() {\n  Noise();\n}\n";
  const auto model = model_of(text);
  const auto at = static_cast<std::uint32_t>(text.find("Noise"));
  text::Diagnostic wrong;
  wrong.place = {model->source(), {at, at + 5}};
  EXPECT_EQ(problem_of(wrong, *model, context()).node(), "Noise");
  wrong.place.source = std::make_shared<const text::Source>("skills.cdl", text);
  const Problem elsewhere = problem_of(wrong, *model, context());
  EXPECT_EQ(elsewhere.diagnostic().document(), "library:skills.cdl");
  EXPECT_EQ(elsewhere.diagnostic().line(), 2U);
  EXPECT_EQ(elsewhere.page() + elsewhere.node(), "");
}

}  // namespace
}  // namespace mlab::designer
