// Robots with procedures of their own, in processes of their own: they do what embedded ones do, and what
// goes wrong in one is told and stops nobody else.

#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/flow/module_file.h"
#include "mlab/lang/cnl/check.h"
#include "mlab/lang/cnl/elaborate.h"
#include "mlab/lang/cnl/load.h"
#include "mlab/lang/cnl/native_module.h"
#include "mlab/robot/host/hosted_cycle.h"
#include "mlab/robot/program/network_file.h"
#include "team.h"

namespace mlab::brought_code {
namespace {

using cell::testing::check_permitted;
using cell::testing::code_permitted;
using fleet::RobotLife;

// State, random numbers, something sensed, a sequence of states, and a type of its own.
constexpr const char* kManyThings = R"(init
struct Mood { double calm = 0.25; int count = 3; };
iend
type <Mood, "{double, int}">;
procedure Mood Feel with
header
body
  output.calm += 0.001 * random.uniform();
  output.count++;
pend
procedure Vector Lead with
  Mood mood;
  double pace = 1;
header
  double turned = 0;
body
  turned += 0.05 * mood.calm;
  output = {pace * std::cos(turned), pace * std::sin(turned) + 0.01 * mood.count, 0};
  if (percepts.robots.size() > 0) output.y += 0.1;
pend
procedure bool Often with
header
  int n = 0;
body
  output = ++n % 7 == 0;
pend
parameter double pace = 1;
node feel is Feel with nend
node lead is Lead with mood = feel; pace = pace; nend
node other is Lead with mood = feel; pace = 0.5; nend
node often is Often with nend
sequence ways of Vector with
  start state One is lead; when often goto Two;
  state Two is other; when often goto One;
nend
node wheels is Drive with v = ways; nend
)";

// The same program with its code in this test: what embedded robots would do.
std::shared_ptr<const flow::Program> embedded(const Folder& folder, text::Diagnostics& sink) {
  const cnl::Tree tree = cnl::load(*text::read_source(folder.path("mine.cnl")), sink);
  cnl::check_declarations(tree, sink);
  cnl::NativeOptions options;
  options.include_folders = {base::source_folder() + "/src"};
  options.version = "test";
  const auto module = cnl::compile_native(tree, options, sink);
  if (!module) return nullptr;
  const auto behaviors = flow::open_module(module->file);
  EXPECT_TRUE(behaviors) << behaviors.error();
  if (!behaviors) return nullptr;
  flow::Library library = robot::component_library();
  library.add(*behaviors);
  return flow::build_program(cnl::elaborate(tree, sink), library, sink);
}

TEST(Hosting, DoesBitForBitWhatTheSameCodeDoesEmbedded) {
  const Folder folder;
  folder.write("mine.cnl", kManyThings);
  text::Diagnostics sink;
  const auto read = robot::read_network("mine.cnl", {}, sources_in(folder.path(), code_permitted()), sink);
  ASSERT_TRUE(read) << text::render(sink);
  ASSERT_TRUE(read->built.hosted);
  const auto program = embedded(folder, sink);
  ASSERT_TRUE(program) << text::render(sink);
  ASSERT_EQ(program->layout_hash(), read->built.program->layout_hash());

  robot_host::HostedCycle hosted(read->built.hosted, true);
  std::vector<flow::Frame> mine(3, read->built.program->make_frame());
  std::vector<flow::Frame> theirs(3, program->make_frame());
  EXPECT_EQ(mine[0], theirs[0]) << "values before the first cycle";
  const percept::RobotReading other{};
  for (int cycle = 0; cycle < 200; ++cycle) {
    percept::Percepts percepts;
    percepts.time = 0.1 * cycle;
    if (cycle % 3 == 0) percepts.robots = {&other, 1};
    hosted.begin();
    for (std::uint32_t id = 0; id < 3; ++id) hosted.join(id + 1, 5);
    hosted.open();
    for (std::size_t i = 0; i < 3; ++i) hosted.set(i, percepts, {mine[i].data(), mine[i].size()});
    hosted.ask();
    hosted.wait({});
    for (std::size_t i = 0; i < 3; ++i) {
      percept::Action action;
      program->step(theirs[i].data(), percepts, action, 5, static_cast<std::uint32_t>(i + 1));
      percept::Action wanted;
      const robot_host::HostedCycle::Outcome outcome = hosted.take(i, wanted);
      ASSERT_EQ(outcome.failure, "");
      std::memcpy(mine[i].data(), outcome.frame.data(), outcome.frame.size());
      ASSERT_EQ(mine[i], theirs[i]) << "cycle " << cycle << ", robot " << i + 1;
      EXPECT_EQ(wanted.velocity, action.velocity);
    }
  }
  EXPECT_EQ(read->built.program->active_states(mine[1].data()), program->active_states(theirs[1].data()));
}

TEST(Hosting, IsMadeToDoWhatTheSameCodeIsEmbedded) {
  const Folder folder;
  folder.write("mine.cnl", kManyThings);
  text::Diagnostics sink;
  const auto read = robot::read_network("mine.cnl", {}, sources_in(folder.path(), code_permitted()), sink);
  ASSERT_TRUE(read) << text::render(sink);
  const auto program = embedded(folder, sink);
  ASSERT_TRUE(program) << text::render(sink);
  robot_host::HostedCycle hosted(read->built.hosted, true);
  flow::Frame mine = program->make_frame();
  flow::Frame theirs = program->make_frame();
  flow::Interventions my_hands;
  flow::Interventions their_hands;
  const auto both = [&](const auto& ask) {
    EXPECT_EQ(ask(my_hands, mine), std::nullopt);
    EXPECT_EQ(ask(their_hands, theirs), std::nullopt);
  };
  for (int cycle = 0; cycle < 100; ++cycle) {
    if (cycle == 20)
      both([&](auto& hands, auto& frame) { return hands.hold(*program, frame.data(), "lead", "{1, 2}"); });
    if (cycle == 25)
      both([&](auto& hands, auto& frame) { return hands.hold(*program, frame.data(), "often", "false"); });
    if (cycle % 10 == 0)
      both([&](auto& hands, auto& frame) { return hands.force(*program, frame.data(), "ways", "Two"); });
    if (cycle == 60)
      both([&](auto& hands, auto& frame) { return hands.release(*program, frame.data(), ""); });
    const percept::Percepts percepts;
    hosted.begin();
    hosted.join(1, 5);
    hosted.open();
    hosted.set(0, percepts, {mine.data(), mine.size()}, &my_hands);
    hosted.ask();
    hosted.wait({});
    percept::Action wanted;
    const robot_host::HostedCycle::Outcome outcome = hosted.take(0, wanted, &my_hands);
    ASSERT_EQ(outcome.failure, "");
    std::memcpy(mine.data(), outcome.frame.data(), outcome.frame.size());
    percept::Action action;
    program->step(theirs.data(), percepts, action, 5, 1, nullptr, &their_hands);
    my_hands.finish();
    their_hands.finish();
    ASSERT_EQ(mine, theirs) << "cycle " << cycle;
    EXPECT_EQ(wanted.velocity, action.velocity);
    if (cycle % 10 == 0) {
      ASSERT_EQ(my_hands.forced().size(), 1U);
      EXPECT_TRUE(my_hands.forced()[0].was_done);
    }
  }
}

TEST(Hosting, ShowsPortsAndStatesOfARobotInAProcessOfItsOwn) {
  const Folder folder;
  const Team team(folder, kManyThings, 2, code_permitted(), 2);
  ASSERT_TRUE(team.run) << team.all();
  team.step(30);
  const fleet::FleetRobot& robot = team.robot(2);
  ASSERT_EQ(robot.life, RobotLife::kRunning) << team.all();
  const flow::Program& program = *robot.workings().program;
  EXPECT_EQ(program.active_states(robot.workings().frame).size(), 1U);
  EXPECT_GT(flow::Program::number(robot.workings().frame, *program.find("ways")).value_or(0), 0.1);
  EXPECT_GT(flow::Program::cycle(robot.workings().frame), 20U);
  EXPECT_EQ(team.run->set_parameter({2}, "pace", "0"), std::nullopt);
  team.step(1);
  EXPECT_EQ(flow::Program::print(robot.workings().frame, *program.find("pace")), "0");
}

TEST(Hosting, IsTheSameForAnyNumberOfThreads) {
  std::vector<geom::Point> ends;
  for (const int threads : {1, 2, 4}) {
    const Folder folder;
    const Team team(folder, kManyThings, 7, code_permitted(), threads);
    ASSERT_TRUE(team.run) << team.all();
    team.step(100);
    for (std::uint32_t id = 1; id <= 7; ++id) ends.push_back(team.run->fleet().pose(team.robot(id)).position);
  }
  for (std::size_t i = 0; i < 14; ++i) EXPECT_EQ(ends[i], ends[i + 7]) << i;
}

TEST(Hosting, NeverRunsWhatIsOnlyChecked) {
  const Folder folder;
  const std::string witness = folder.path("witness");
  folder.write("mine.cnl", network_that("",
                                        "#include <cstdio>\nstatic const bool kRan = [] { std::FILE* f = "
                                        "std::fopen(\"" +
                                            witness +
                                            "\", \"w\"); if (f) std::fclose(f); "
                                            "return true; }();"));
  text::Diagnostics sink;
  const auto read = robot::read_network("mine.cnl", {}, sources_in(folder.path(), check_permitted()), sink);
  ASSERT_TRUE(read) << text::render(sink);
  EXPECT_TRUE(read->built.is_described_only);
  EXPECT_FALSE(read->built.hosted);
  EXPECT_FALSE(fs::exists(witness));
}

/// What goes wrong before anything runs.
struct Refusal {
  const char* name;
  const char* outside;
  const char* body;
  const char* said;
};

class RefusalTest : public ::testing::TestWithParam<Refusal> {};

TEST_P(RefusalTest, IsToldWhereTheMissionNamesTheProgram) {
  const Folder folder;
  const Team team(folder, network_that(GetParam().body, GetParam().outside), 1, code_permitted());
  EXPECT_FALSE(team.run);
  const std::string said = team.all();
  EXPECT_NE(said.find("[cannot-load]"), std::string::npos) << said;
  EXPECT_NE(said.find(GetParam().said), std::string::npos) << said;
  EXPECT_NE(said.find("m.mdl:3:"), std::string::npos) << said;
}

INSTANTIATE_TEST_SUITE_P(
    Hosting, RefusalTest,
    ::testing::Values(
        Refusal{"MissingPart", "int nobody_defines_this();", "output.x = nobody_defines_this();",
                "nobody_defines_this"},
        Refusal{"ConstructorThatCrashes",
                "static const int kOdd = [] { volatile int* volatile p = nullptr; *p = 1; return 1; }();", "",
                "signal 11 (Segmentation fault)"},
        Refusal{"ConstructorThatEnds",
                "#include <cstdlib>\nstatic const int kOdd = [] { std::exit(0); return 1; }();", "",
                "ended with exit status 0"},
        Refusal{"ConstructorThatNeverEnds",
                "static const int kOdd = [] { for (;;) asm volatile(\"\"); return 1; }();", "",
                "gave no answer for 5 s"}),
    [](const auto& one) { return one.param.name; });

/// What goes wrong in robot 2 of three, after a while.
struct Fault {
  const char* name;
  const char* body;
  const char* told;
  const char* outside = "";
};

class FaultTest : public ::testing::TestWithParam<Fault> {};

TEST_P(FaultTest, StopsThatRobotAloneAndIsTold) {
  const Fault& fault = GetParam();
  if (cell::kIsSanitized && std::string(fault.name) == "Memory")
    GTEST_SKIP() << "sanitizers have their own word on memory";
  const std::string body = std::string("if (percepts.id.value == 2 && way > 12.0) { ") + fault.body + " }";
  const Folder folder;
  const Team team(folder, network_that(body, fault.outside), 3, code_permitted());
  ASSERT_TRUE(team.run) << team.all();
  team.step(40);
  EXPECT_EQ(team.robot(1).life, RobotLife::kRunning) << team.all();
  EXPECT_EQ(team.robot(2).life, RobotLife::kFaulted) << team.all();
  EXPECT_EQ(team.robot(3).life, RobotLife::kRunning) << team.all();
  EXPECT_TRUE(team.was_told(fault.told)) << team.all();
  EXPECT_TRUE(team.was_told("procedure `Mine`")) << team.all();
  // The others as if that robot had been stopped there.
  const Folder reference_folder;
  const Team reference(reference_folder,
                       network_that("if (percepts.id.value == 2 && way > 12.0) output.x = NAN;"), 3,
                       code_permitted());
  ASSERT_TRUE(reference.run) << reference.all();
  reference.step(40);
  for (const std::uint32_t id : {1U, 3U}) {
    EXPECT_EQ(team.run->fleet().pose(team.robot(id)).position,
              reference.run->fleet().pose(reference.robot(id)).position);
  }
}

INSTANTIATE_TEST_SUITE_P(
    Hosting, FaultTest,
    ::testing::Values(
        Fault{"NullPointer", "volatile int* p = nullptr; *p = 1;", "signal 11 (Segmentation fault)"},
        Fault{"EndlessLoop", "for (;;) asm volatile(\"\");",
              "did not come to an end within 2 s of processor time"},
        Fault{"Exit", "std::exit(0);", "ended with exit status 0", "#include <cstdlib>"},
        Fault{"Abort", "std::abort();", "signal 6 (Aborted)", "#include <cstdlib>"},
        Fault{"DivisionByZero", "volatile int zero = 0; output.x = 7 / zero;", "signal 8"},
        Fault{"Recursion", "output.x = deep(1);", "signal 11",
              "static double deep(double x) { volatile char room[4096] = {}; return room[0] + deep(x + 1) + "
              "1; }"},
        Fault{"Memory",
              "for (std::size_t n = 1;; n *= 2) { volatile char* p = new char[n << 20]; p[0] = 1; }",
              "needed more than 512 MB of memory"}),
    [](const auto& one) { return one.param.name; });

TEST(Hosting, TakesAnyBytesThatAProgramLeavesInItsFrames) {
  const Folder folder;
  folder.write("mine.cnl", kManyThings);
  text::Diagnostics sink;
  const auto read = robot::read_network("mine.cnl", {}, sources_in(folder.path(), code_permitted()), sink);
  ASSERT_TRUE(read) << text::render(sink);
  std::vector<std::shared_ptr<const flow::Program>> programs = {read->built.program};
  const auto standard = robot::load_program("robot", {}, {}, {}, {}, sink);
  ASSERT_TRUE(standard);
  programs.push_back(standard->program);
  constexpr unsigned kSeed = 12;
  std::mt19937 any(kSeed);
  for (const auto& program : programs) {
    flow::Frame frame = program->make_frame();
    std::vector<flow::Program::SequenceState> before;
    for (int round = 0; round < 300; ++round) {
      for (std::size_t i = 0; i < frame.size(); ++i) frame.data()[i] = static_cast<std::byte>(any());
      // Often a cycle that stamps agree with.
      if (round % 2 == 0) std::memset(frame.data(), round / 2, frame.size());
      for (const flow::Port& port : program->ports()) {
        flow::Program::print(frame.data(), port);
        flow::Program::number(frame.data(), port);
        flow::Program::vector(frame.data(), port);
      }
      program->needs(frame.data());
      program->find_fault(frame.data());
      program->contributions(frame.data());
      EXPECT_EQ(program->active_states(frame.data()).size(), program->sequence_count());
      program->states_key(frame.data());
      program->ways_out(frame.data());
      program->transits(frame.data(), before);
      program->ran(frame.data(), before);
      program->sequence_states(frame.data(), before);
    }
  }
}

}  // namespace
}  // namespace mlab::brought_code
