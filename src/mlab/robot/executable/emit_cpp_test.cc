#include "mlab/robot/executable/emit_cpp.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "mlab/robot/executable/testing/any_network.h"

namespace mlab::robot_build {
namespace {

flow::Source constant(std::string text) {
  return {flow::Source::Kind::kConstant, std::move(text), {}};
}
flow::Source from(std::string name) {
  return {flow::Source::Kind::kName, std::move(name), {}};
}

RobotSource walker() {
  RobotSource robot;
  robot.name = "walker";
  robot.origin = "walker.cdl";
  robot.version = "1.2";
  robot.body = {{"radius", 0.35}};
  flow::Parameter pace;
  pace.name = "pace";
  pace.type = "double";
  pace.unit = "m/s";
  pace.help = "how fast";
  pace.initial = constant("1");
  pace.min = 0.0;
  pace.max = 2.5;
  robot.network.parameters = {pace};
  const auto add = [&](const char* name, const char* behavior, std::vector<flow::Link> links) -> flow::Node& {
    flow::Node& node = robot.network.nodes.emplace_back();
    node.name = name;
    node.behavior = behavior;
    node.links = std::move(links);
    return node;
  };
  add("Walk.noise", "Noise", {{"persistence", constant("10"), {}}});
  add("Walk.late", "Wait", {{"delay", constant("5"), {}}});
  add("Stand.still", "NoOperation", {});
  flow::Node& movement = add("movement", "Vector", {});
  movement.kind = flow::Node::Kind::kSequence;
  movement.states.push_back(
      {"Walking", from("Walk.noise"), {{from("Walk.late"), false, "Standing", false, {}}}, true, false, {}});
  movement.states.push_back({"Standing", from("Stand.still"), {}, false, true, {}});
  add("wheels", "Drive", {{"v", from("movement"), {}}, {"base_velocity", from("pace"), {}}}).is_public = true;
  return robot;
}

TEST(EmitCpp, WritesAFileForEachPartThatAPersonCanRead) {
  const std::vector<CppFile> files = emit_cpp(walker());
  ASSERT_EQ(files.size(), 4U);
  EXPECT_EQ(files[0].name, "main");
  EXPECT_EQ(files[0].text, R"(// The robot program walker. Made by mlab build; changes belong into walker.cdl.
#include "mlab/robot/process/robot_main.h"

std::span<const mlab::flow::Behavior* const> mlab_library_behaviors();
extern const std::uint64_t robot_source_nodes_Walk;
extern const std::uint64_t robot_source_nodes_Stand;
extern const std::uint64_t robot_source_nodes_top;

namespace robot_program {

using namespace mlab::robot_process;

void add_Walk(Wiring& w);
void add_Stand(Wiring& w);
void add_top(Wiring& w);

static void add_parameters(Wiring& w) {
  w.parameter("pace", "double", "m/s", constant("1"), {0, 2.5},
              "how fast", {});
}

}  // namespace robot_program

int main(int argc, char** argv) {
  using namespace robot_program;
  return robot_main(
      argc, argv,
      {
          .name = "walker",
          .version = "1.2",
          .parameters = add_parameters,
          .groups = {add_Walk,
                add_Stand,
                add_top},
          .order = {{0, 2}, {1, 1}, {2, 2}},
          .components = mlab_library_behaviors,
          .brought = {},
          .declarations = {},
          .is_closed = false,
          .body = {{"radius", 0.35}},
          .sources = {0x9c818f110b4615df, robot_source_nodes_Walk, robot_source_nodes_Stand, robot_source_nodes_top},
          .agent = "",
      });
}
)");
  EXPECT_EQ(files[3].name, "nodes_top");
  EXPECT_EQ(
      files[3].text,
      R"(// The nodes at the top of the robot program walker. Made by mlab build; changes belong into walker.cdl.
#include "mlab/robot/process/wiring.h"

namespace robot_program {

using namespace mlab::robot_process;

void add_top(Wiring& w);

void add_top(Wiring& w) {
  w.sequence("movement", "Vector")
      .state("Walking", from("Walk.noise")).start()
          .when(from("Walk.late"), "Standing")
      .state("Standing", from("Stand.still")).final();
  w.behavior("wheels", "Drive")
      .input("v", from("movement"))
      .input("base_velocity", from("pace"))
      .watched();
}

}  // namespace robot_program

extern const std::uint64_t robot_source_nodes_top;
const std::uint64_t robot_source_nodes_top = 0xb34e1f2696911ee0;
)");
}

TEST(EmitCpp, ChangesNoTextButThatOfTheChangedPart) {
  const RobotSource before = walker();
  RobotSource after = before;
  after.network.nodes[0].links[0].source.text = "12";
  const std::vector<CppFile> old_files = emit_cpp(before);
  const std::vector<CppFile> new_files = emit_cpp(after);
  ASSERT_EQ(old_files.size(), new_files.size());
  for (std::size_t i = 0; i < old_files.size(); ++i)
    EXPECT_EQ(old_files[i].text != new_files[i].text, old_files[i].name == "nodes_Walk");
}

TEST(EmitCpp, KeepsTheNumberOfFilesBoundedHoweverManyPartsThereAre) {
  RobotSource robot;
  robot.name = "wide";
  for (int i = 0; i < 10'000; ++i) {
    flow::Node& node = robot.network.nodes.emplace_back();
    node.name = "n" + std::to_string(i % 100) + ".m" + std::to_string(i % 7) + ".x" + std::to_string(i);
    node.behavior = "Noise";
  }
  const std::vector<CppFile> files = emit_cpp(robot);
  EXPECT_LE(files.size(), 70U);
  std::size_t longest = 0;
  for (const CppFile& file : files) longest = std::max(longest, file.text.size());
  EXPECT_LT(longest, 300U * 200U);
}

TEST(EmitCpp, GivesEachFileANameOfItsOwn) {
  RobotSource robot;
  robot.name = "alike";
  for (const char* name : {"a.b.x", "a_b.x", "a-b.x", "top.x", "x"}) {
    robot.network.nodes.emplace_back().name = name;
    robot.network.nodes.back().behavior = "Noise";
  }
  std::vector<std::string> names;
  for (const CppFile& file : emit_cpp(robot)) names.push_back(file.name);
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

}  // namespace
}  // namespace mlab::robot_build
