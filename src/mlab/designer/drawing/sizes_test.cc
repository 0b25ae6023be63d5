// The page and the server both say how large things are drawn: the page from measured letters, the server for
// making room in files that come from elsewhere. What they must agree on stands in one file: drawings of
// every kind of node and state, with their sizes. This test holds the server to it,
// web/designer/states/sizes.test.ts the page.
//
// MLAB_UPDATE_GOLDEN=1 writes the file anew.

#include "mlab/designer/drawing/sizes.h"
#include "mlab/base/testing/source_folder.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/core.h>
#include <google/protobuf/util/json_util.h>
#include <gtest/gtest.h>

#include "mlab/designer/drawing/drawing.h"
#include "mlab/robot/program/configuration_file.h"

namespace mlab::designer {
namespace {

const std::string kGolden = base::source_folder() + "/web/designer/states/testdata/sizes.golden";

constexpr const char* kUnknown = R"(assemblage NobodyKnows(number: gain = 0.5) {
  let near = not Nothing(a = 1);
  cooperate {
    number: Nothing(first = 12 m, second = near);
    NoiseOfAVeryLongNameThatDoesNotFitAnywhere();
    sequence {
      start One: Stand();
        when IsHalted() goto Two;
      final Two: Stand();
    };
  }
}

robot Doll {
  movement = NobodyKnows();
}

society Pair: team of 2 Doll;

society All: caste {
  Pair;
  team of 3 Pair;
  Doll;
};
)";

std::string content_of(const std::string& path) {
  std::ifstream in(path);
  std::stringstream out;
  out << in.rdbuf();
  return out.str();
}

std::vector<std::string> pages_of(const Model& model) {
  std::vector<std::string> out = {""};
  for (const cdl::Item& item : model.tree().items) {
    std::visit(
        [&](const auto& one) {
          if constexpr (requires { one.name.text; }) {
            const OwnerGraph* graph = model.graph(one.name.text);
            if (graph == nullptr) out.push_back(one.name.text);
            for (const GraphPage& page : graph == nullptr ? std::vector<GraphPage>() : graph->pages)
              out.push_back(page.path);
          }
        },
        item);
  }
  return out;
}

std::string json_of(const google::protobuf::Message& message) {
  std::string out;
  EXPECT_TRUE(google::protobuf::util::MessageToJsonString(message, &out).ok());
  return out;
}

struct DrawnShapes {
  std::string json;
  std::set<int> shapes;
  int states = 0;
};

void draw_all(const std::string& name, const std::string& text, DrawnShapes& out) {
  const Model model(std::make_shared<const text::Source>(name, text), robot::library_environment());
  const DrawingContext context = {"sizes.cdl", 1, false, [](std::string_view path) {
                                    return std::filesystem::path(path).filename().string();
                                  }};
  for (const std::string& page : pages_of(model)) {
    Drawing drawing = draw(model, page, context);
    std::string sizes;
    const auto add = [&](const DrawnSize& size) {
      sizes += fmt::format("{}[{}, {}]", sizes.empty() ? "" : ", ", size.width, size.height);
    };
    for (const Node& node : drawing.nodes()) {
      add(size_of(node, drawing));
      out.shapes.insert(node.shape());
    }
    for (const State& state : drawing.states()) add(size_of(state));
    out.states += drawing.states_size();
    // What has nothing to do with sizes may change without anybody having to look here.
    Drawing kept;
    *kept.mutable_page() = drawing.page();
    *kept.mutable_nodes() = drawing.nodes();
    *kept.mutable_wires() = drawing.wires();
    *kept.mutable_states() = drawing.states();
    for (Node& node : *kept.mutable_nodes()) node.clear_help();
    for (State& state : *kept.mutable_states()) state.clear_help();
    out.json += fmt::format("{}  {{\"sizes\": [{}],\n   \"drawing\": {}}}", out.json.empty() ? "" : ",\n",
                            sizes, json_of(kept));
  }
}

TEST(Sizes, AreThoseThatThePageIsHeldToAsWell) {
  DrawnShapes drawn;
  const std::string folder = base::source_folder() + "/src/mlab/lang/cdl/testdata/examples/";
  for (const char* file : {"operators.cdl", "percepts.cdl", "robots.cdl"})
    draw_all(folder + file, content_of(folder + file), drawn);
  draw_all("sizes.cdl", kUnknown, drawn);
  draw_all(folder + "formulas.cdl", content_of(folder + "formulas.cdl"), drawn);
  std::string missing;
  for (int shape = 0; shape < Node::Shape_ARRAYSIZE; ++shape) {
    if (Node::Shape_IsValid(shape) && !drawn.shapes.contains(shape))
      missing += Node::Shape_Name(static_cast<Node::Shape>(shape)) + ' ';
  }
  EXPECT_EQ(missing, "") << "shapes whose sizes nobody compares";
  EXPECT_GT(drawn.states, 2);
  const std::string json = "[\n" + drawn.json + "\n]\n";
  // NOLINTNEXTLINE(concurrency-mt-unsafe): nobody sets it here
  if (std::getenv("MLAB_UPDATE_GOLDEN") != nullptr) std::ofstream(kGolden) << json;
  EXPECT_TRUE(content_of(kGolden) == json) << "sizes or drawings have changed: MLAB_UPDATE_GOLDEN=1 writes "
                                           << kGolden << ", and the page's rules (form.ts) have to follow";
}

}  // namespace
}  // namespace mlab::designer
