#include "mlab/robot/executable/executable.h"
#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/cell/testing/permission.h"
#include "mlab/flow/module_file.h"
#include "mlab/lang/cnl/native_module.h"
#include "mlab/robot/executable/testing/any_network.h"
#include "mlab/robot/host/testing/without_cell.h"
#include "mlab/robot/program/network_file.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/robot/wire/action_wire.h"
#include "mlab/robot/wire/percepts_wire.h"
#include "mlab/robot/wire/testing/same_bits.h"

namespace mlab::robot_build {
namespace {

namespace fs = std::filesystem;

class ExecutableTest : public ::testing::Test {
 protected:
  ExecutableTest() {
    fs::create_directories(folder_);
    toolchain_.include_root = base::source_folder() + "/src";
    toolchain_.link_file = MLAB_LINK_FILE;
    toolchain_.cache_folder = (folder_ / "cache").string();
    toolchain_.version = "test";
  }
  ~ExecutableTest() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  static RobotSource source_of(flow::Network network) {
    RobotSource out;
    out.name = "any";
    out.origin = "any.cnl";
    out.version = "test";
    out.network = std::move(network);
    return out;
  }
  RobotSource source_of_text(const std::string& cnl) {
    const fs::path path = folder_ / "robot.cnl";
    std::ofstream(path) << cnl;
    text::Diagnostics sink;
    const auto read = robot::read_network(
        path.string(), {},
        {cell::testing::check_permitted(), "", toolchain_.include_root, toolchain_.version}, sink);
    EXPECT_TRUE(read) << text::render(sink);
    if (!read) return {};
    RobotSource out = source_of(read->network);
    out.procedures = {read->tree};
    return out;
  }
  std::optional<BuildReport> build(const RobotSource& robot) {
    sink_ = {};
    return build_executable(emit_cpp(robot), program_, toolchain_, cell::testing::all_permitted(), sink_);
  }

  fs::path folder_ = fs::path(::testing::TempDir()) / ("mlab_executable_test_" + std::to_string(::getpid()));
  std::string program_ = (folder_ / "robot").string();
  Toolchain toolchain_;
  text::Diagnostics sink_;
};

// A robot that comes past obstacles and objects, and now and then turns.
struct Walk {
  std::vector<percept::Obstacle> obstacles;
  std::vector<percept::ObjectReading> objects;
  percept::Percepts percepts;

  explicit Walk(int cycle) {
    const double at = 0.13 * cycle;
    obstacles = {{{6.0 - at, 1.0, 0.0}, 0.5}, {{13.0 - at, -0.3, 0.0}, 1.0}};
    for (int i = 0; i < cycle / 7 % 4; ++i)
      objects.push_back({{static_cast<std::uint32_t>(i + 1)},
                         percept::ObjectClass::kFlag,
                         percept::ObjectStyle::kMovable,
                         {5.0 + i, 1.0, 0.0},
                         0.1});
    percepts.pose = {{at, 0.01 * cycle}, 0.1 * std::floor(cycle / 10.0)};
    percepts.time = 0.1 * cycle;
    percepts.obstacles = obstacles;
    percepts.objects = objects;
  }
};

// Runs both for a while; empty where all actions and all ports agree, bit for bit.
std::string first_difference(const flow::Program& program, const std::string& executable, int cycles) {
  auto process =
      robot_host::RobotProgramProcess::start(robot_host::testing::without_cell(executable), {60.0, 60.0});
  if (!process) return process.error();
  wire::ToRobot message;
  message.mutable_start()->set_robot(3);
  message.mutable_start()->set_seed(11);
  if (process->ask(message, wire::FromRobot::kReady) == nullptr) return process->failure();
  flow::Frame frame = program.make_frame();
  for (int cycle = 0; cycle < cycles; ++cycle) {
    const Walk walk(cycle);
    percept::Action here;
    program.step(frame.data(), walk.percepts, here, 11, 3);
    wire::RobotCycle& part = *message.mutable_cycle()->add_robots();
    part.set_robot(3);
    robot_wire::encode(walk.percepts, *part.mutable_percepts());
    const wire::FromRobot* answer = process->ask(message, wire::FromRobot::kActions);
    if (answer == nullptr) return process->failure();
    percept::Action there;
    if (const auto problem = robot_wire::decode(answer->actions().robots(0).action(), there)) return *problem;
    if (!robot_wire::testing::same(here, there)) return fmt::format("another action in cycle {}", cycle);
    message.mutable_read_ports()->set_robot(3);
    answer = process->ask(message, wire::FromRobot::kPortValues);
    if (answer == nullptr) return process->failure();
    for (std::size_t i = 0; i < program.ports().size(); ++i) {
      const flow::Port& port = program.ports()[i];
      const wire::PortValue& value = answer->port_values().values(static_cast<int>(i));
      const bool is_same =
          value.text() == flow::Program::print(frame.data(), port) &&
          robot_wire::testing::same(value.number(), flow::Program::number(frame.data(), port).value_or(0.0));
      if (!is_same) return fmt::format("another value of {} in cycle {}", port.path, cycle);
    }
  }
  return "";
}

// As many as MLAB_EXECUTABLES says: the longer way, `MLAB_EXECUTABLES=100 mlab_robot_build_test`.
int executables() {
  const char* text = std::getenv("MLAB_EXECUTABLES");  // NOLINT(concurrency-mt-unsafe): nobody sets it here
  return text == nullptr ? 4 : std::atoi(text);
}

TEST_F(ExecutableTest, GivesTheSameValuesAsTheProgramInMemoryBitForBit) {
  for (int number = 1; number <= executables(); ++number) {
    const flow::Network network = testing::AnyNetwork(static_cast<std::uint64_t>(number)).make();
    text::Diagnostics sink;
    const auto program = flow::build_program(network, robot::component_library(), sink);
    ASSERT_TRUE(program) << "network " << number << ":\n" << text::render(sink);
    ASSERT_TRUE(build(source_of(network))) << text::render(sink_);
    EXPECT_EQ(first_difference(*program, program_, 120), "") << "network " << number;
  }
}

TEST_F(ExecutableTest, CompilesOnlyThePartThatChanged) {
  flow::Network network = testing::AnyNetwork(1).make();
  const auto first = build(source_of(network));
  ASSERT_TRUE(first) << text::render(sink_);
  EXPECT_EQ(first->reused, 0U);
  ASSERT_GT(first->compiled.size(), 3U);
  for (flow::Node& node : network.nodes) {
    if (node.name == "obstacles") node.links[0].source.text = "12.5";
  }
  const auto second = build(source_of(network));
  ASSERT_TRUE(second);
  EXPECT_EQ(second->compiled, (std::vector<std::string>{"nodes_top"}));
  EXPECT_EQ(second->reused, first->compiled.size() - 1);
  EXPECT_TRUE(build(source_of(network))->compiled.empty());
}

constexpr const char* kOwnProcedure = R"(procedure Vector Spiral with
  double rate = 0.5;
header
  double angle = 0.0;
body
  angle += rate;
  output = {std::cos(angle), std::sin(angle), 0.0};
pend
parameter double rate = 0.25;
node spiral is Spiral with rate = rate; nend
node wheels is Drive with v = spiral; nend
)";

TEST_F(ExecutableTest, BringsProceduresOfItsOwn) {
  const RobotSource robot = source_of_text(kOwnProcedure);
  ASSERT_TRUE(build(robot)) << text::render(sink_);
  // The same code, loaded into this test.
  text::Diagnostics sink;
  cnl::NativeOptions options;
  options.include_folders = {toolchain_.include_root};
  const auto module = cnl::compile_native(*robot.procedures.front(), options, sink);
  ASSERT_TRUE(module) << text::render(sink);
  const auto behaviors = flow::open_module(module->file);
  ASSERT_TRUE(behaviors) << behaviors.error();
  flow::Library library = robot::component_library();
  library.add(*behaviors);
  const auto program = flow::build_program(robot.network, library, sink);
  ASSERT_TRUE(program) << text::render(sink);
  EXPECT_EQ(first_difference(*program, program_, 50), "");
}

TEST_F(ExecutableTest, SaysWhatIsMissingForMakingOne) {
  const RobotSource robot = source_of(testing::AnyNetwork(1).make());
  const auto kind = [&] {
    EXPECT_FALSE(build(robot));
    EXPECT_FALSE(fs::exists(program_));
    return sink_.items().empty() ? "" : sink_.items()[0].kind;
  };
  const Toolchain whole = toolchain_;
  toolchain_.compiler = "g++-that-is-not-there";
  EXPECT_EQ(kind(), "no-compiler");
  toolchain_ = whole;
  toolchain_.include_root.clear();
  EXPECT_EQ(kind(), "no-headers");
  toolchain_ = whole;
  toolchain_.link_file = (folder_ / "none.txt").string();
  EXPECT_EQ(kind(), "no-libraries");
}

}  // namespace
}  // namespace mlab::robot_build
