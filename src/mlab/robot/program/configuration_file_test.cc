#include "mlab/robot/program/configuration_file.h"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/cdl/print/format.h"
#include "mlab/robot/program/robot_program.h"

namespace mlab::robot {
namespace {

namespace fs = std::filesystem;

/// A folder of files that is gone with the test.
class Folder {
 public:
  Folder() { fs::create_directories(path_); }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  void write(const std::string& name, const std::string& text) const { std::ofstream(path_ / name) << text; }
  ProgramSources sources() const { return {{}, path_.string()}; }

 private:
  fs::path path_ = fs::path(testing::TempDir()) /
                   (std::string("mlab_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

constexpr const char* kWanderer = R"(
assemblage Wander(curious: gain = 0.8) {
  cooperate {
    curious: Noise(persistence = 10 s);
    1.5: AvoidStaticObstacles(readings = sense_obstacles(range = 200 cm), sphere = 1 m, safety_margin = 0.5 m);
  }
}
class Cart { 
  body { radius = 35 cm; }
  sensor bumper: DetectObstacles() binds sense_obstacles;
  actuator wheels: Drive(max_velocity = 1 m/s) binds movement;
}
robot Wanderer(pace: gain = 2 in 0 .. 10) is Cart { movement = Wander(curious = pace); }
)";

std::optional<RobotProgram> load(const Folder& folder, const std::string& name, const std::string& type,
                                 text::Diagnostics& sink, const std::vector<Setting>& settings = {}) {
  return load_program(name, {}, settings, folder.sources(), {}, sink, nullptr, type);
}

TEST(LoadConfiguration, BuildsTheRobotOfAFile) {
  const Folder folder;
  folder.write("wanderer.cdl", kWanderer);
  text::Diagnostics sink;
  const auto robot = load(folder, "wanderer.cdl", "anything", sink, {{"pace", "3", {}, {}}});
  ASSERT_TRUE(robot) << text::render(sink);
  EXPECT_TRUE(sink.items().empty()) << text::render(sink);
  EXPECT_DOUBLE_EQ(robot->body.at("radius"), 0.35);
  const auto value = [&](const char* path) {
    const flow::Port* port = robot->program->find(path);
    return port == nullptr ? -1.0 : flow::Program::number(robot->initial.data(), *port).value_or(-1.0);
  };
  EXPECT_DOUBLE_EQ(value("pace"), 3.0);
  EXPECT_DOUBLE_EQ(value("movement.Noise.persistence"), 10.0);
  EXPECT_DOUBLE_EQ(value("movement.AvoidStaticObstacles.sense_obstacles.range"), 2.0);
  EXPECT_DOUBLE_EQ(value("wheels.max_velocity"), 1.0);
  percept::Percepts percepts;
  percept::Action action;
  flow::Frame frame = robot->initial;
  robot->program->step(frame.data(), percepts, action, 1, 1);
  EXPECT_TRUE(action.drives);
  EXPECT_NEAR(std::hypot(action.velocity.x, action.velocity.y), 0.3, 1e-12) << "base velocity times pace";
}

constexpr const char* kSocieties = R"(
robot Other is Cart { movement = Wander(); }
robot Both is Cart { movement = Wander(); }
society Pair: caste { Other; Wanderer; };
society Troop: caste { team of 3 Wanderer; team of 2 Pair; Other; };
society Nobody: caste { };
society Circle: caste { Wanderer; Circle; };
society Both: team of 2 Other;
)";

// `Wanderer 3, Other 2`; `-` where it names no society.
std::string members(const Folder& folder, const std::string& program, text::Diagnostics& sink) {
  const auto read = society_reader(folder.sources())(program, {}, sink);
  if (!read) return "-";
  std::string out;
  for (const auto& [robot, count] : *read) {
    EXPECT_TRUE(robot.starts_with("many.cdl#"));
    out += (out.empty() ? "" : ", ") + robot.substr(9) + " " + std::to_string(count);
  }
  return out;
}

TEST(SocietyReader, CountsTheRobotsOfSocietiesInSocieties) {
  const Folder folder;
  folder.write("many.cdl", std::string(kWanderer) + kSocieties);
  text::Diagnostics sink;
  EXPECT_EQ(members(folder, "many.cdl#Pair", sink), "Other 1, Wanderer 1");
  EXPECT_EQ(members(folder, "many.cdl#Troop", sink), "Wanderer 3, Other 2, Wanderer 2, Other 1");
  EXPECT_EQ(members(folder, "many.cdl#Nobody", sink), "");
  EXPECT_EQ(members(folder, "many.cdl#Circle", sink), "Wanderer 1");
  EXPECT_EQ(members(folder, "many.cdl#Other", sink), "-") << "a robot";
  EXPECT_EQ(members(folder, "many.cdl", sink), "-");
  EXPECT_EQ(members(folder, "robot", sink), "-");
  EXPECT_TRUE(sink.items().empty()) << text::render(sink);
}

TEST(SocietyReader, SaysWhatItCannotFindOrTell) {
  const Folder folder;
  folder.write("many.cdl", std::string(kWanderer) + kSocieties);
  text::Diagnostics sink;
  EXPECT_EQ(members(folder, "many.cdl#Both", sink), "-");
  ASSERT_EQ(sink.warning_count(), 1U);
  EXPECT_TRUE(sink.items()[0].message.ends_with("a robot and a society `Both`: the robot is meant"));
  EXPECT_EQ(members(folder, "many.cdl#Trop", sink), "-");
  ASSERT_EQ(sink.error_count(), 1U);
  EXPECT_TRUE(sink.items()[1].message.ends_with("has no robot or society `Trop`"));
  EXPECT_EQ(sink.items()[1].hints, (std::vector<std::string>{"did you mean `Troop`?"}));
  EXPECT_EQ(members(folder, "nosuch.cdl#Pair", sink), "-");
  EXPECT_EQ(sink.error_count(), 2U);
}

TEST(SocietyReader, RefusesSocietiesOfMoreRobotsThanThereMayBe) {
  std::string text =
      "class C { actuator wheels: Drive() binds movement; }\nrobot R is C { movement = Noise(); }\n"
      "society Teams: team of 101 Hundred;\nsociety Hundred: team of 100 R;\n"
      "society Vast: team of 10000 Large;\nsociety Large: team of 10000 R;\n"
      "society Most: team of 100 Hundred;\n";
  for (int i = 0; i < 60; ++i) text += fmt::format("society D{}: caste {{ D{}; D{}; }};\n", i, i + 1, i + 1);
  text += "society D60: team of 1 R;\n";
  for (int i = 0; i < 2000; ++i) text += fmt::format("society L{}: team of 1 L{};\n", i, i + 1);
  text += "society L2000: team of 1 R;\n";
  std::ofstream(fs::path(testing::TempDir()) / "many.cdl") << text;
  ProgramSources sources;
  sources.folder = testing::TempDir();
  const SocietyReader read = society_reader(sources);
  for (const char* name : {"Teams", "Vast", "D0", "L0"}) {
    text::Diagnostics sink;
    EXPECT_FALSE(read(std::string("many.cdl#") + name, {}, sink)) << name;
    ASSERT_EQ(sink.error_count(), 1U) << name;
    EXPECT_EQ(sink.items()[0].kind, "too-many-robots");
  }
  text::Diagnostics sink;
  const auto most = read("many.cdl#Most", {}, sink);
  ASSERT_TRUE(most) << text::render(sink);
  EXPECT_EQ(most->at(0).second, 10'000);
}

TEST(LoadConfiguration, SaysThatASocietyIsNoRobot) {
  const Folder folder;
  folder.write("many.cdl", std::string(kWanderer) + kSocieties);
  text::Diagnostics sink;
  EXPECT_FALSE(load(folder, "many.cdl#Troop", "x", sink));
  ASSERT_EQ(sink.error_count(), 1U);
  EXPECT_EQ(sink.items()[0].hints,
            (std::vector<std::string>{"`Troop` is a society: name one of its robots"}));
}

TEST(LoadConfiguration, TakesTheRobotThatIsNamed) {
  const Folder folder;
  folder.write("two.cdl", std::string(kWanderer) + "robot Other is Cart { movement = Wander(); }\n");
  text::Diagnostics sink;
  EXPECT_TRUE(load(folder, "two.cdl#Other", "x", sink)) << text::render(sink);
  EXPECT_TRUE(load(folder, "two.cdl", "OTHER", sink)) << text::render(sink);
  EXPECT_TRUE(sink.items().empty()) << text::render(sink);
  EXPECT_FALSE(load(folder, "two.cdl", "x", sink));
  ASSERT_EQ(sink.items().size(), 1U);
  EXPECT_EQ(sink.items()[0].kind, "several-robots");
  EXPECT_EQ(sink.items()[0].hints, (std::vector<std::string>{"name one: `two.cdl#Wanderer`"}));
  EXPECT_FALSE(load(folder, "two.cdl#Othr", "x", sink));
  EXPECT_EQ(sink.items()[1].hints, (std::vector<std::string>{"did you mean `Other`?"}));
  folder.write("none.cdl", "assemblage A() { Noise() }\n");
  EXPECT_FALSE(load(folder, "none.cdl", "x", sink));
  EXPECT_EQ(sink.items()[2].kind, "no-robot");
}

TEST(LoadConfiguration, UsesOtherFilesOnce) {
  const Folder folder;
  folder.write("wanderer.cdl", kWanderer);
  folder.write("b.cdl",
               "use \"wanderer.cdl\";\nuse \"wanderer.cdl\";\nrobot B is Cart { movement = Wander(); }\n");
  text::Diagnostics sink;
  EXPECT_TRUE(load(folder, "b.cdl", "b", sink)) << text::render(sink);
  folder.write("c.cdl", "use \"c.cdl\";\nuse \"none.cdl\";\n");
  EXPECT_FALSE(load(folder, "c.cdl", "c", sink));
  ASSERT_EQ(sink.items().size(), 2U);
  EXPECT_EQ(sink.items()[0].kind, "use-cycle");
  EXPECT_EQ(sink.items()[1].kind, "cannot-read");
}

TEST(LoadConfiguration, LetsADevicesOwnArgumentsHold) {
  const Folder folder;
  std::string text = kWanderer;
  text.replace(text.find("DetectObstacles()"), 17, "DetectObstacles(range = 1 m)");
  folder.write("wanderer.cdl", text);
  text::Diagnostics sink;
  const auto robot = load(folder, "wanderer.cdl", "w", sink);
  ASSERT_TRUE(robot) << text::render(sink);
  const flow::Port* range = robot->program->find("movement.AvoidStaticObstacles.sense_obstacles.range");
  EXPECT_DOUBLE_EQ(flow::Program::number(robot->initial.data(), *range).value_or(0.0), 1.0);
}

TEST(LoadConfiguration, KeepsTheFirstValueWherePureCallsAreShared) {
  text::Diagnostics sink;
  const auto source = std::make_shared<const text::Source>(
      "x.cdl",
      "class Cart { actuator wheels: Drive() binds movement; }\n"
      "robot R(first: gain = 2.5) is Cart { movement = sequence {\n"
      "  start A: Stand(); when Wait(delay = 1 s) goto B;\n"
      "  B: Stand(); when Wait(delay = 1 s) goto C;\n"
      "  final C: cooperate { first: Stand(); first: MoveForward(); }; }; }\n");
  const auto robot = configure(source, "", "", {}, {}, sink);
  ASSERT_TRUE(robot) << text::render(sink);
  EXPECT_EQ(flow::Program::print(robot->built.program->initial_frame().data(),
                                 *robot->built.program->find("first")),
            "2.5");
}

TEST(TheExamplesOfTheManual, AreRightAndInTheCanonicalLayout) {
  const fs::path folder = fs::path(base::source_folder()) / "src/mlab/lang/cdl/testdata/examples";
  int count = 0;
  for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
    const auto source = text::read_source(file.path().string());
    ASSERT_TRUE(source);
    text::Diagnostics sink;
    check_configuration(*source, {}, sink);
    EXPECT_TRUE(sink.items().empty()) << text::render(sink);
    EXPECT_EQ(cdl::format(*source, sink).value_or(""), (*source)->text()) << file.path();
    ++count;
  }
  EXPECT_EQ(count, 5);
}

TEST(TheExamplesOfTheManual, BuildWithTheOperatorsOfTheirSociety) {
  text::Diagnostics sink;
  const ProgramSources sources = {{}, base::source_folder() + "/src/mlab/lang/cdl/testdata/examples"};
  const auto fetcher = load_configuration("robots.cdl#Fetcher", "", {}, sources, sink);
  const auto watcher = load_configuration("robots.cdl", "watcher", {}, sources, sink);
  ASSERT_TRUE(fetcher && watcher) << text::render(sink);
  const flow::Port* range =
      fetcher->built.program->find("movement.wanted.MoveToGoal.ObjectLocation.NextThing.seen.range");
  ASSERT_NE(range, nullptr);
  EXPECT_EQ(flow::Program::print(fetcher->built.program->initial_frame().data(), *range), "60")
      << "of the operator";
  EXPECT_TRUE(fetcher->built.program->find("inertia") != nullptr &&
              fetcher->built.program->find("top") != nullptr);
  EXPECT_DOUBLE_EQ(watcher->lowered.body.at("radius"), 0.35);
}

}  // namespace
}  // namespace mlab::robot
