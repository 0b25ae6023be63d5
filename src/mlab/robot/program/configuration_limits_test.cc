// Large, deep and endless configurations.

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/lang/cdl/emit_cnl.h"
#include "mlab/robot/program/configuration_file.h"

namespace mlab::robot {
namespace {

std::optional<ConfiguredRobot> configured(const std::string& text, text::Diagnostics& sink) {
  return configure(std::make_shared<const text::Source>("a.cdl", text), "", "R", {}, {}, sink);
}

std::string robot_of(const std::string& assemblage) {
  return fmt::format("robot R {{ wheels = Drive(v = {}()); }}\n", assemblage);
}

// A chain of assemblages, each a little more than the one inside of it.
std::string chain(int depth) {
  std::string text =
      "assemblage A0() { cooperate { Noise(persistence = 5 s); 0.5: MoveForward(amount = 1); } }\n";
  for (int i = 1; i < depth; ++i)
    text += fmt::format("assemblage A{}() {{ cooperate {{ 0.9: A{}(); 0.01: Noise(); }} }}\n", i, i - 1);
  return text + robot_of(fmt::format("A{}", depth - 1));
}

TEST(ALargeConfiguration, MayBeAHundredAssemblagesDeep) {
  text::Diagnostics sink;
  const auto robot = configured(chain(100), sink);
  ASSERT_TRUE(robot) << text::render(sink);
  EXPECT_TRUE(sink.items().empty()) << text::render(sink);
  EXPECT_EQ(robot->lowered.network.nodes.size(), 2U + 1U + 2U * 99U + 1U);
  percept::Percepts percepts;
  percept::Action action;
  flow::Frame frame = robot->built.program->make_frame();
  robot->built.program->step(frame.data(), percepts, action, 1, 1);
  EXPECT_TRUE(action.drives);
  EXPECT_GT(std::hypot(action.velocity.x, action.velocity.y), 0.0);
}

TEST(ALargeConfiguration, MayHaveTenThousandNodes) {
  std::string text = "assemblage Ten() { cooperate {";
  for (int i = 0; i < 9; ++i) text += fmt::format(" 0.{}: Noise(persistence = {} s);", i + 1, i + 1);
  text += " } }\nassemblage Hundred() { cooperate {";
  for (int i = 0; i < 10; ++i) text += " Ten();";
  text += " } }\nassemblage All() { cooperate {";
  for (int i = 0; i < 100; ++i) text += " Hundred();";
  text += " } }\n" + robot_of("All");
  text::Diagnostics sink;
  const auto robot = configured(text, sink);
  ASSERT_TRUE(robot) << text::render(sink);
  EXPECT_EQ(robot->lowered.network.nodes.size(), 100U * (10U * 10U + 1U) + 2U);
  percept::Percepts percepts;
  percept::Action action;
  flow::Frame frame = robot->built.program->make_frame();
  robot->built.program->step(frame.data(), percepts, action, 1, 1);
  EXPECT_TRUE(action.drives);
}

// Minutes, if each name or place were looked for among all others.
TEST(ALargeConfiguration, MayHaveThousandsOfFormulasThatReadEachOther) {
  std::string text = "assemblage A(near: length = 1 m) {\n  let x0 = near;\n";
  for (int i = 1; i <= 6000; ++i)
    text += fmt::format("  let x{} = {};\n", i, i % 200 == 0 ? "near" : fmt::format("x{} + 1 m", i - 1));
  text += "  cooperate { x5999 / 1 m: Stand(); }\n}\n";
  text += "robot R(near: length = 1 m) { wheels = Drive(v = A(near)); }\n";
  text::Diagnostics sink;
  const auto robot = configured(text, sink);
  ASSERT_TRUE(robot) << text::render(sink);
  EXPECT_GT(robot->lowered.network.nodes.size(), 199U);
}

TEST(ALargeConfiguration, MayHaveThousandsOfPlacesWhoseNamesAreAlike) {
  std::string text = "assemblage A() { cooperate {\n";
  for (int i = 0; i < 4096; ++i) {
    std::string name;
    for (int bit = 0; bit < 12; ++bit) name += (i >> bit & 1) != 0 ? '-' : ' ';
    text += fmt::format("  MoveToGoal(DetectGoal(place(\"{}\")));\n", "P" + name);
  }
  text += "} }\n" + robot_of("A");
  text::Diagnostics sink;
  const auto robot = configured(text, sink);
  ASSERT_TRUE(robot) << text::render(sink);
  ASSERT_EQ(robot->lowered.network.parameters.size(), 4096U);
  EXPECT_EQ(robot->lowered.network.parameters.back().name, "place_P_____________4096");
}

TEST(ALargeConfiguration, ThatGrowsWithoutEndIsRefused) {
  std::string text = "assemblage A0() { cooperate { Noise(); Noise(); } }\n";
  for (int i = 1; i < 40; ++i)
    text += fmt::format("assemblage A{0}() {{ cooperate {{ A{1}(); A{1}(); }} }}\n", i, i - 1);
  text::Diagnostics sink;
  EXPECT_FALSE(configured(text + robot_of("A39"), sink));
  ASSERT_FALSE(sink.items().empty());
  EXPECT_EQ(sink.items()[0].kind, "too-many-nodes");
}

TEST(ALargeConfiguration, ThatIsTooDeepIsRefusedWithoutRunningOutOfStack) {
  text::Diagnostics sink;
  EXPECT_FALSE(configured(chain(20'000), sink));
  ASSERT_FALSE(sink.items().empty());
  EXPECT_EQ(sink.items()[0].kind, "nested-too-deep");
}

TEST(ALargeConfiguration, UsesFilesOnlySoDeep) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(testing::TempDir()) / "mlab_use_too_deep";
  fs::create_directories(folder);
  for (int i = 0; i < 80; ++i)
    std::ofstream(folder / fmt::format("f{}.cdl", i)) << fmt::format("use \"f{}.cdl\";\n", i + 1);
  std::ofstream(folder / "f80.cdl") << "robot R { wheels = Drive(v = Noise()); }\n";
  text::Diagnostics sink;
  EXPECT_FALSE(load_configuration("f0.cdl", "r", {}, {{}, folder.string()}, sink));
  ASSERT_FALSE(sink.items().empty());
  EXPECT_EQ(sink.items()[0].kind, "use-too-deep");
  fs::remove_all(folder);
}

}  // namespace
}  // namespace mlab::robot
