#include "mlab/robot/program/robot_program.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include <fmt/core.h>
#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"

namespace mlab::robot {
namespace {

namespace fs = std::filesystem;

std::optional<RobotProgram> load(const std::string& name, const std::vector<Setting>& settings,
                                 text::Diagnostics& sink, const ProgramSources& sources = {}) {
  return load_program(name, {}, settings, sources, {"robot_type"}, sink);
}

double parameter(const RobotProgram& robot, const char* name) {
  return flow::Program::number(robot.initial.data(), *robot.program->find(name)).value_or(-1.0);
}

TEST(LoadProgram, KnowsTheStandardRobotByItsHistoricNames) {
  for (const char* name : {"robot", "mlab-2.0-robot", "../bin/tmr_robot-1998"}) {
    text::Diagnostics sink;
    const auto robot = load(name, {}, sink);
    ASSERT_TRUE(robot) << text::render(sink);
    EXPECT_TRUE(robot->program);
    EXPECT_TRUE(sink.items().empty()) << text::render(sink);
  }
}

TEST(LoadProgram, SetsParametersAndLeavesTheOthersAtTheirDefaults) {
  text::Diagnostics sink;
  const auto robot = load("robot", {{"base_velocity", "0.1", {}, {}}, {"robot_type", "MRV2", {}, {}}}, sink);
  ASSERT_TRUE(robot);
  EXPECT_DOUBLE_EQ(parameter(*robot, "base_velocity"), 0.1);
  EXPECT_DOUBLE_EQ(parameter(*robot, "max_velocity"), 7.0);
  EXPECT_TRUE(sink.items().empty()) << "the vehicle's keys are not the program's business";
}

TEST(LoadProgram, WarnsAboutAnUnknownParameterWithTheNearestName) {
  text::Diagnostics sink;
  const auto robot = load("robot", {{"base_velocty", "0.1", {}, {}}}, sink);
  ASSERT_TRUE(robot);
  ASSERT_EQ(sink.warning_count(), 1U);
  EXPECT_EQ(sink.items()[0].hints, (std::vector<std::string>{"did you mean `base_velocity`?"}));
}

TEST(LoadProgram, RefusesAValueThatAParameterCannotTake) {
  text::Diagnostics sink;
  EXPECT_FALSE(load("robot", {{"base_velocity", "fast", {}, {}}}, sink));
  EXPECT_FALSE(load("robot", {{"base_velocity", "-3", {}, {}}}, sink));
  EXPECT_EQ(sink.error_count(), 2U);
}

TEST(LoadProgram, ParksARobotWhoseProgramNobodyKnows) {
  text::Diagnostics sink;
  const auto robot = load("./forager", {}, sink);
  ASSERT_TRUE(robot);
  EXPECT_FALSE(robot->program);
  EXPECT_EQ(sink.warning_count(), 1U);
  EXPECT_EQ(sink.error_count(), 0U);
}

TEST(LoadProgram, BuildsANetworkFromAFileBesideTheMission) {
  const fs::path folder = fs::path(testing::TempDir()) / "mlab_robot_program_test";
  fs::create_directories(folder);
  std::ofstream(folder / "runner.cnl")
      << "parameter double pace = 1;\nnode ahead is MoveForward with amount = pace; nend\n"
         "node wheels is Drive with v = ahead; nend\n";
  text::Diagnostics sink;
  const auto robot = load("runner.cnl", {{"pace", "2", {}, {}}}, sink, {{}, folder.string()});
  ASSERT_TRUE(robot) << text::render(sink);
  EXPECT_DOUBLE_EQ(parameter(*robot, "pace"), 2.0);
  EXPECT_FALSE(load("missing.cnl", {}, sink, {{}, folder.string()}));
  fs::remove_all(folder);
}

constexpr const char* kWithCode =
    "procedure Vector Gain with\nheader\nbody\n  output = {1, 0, 0};\npend\n"
    "node ahead is Gain with nend\nnode wheels is Drive with v = ahead; nend\n";

/// A project beside a program that is none of it.
class ProjectTest : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "project" / "missions");
    std::ofstream(folder_ / "evil.cnl") << kRunner;
    std::ofstream(folder_ / "evil") << "#!/bin/sh\n";
    fs::permissions(folder_ / "evil", fs::perms::owner_all);
    std::ofstream(folder_ / "project" / "mine.cnl") << kRunner;
    fs::create_symlink(folder_ / "evil.cnl", folder_ / "project" / "missions" / "link.cnl");
    std::ofstream(folder_ / "project" / "missions" / "uses.cdl")
        << "use \"../../evil.cnl\";\nrobot R { wheels = Drive(v = Noise()); }\n";
  }
  void TearDown() override { fs::remove_all(folder_); }

  ProgramSources sources() const {
    ProgramSources out;
    out.permission = cell::testing::all_permitted();
    out.folder = (folder_ / "project" / "missions").string();
    out.project = (folder_ / "project").string();
    return out;
  }

  static constexpr const char* kRunner =
      "node ahead is MoveForward with amount = 1; nend\nnode wheels is Drive with v = ahead; nend\n";
  const fs::path folder_ = fs::path(testing::TempDir()) / fmt::format("mlab_robot_project_test_{}", getpid());
};

TEST_F(ProjectTest, ProgramsComeFromTheProjectByWhateverName) {
  for (const std::string& name :
       {(folder_ / "evil.cnl").string(), std::string("../../evil.cnl"), std::string("link.cnl"),
        std::string("../../evil"), std::string("uses.cdl")}) {
    text::Diagnostics sink;
    EXPECT_FALSE(load(name, {}, sink, sources())) << name;
    ASSERT_FALSE(sink.items().empty()) << name;
    EXPECT_EQ(sink.items()[0].kind, "outside-project") << text::render(sink);
  }
  text::Diagnostics sink;
  EXPECT_TRUE(load("../mine.cnl", {}, sink, sources())) << text::render(sink);
  ProgramSources anywhere = sources();
  anywhere.project.clear();
  EXPECT_TRUE(load("link.cnl", {}, sink, anywhere)) << "without a project it is loaded: the twin";
}

TEST_F(ProjectTest, CodeThatNobodyAllowedIsNotCompiled) {
  std::ofstream(folder_ / "project" / "missions" / "code.cnl") << kWithCode;
  ProgramSources ours = sources();
  ours.include_root = base::source_folder() + "/src";
  ours.permission = cell::Permission();
  text::Diagnostics sink;
  const auto robot = load("code.cnl", {}, sink, ours);
  ASSERT_TRUE(robot);
  EXPECT_TRUE(robot->is_described_only) << "nothing runs it";
  EXPECT_FALSE(robot->hosted);
  ASSERT_FALSE(sink.items().empty());
  EXPECT_EQ(sink.items()[0].kind, "code-not-allowed") << text::render(sink);

  // Who runs robots for people elsewhere.
  ours.permission = cell::Permission::decide({.purpose = cell::Grounds::Purpose::kRun,
                                              .people = cell::Grounds::People::kElsewhere,
                                              .allows_native = false,
                                              .without_cell = false,
                                              .is_trusted = true,
                                              .known = nullptr},
                                             cell::means());
  sink = {};
  EXPECT_FALSE(load("code.cnl", {}, sink, ours));
  ASSERT_TRUE(sink.has_errors());
  EXPECT_EQ(sink.items()[0].kind, "code-not-allowed") << text::render(sink);
}

}  // namespace
}  // namespace mlab::robot
