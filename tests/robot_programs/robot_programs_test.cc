// Robots whose programs are executables, in a mission: their run is the run of the embedded program, and
// whatever an executable does, the mission goes on.

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/history/history_writer.h"
#include "mlab/history/replay.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/robot/executable/executable.h"
#include "mlab/robot/host/hosted_program.h"
#include "mlab/robot/program/network_file.h"
#include "mlab/run/mission_run.h"
#include "mlab/simulated/run.h"

namespace mlab {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWalker = R"(
parameter double [m/s] pace = 2 in 0 .. 10;
node order_goal is GetOrderGoal with nend
node goal is DetectGoal with goal = order_goal; nend
node to_goal is MoveToGoal with goal = goal; success_radius = 1; nend
node obstacles is DetectObstacles with range = 20; nend
node from_obstacles is AvoidStaticObstacles with readings = obstacles; sphere = 8; safety_margin = 1; nend
node others is DetectRobots with range = 10; nend
node from_others is AvoidRobots with readings = others; sphere = 6; min_range = 1; nend
node noise is Noise with persistence = 2; nend
node sum is WeightedSum with
  members = to_goal; members = from_obstacles; members = from_others; members = noise;
  gains = 1; gains = 1.5; gains = 1; gains = 0.3;
nend
node wheels is Drive with v = sum; base_velocity = pace; max_velocity = 5; nend
)";

/// A mission with five robots in a folder of its own, and the executable of their program.
class RobotProgramsTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    shared_folder = fs::path(testing::TempDir()) / ("mlab_robot_programs_test_" + std::to_string(::getpid()));
    fs::create_directories(shared_folder);
    std::ofstream(shared_folder / "walker.cnl") << kWalker;
    std::ofstream(shared_folder / "map.odl")
        << "SITE Test\nMISSION-AREA 300 200\nCONTROL MEASURES:\nPP Here 30 100\n"
           "PP There 270 100\nOBSTACLE 120 103 6\nOBSTACLE 170 95 8\n";
    text::Diagnostics sink;
    const auto read = robot::read_network((shared_folder / "walker.cnl").string(), {}, {}, sink);
    ASSERT_TRUE(read) << text::render(sink);
    robot_build::RobotSource source;
    source.name = "walker";
    source.network = read->network;
    robot_build::Toolchain toolchain;
    toolchain.include_root = base::source_folder() + "/src";
    toolchain.link_file = MLAB_LINK_FILE;
    toolchain.cache_folder = (shared_folder / "cache").string();
    for (const char* name : {"walker", "closed"}) {
      source.is_closed = name == std::string("closed");
      ASSERT_TRUE(robot_build::build_executable(robot_build::emit_cpp(source),
                                                (shared_folder / name).string(), toolchain,
                                                cell::testing::all_permitted(), sink))
          << text::render(sink);
    }
  }
  static void TearDownTestSuite() {
    std::error_code ignored;
    fs::remove_all(shared_folder, ignored);
  }

  static std::string script(const std::string& name, const std::string& lines) {
    std::ofstream(shared_folder / name) << "#!/bin/sh\n" << lines << "\n";
    fs::permissions(shared_folder / name, fs::perms::owner_all);
    return "./" + name;
  }
  std::unique_ptr<run::MissionRun> prepare(const std::string& program, int threads,
                                           const std::string& parameters = "(pace = 3)",
                                           bool allow_native = true, bool in_cell = true) {
    std::ofstream(shared_folder / "m.mdl")
        << "MISSION NAME Test\nOVERLAY map.odl\nNEW-ROBOT walker \"" << program << "\" " << parameters
        << "\nUNIT <u> walker walker walker walker walker\nCOMMAND LIST:\n0. UNIT u START Here 0 10\n"
           "1. UNIT u MOVETO There\n";
    sink_ = {};
    const auto mission = mdl::load_mission((shared_folder / "m.mdl").string(), sink_, {1, {}});
    if (!mission) return nullptr;
    run::RunSettings settings;
    settings.seed = 5;
    settings.threads = threads;
    settings.executive.proceed_all = true;
    robot::ProgramSources sources{!in_cell       ? cell::testing::permitted_without_cell()
                                  : allow_native ? cell::testing::all_permitted()
                                                 : cell::testing::code_permitted(),
                                  shared_folder.string(), base::source_folder() + "/src", "test"};
    sources.limits.cycle_wall = 1.0;
    auto run = simulated::make_run(mission, sources, settings, sink_);
    if (run) {
      run->set_observer([this](const mission::Effect& effect) {
        const auto* told = std::get_if<mission::effect::Tell>(&effect);
        if (told != nullptr && told->kind == mission::effect::Tell::Kind::kWarning)
          warnings_.push_back(told->text);
      });
    }
    return run;
  }
  // Where all robots are, cycle by cycle.
  static std::vector<geom::Pose> ways(run::MissionRun& run, int cycles) {
    std::vector<geom::Pose> out;
    run.post(mission::event::Execute{});
    for (int i = 0; i < cycles && run.step() == run::MissionRun::Progress::kStepped; ++i) {
      for (const fleet::FleetRobot& robot : run.fleet().robots()) out.push_back(run.fleet().pose(robot));
    }
    return out;
  }
  // What a run tells whose robots' program is this: a script that starts others, which no cell lets it.
  std::vector<std::string> told_of(const std::string& program, int cycles = 60) {
    warnings_.clear();
    const auto run = prepare(program, 1, "(pace = 3)", true, false);
    EXPECT_TRUE(run) << text::render(sink_);
    if (!run) return {};
    EXPECT_EQ(ways(*run, cycles).size(), static_cast<std::size_t>(5 * cycles)) << "the run goes on";
    for (const fleet::FleetRobot& robot : run->fleet().robots())
      EXPECT_EQ(robot.life, fleet::RobotLife::kFaulted);
    EXPECT_EQ(run->fleet().bodies().moving, 0U);
    // The mission has its own word on robots that get nowhere.
    std::erase_if(warnings_, [](const std::string& text) {
      return text.find(" stands: its program ") == std::string::npos;
    });
    return warnings_;
  }

  static fs::path shared_folder;
  text::Diagnostics sink_;
  std::vector<std::string> warnings_;
};

fs::path RobotProgramsTest::shared_folder;

TEST_F(RobotProgramsTest, RunAsTheEmbeddedProgramBitForBit) {
  const auto embedded = prepare("walker.cnl", 1);
  ASSERT_TRUE(embedded) << text::render(sink_);
  const std::vector<geom::Pose> expected = ways(*embedded, 400);
  ASSERT_EQ(expected.size(), 2000U);
  ASSERT_GT(geom::distance(expected.front().position, expected[1995].position), 50.0);
  for (const char* program : {"./walker", "./closed"}) {
    for (const int threads : {1, 3}) {
      const auto native = prepare(program, threads);
      ASSERT_TRUE(native) << text::render(sink_);
      EXPECT_EQ(ways(*native, 400), expected) << program << ", " << threads << " threads";
      EXPECT_TRUE(warnings_.empty());
    }
  }
}

// Every value of every cycle.
TEST_F(RobotProgramsTest, ShowTheirNodesAsTheEmbeddedProgramDoes) {
  const auto embedded = prepare("walker.cnl", 1);
  const auto native = prepare("./walker", 1);
  ASSERT_TRUE(embedded && native) << text::render(sink_);
  embedded->post(mission::event::Execute{});
  native->post(mission::event::Execute{});
  for (int cycle = 0; cycle < 100; ++cycle) {
    embedded->step();
    native->step();
    const fleet::FleetRobot& inside = embedded->fleet().robots()[2];
    const fleet::FleetRobot& beside = native->fleet().robots()[2];
    ASSERT_TRUE(beside.workings().program);
    const std::vector<flow::Port>& ports = inside.workings().program->ports();
    ASSERT_EQ(beside.workings().program->ports().size(), ports.size());
    for (const flow::Port& port : ports) {
      const flow::Port* same = beside.workings().program->find(port.path);
      ASSERT_NE(same, nullptr) << port.path;
      ASSERT_EQ(flow::Program::print(beside.workings().frame, *same),
                flow::Program::print(inside.workings().frame, port))
          << port.path << " in cycle " << cycle;
    }
  }
}

TEST_F(RobotProgramsTest, ThatAreClosedShowNothing) {
  const auto native = prepare("./closed", 1);
  ASSERT_TRUE(native) << text::render(sink_);
  EXPECT_FALSE(native->fleet().robots()[0].workings().program);
}

// Three foragers tell each other what they claim, look around with cameras that turn, pick up and deliver.
TEST_F(RobotProgramsTest, ForageTogetherAsTheEmbeddedProgramsDo) {
  const fs::path missions = fs::path(base::source_folder()) / "missions/forage";
  const fs::path folder = shared_folder / "forage";
  fs::create_directories(folder);
  for (const char* file : {"forager.cdl", "forage.odl"}) {
    std::error_code ignored;
    fs::copy_file(missions / file, folder / file, ignored);
  }
  const std::string build = "cd '" + folder.string() + "' && XDG_CACHE_HOME='" + folder.string() + "' '" +
                            MLAB_COMMAND + "' build forager.cdl >/dev/null 2>&1";
  ASSERT_EQ(std::system(build.c_str()), 0);  // NOLINT(concurrency-mt-unsafe): the test has one thread
  struct Trace {
    std::vector<geom::Pose> ways;
    std::size_t deliveries = 0;
  };
  std::vector<Trace> traces;
  for (const char* program : {"forager.cdl", "./forager"}) {
    std::ofstream(folder / "m.mdl") << "MISSION NAME Forage\nOVERLAY forage.odl\nNEW-ROBOT forager \""
                                    << program
                                    << "\" (camera_field_of_view = 120, robot_radius = 0.3)\n"
                                       "UNIT <foragers> forager forager forager\nCOMMAND LIST:\n"
                                       "0. UNIT foragers START Home 1.5 0\n1. UNIT foragers MOVETO Home\n";
    text::Diagnostics sink;
    const auto mission = mdl::load_mission((folder / "m.mdl").string(), sink, {1, {}});
    ASSERT_TRUE(mission) << text::render(sink);
    run::RunSettings settings;
    settings.seed = 4;
    settings.executive.proceed_all = true;
    robot::ProgramSources sources{cell::testing::all_permitted(), folder.string(),
                                  base::source_folder() + "/src", "test"};
    const auto run = simulated::make_run(mission, sources, settings, sink);
    ASSERT_TRUE(run) << text::render(sink);
    Trace trace;
    trace.ways = ways(*run, 2500);
    trace.deliveries = run->deliveries().size();
    traces.push_back(std::move(trace));
  }
  EXPECT_EQ(traces[0].ways.size(), 7500U);
  EXPECT_TRUE(traces[0].ways == traces[1].ways);
  EXPECT_GE(traces[0].deliveries, 5U);
  EXPECT_EQ(traces[0].deliveries, traces[1].deliveries);
}

TEST_F(RobotProgramsTest, TakeParametersWhileTheyRun) {
  const auto embedded = prepare("walker.cnl", 1);
  const auto native = prepare("./walker", 2);
  const auto closed = prepare("./closed", 2);
  ASSERT_TRUE(embedded && native && closed);
  std::vector<std::vector<geom::Pose>> all;
  for (run::MissionRun* run : {embedded.get(), native.get(), closed.get()}) {
    ways(*run, 50);
    EXPECT_EQ(run->set_parameter({2}, "pace", "0.5"), std::nullopt);
    EXPECT_EQ(run->set_parameter({2}, "obstacles.range", "3"), std::nullopt);
    EXPECT_EQ(run->set_parameter({2}, "pace", "fast"),
              "`fast` is no number: `pace` takes a number, 0 .. 10 [m/s]");
    EXPECT_TRUE(run->set_parameter({2}, "peace", "1"));
    std::vector<geom::Pose>& poses = all.emplace_back();
    for (int i = 0; i < 100; ++i) {
      run->step();
      for (const fleet::FleetRobot& robot : run->fleet().robots()) poses.push_back(run->fleet().pose(robot));
    }
  }
  EXPECT_EQ(all[0], all[1]);
  EXPECT_EQ(all[0], all[2]);
}

TEST_F(RobotProgramsTest, KeepWhatAPersonSetWhereTheyAreStartedAnew) {
  std::vector<std::vector<geom::Pose>> all;
  for (const char* program : {"walker.cnl", "./walker", "./closed"}) {
    const auto run = prepare(program, 1);
    ASSERT_TRUE(run) << text::render(sink_);
    ways(*run, 20);
    EXPECT_EQ(run->set_parameter({2}, "pace", "0.5"), std::nullopt);
    run->post(mission::event::Abort{});
    all.push_back(ways(*run, 60));
    ASSERT_EQ(all.back().size(), 300U) << program;
  }
  EXPECT_EQ(all[0], all[1]);
  EXPECT_EQ(all[0], all[2]);
}

TEST_F(RobotProgramsTest, AreNotRunUnlessThatIsAllowed) {
  const auto run = prepare("./walker", 1, "", false);
  ASSERT_TRUE(run);
  ASSERT_EQ(sink_.warning_count(), 1U);
  EXPECT_EQ(sink_.items()[0].kind, "native-program");
  EXPECT_EQ(sink_.items()[0].hints, (std::vector<std::string>{"where you trust it, say `--allow-native`"}));
  ways(*run, 10);
  EXPECT_EQ(run->fleet().robots()[0].life, fleet::RobotLife::kParked);
}

TEST_F(RobotProgramsTest, AreCheckedBeforeTheRun) {
  EXPECT_FALSE(prepare(script("no_robot", "echo hello"), 1));
  ASSERT_EQ(sink_.error_count(), 1U);
  EXPECT_EQ(sink_.items()[0].kind, "bad-robot-program");
  EXPECT_TRUE(sink_.items()[0].place.source) << "at the place in the mission";
  for (const char* program : {"./walker", "./closed"}) {
    EXPECT_FALSE(prepare(program, 1, "(pace = 11)"));
    EXPECT_EQ(sink_.items()[0].message, "11 is out of range: `pace` takes 0 .. 10 m/s");
    EXPECT_TRUE(prepare(program, 1, "(peace = 1)"));
    EXPECT_TRUE(std::ranges::any_of(sink_.items(), [](const text::Diagnostic& one) {
      return one.hints == std::vector<std::string>{"did you mean `pace`?"};
    })) << text::render(sink_);
  }
}

// What hosted procedures get, executables with procedures of their own get, too.
TEST_F(RobotProgramsTest, ThatCrashLeaveOneRobotStandingAndNameTheProcedure) {
  std::ofstream(shared_folder / "frail.cnl")
      << "procedure Vector Walk\nwith\nheader\n  int count = 0;\nbody\n  output = {1.0, 0.0, 0.0};\n"
         "  if (++count == 20 && percepts.id.value == 2) *static_cast<volatile int*>(nullptr) = 1;\npend\n"
         "node walk is Walk with nend\nnode wheels is Drive with v = walk; nend\n";
  const std::string build = "cd '" + shared_folder.string() + "' && XDG_CACHE_HOME='" +
                            shared_folder.string() + "' '" + MLAB_COMMAND +
                            "' build frail.cnl >/dev/null 2>&1";
  ASSERT_EQ(std::system(build.c_str()), 0);  // NOLINT(concurrency-mt-unsafe): the test has one thread
  const auto run = prepare("./frail", 1, "");
  ASSERT_TRUE(run) << text::render(sink_);
  EXPECT_EQ(ways(*run, 60).size(), 300U);
  ASSERT_FALSE(warnings_.empty());
  EXPECT_EQ(warnings_[0],
            "robot 2 stands: its program `./frail` ended with signal 11 (Segmentation fault), in procedure "
            "`Walk` (frail.cnl:1) at node `walk`");
  for (const fleet::FleetRobot& robot : run->fleet().robots())
    EXPECT_EQ(robot.life == fleet::RobotLife::kFaulted, robot.id.value == 2) << robot.id.value;
}

// What they answered is recorded: the run is computed again when they are gone, whatever became of them in
// it.
TEST_F(RobotProgramsTest, NeedNotBeThereWhenTheRunIsComputedAgain) {
  script("dying", "dd bs=1 count=20000 status=none | \"${0%/*}/closed\"; echo battery empty >&2; exit 7");
  for (const std::string program : {"walker", "closed", "dying"}) {
    SCOPED_TRACE(program);
    fs::copy_file(shared_folder / program, shared_folder / "gone", fs::copy_options::overwrite_existing);
    warnings_.clear();
    const auto run = prepare("./gone", 1, "(pace = 3)", true, program != "dying");
    ASSERT_TRUE(run) << text::render(sink_);
    const auto history = std::make_shared<history::History>();
    history::HistoryWriter writer([&](const wire::HistoryEntry& entry) {
      const auto problem = history->add(entry);
      ASSERT_FALSE(problem) << *problem;
    });
    writer.begin(*run, {"test", {}, 1, 0.0});
    run->post(mission::event::Execute{});
    std::vector<geom::Pose> expected;
    for (int i = 0; i < 300 && run->step() == run::MissionRun::Progress::kStepped; ++i) {
      writer.note_cycle();
      if (i == 100) run->set_parameter({2}, "pace", "1");
      if (i == 150) run->set_emergency_stop(true);
      for (const fleet::FleetRobot& robot : run->fleet().robots())
        expected.push_back(run->fleet().pose(robot));
      if (run->is_stopped() && run->fleet().bodies().moving == 0) run->set_emergency_stop(false);
    }
    writer.end("interrupted");
    EXPECT_EQ(expected.size(), 1500U);
    const std::vector<std::string> told = std::exchange(warnings_, {});
    EXPECT_EQ(told.empty(), program != "dying");
    fs::remove(shared_folder / "gone");

    text::Diagnostics sink;
    const auto replay = history::Replay::make(history, {cell::Permission()}, sink);
    ASSERT_TRUE(replay) << text::render(sink);
    std::vector<std::string> told_again;
    replay->run().set_observer([&](const mission::Effect& effect) {
      const auto* one = std::get_if<mission::effect::Tell>(&effect);
      if (one != nullptr && one->kind == mission::effect::Tell::Kind::kWarning)
        told_again.push_back(one->text);
    });
    std::vector<geom::Pose> poses;
    while (replay->step()) {
      const fleet::Fleet& fleet = replay->run().fleet();
      for (const fleet::FleetRobot& robot : fleet.robots()) poses.push_back(fleet.pose(robot));
    }
    EXPECT_FALSE(replay->divergence()) << replay->divergence()->why;
    EXPECT_TRUE(replay->is_at_end());
    EXPECT_EQ(poses, expected);
    EXPECT_EQ(told_again, told);
  }
}

// The same as who types the commands meets it.
TEST_F(RobotProgramsTest, AreNotNeededByThoseWhoReadARecording) {
  fs::copy_file(shared_folder / "closed", shared_folder / "gone", fs::copy_options::overwrite_existing);
  std::ofstream(shared_folder / "read.mdl")
      << "MISSION NAME Test\nOVERLAY map.odl\nNEW-ROBOT walker \"./gone\"\n"
         "UNIT <u> walker walker ROBOT\nCOMMAND LIST:\n"
         "0. UNIT u START Here 0 10\n1. UNIT u MOVETO There\n";
  const auto status_of = [](const std::string& command, const std::string& out) {
    const std::string line = "cd '" + shared_folder.string() + "' && HOME='" + shared_folder.string() +
                             "' '" + MLAB_COMMAND + "' " + command + " >" + out + " 2>&1";
    const int status = std::system(line.c_str());  // NOLINT(concurrency-mt-unsafe): the test has one thread
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  };
  const auto text_of = [](const std::string& file) {
    std::ifstream in(shared_folder / file);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const auto report_of = [&](const std::string& file) {
    const std::string report = text_of(file);
    return report.substr(0, report.find("\"performance\""));
  };
  // Nothing in it reports on orders, so the mission fails, for that reason.
  const std::string run = "run read.mdl --headless --proceed --allow-native --record read.mcap";
  ASSERT_EQ(status_of(run + " --report then.json", "run"), 1) << text_of("run");
  ASSERT_NE(text_of("run").find("\nrecording: read.mcap"), std::string::npos) << text_of("run");
  for (const char* file : {"gone", "read.mdl"}) fs::remove(shared_folder / file);
  EXPECT_EQ(status_of("replay read.mcap --headless --report now.json", "replay"), 0) << text_of("replay");
  EXPECT_NE(text_of("replay").find("\nas recorded: "), std::string::npos) << text_of("replay");
  EXPECT_EQ(report_of("now.json"), report_of("then.json"));
  EXPECT_EQ(status_of("replay read.mcap --headless --quiet --record again.mcap", "replay"), 0)
      << text_of("replay");
  EXPECT_EQ(status_of("compare read.mcap again.mcap", "compare"), 0) << text_of("compare");
  EXPECT_EQ(status_of("trace read.mcap --robot 1 --ports '*'", "trace"), 2);
  EXPECT_NE(text_of("trace").find("of robot 1 only what their programs answered is recorded"),
            std::string::npos)
      << text_of("trace");
  EXPECT_EQ(status_of("trace read.mcap --robot 3 --ports '*' --to 1", "trace"), 0) << text_of("trace");
}

TEST_F(RobotProgramsTest, ThatEndInTheMiddleLeaveTheirRobotsStanding) {
  const auto told = told_of(
      script("dies", "dd bs=1 count=20000 status=none | \"${0%/*}/closed\"; echo battery empty >&2; exit 7"));
  ASSERT_EQ(told.size(), 5U);
  EXPECT_EQ(told[0], "robot 1 stands: its program `./dies` ended with exit status 7, saying: battery empty");
}

TEST_F(RobotProgramsTest, ThatHangLeaveTheirRobotsStandingAfterTheirTime) {
  const auto began = std::chrono::steady_clock::now();
  const auto told =
      told_of(script("hangs", "dd bs=1 count=20000 status=none | \"${0%/*}/closed\"; sleep 100"));
  ASSERT_EQ(told.size(), 5U);
  EXPECT_EQ(told[0], "robot 1 stands: its program `./hangs` gave no answer for 1 s");
  EXPECT_LT(std::chrono::steady_clock::now() - began, std::chrono::seconds(20));
}

TEST_F(RobotProgramsTest, ThatTalkNonsenseLeaveTheirRobotsStanding) {
  const auto told =
      told_of(script("raves", "dd bs=1 count=20000 status=none | \"${0%/*}/closed\"; yes nonsense"));
  ASSERT_EQ(told.size(), 5U);
  EXPECT_EQ(
      told[0],
      "robot 1 stands: its program `./raves` writes something to its standard output that is no message of "
      "the robot protocol");
}

TEST_F(RobotProgramsTest, OneThatWasBuiltAnewMeanwhileIsNotRunInItsPlace) {
  robot::ProgramSources sources{cell::testing::all_permitted(), shared_folder.string(),
                                base::source_folder() + "/src", "test"};
  const auto program = robot::load_program("./walker", {}, {}, sources, {}, sink_);
  ASSERT_TRUE(program && program->hosted) << text::render(sink_);
  ASSERT_TRUE(program->executable);
  EXPECT_EQ(program->executable->name, "walker");
  EXPECT_TRUE(robot_host::start_hosted(*program->hosted, nullptr));
  robot_host::HostedProgram other = *program->hosted;
  other.source ^= 1U;
  const auto started = robot_host::start_hosted(other, nullptr);
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error(),
            "was built anew meanwhile: it is another program than the one that was begun with");
}

TEST_F(RobotProgramsTest, OneThatIsClosedStaysWithTheRunWhateverHostIsNamed) {
  ASSERT_TRUE(prepare("./closed", 1, "green f1 (pace = 3)")) << text::render(sink_);
  EXPECT_NE(text::render(sink_).find("it is computed where the run is, and not on `f1`"), std::string::npos)
      << text::render(sink_);
}

TEST_F(RobotProgramsTest, OneThatIsClosedOrWithoutAnAgentTellsWhoWantsItInAFleet) {
  const auto said = [](const std::string& line) {
    const fs::path file = shared_folder / "said";
    // NOLINTNEXTLINE(concurrency-mt-unsafe): no other thread calls it
    const int status = std::system((line + " 2> " + file.string()).c_str());
    std::ifstream stream(file);
    return std::to_string(WEXITSTATUS(status)) + " " +
           std::string(std::istreambuf_iterator<char>(stream), {});
  };
  const std::string folder = shared_folder.string();
  EXPECT_EQ(said(folder + "/closed --fleet alpha --name f1"),
            "2 walker: is closed (mlab build --closed), and a run has to see how a member is made\n");
  EXPECT_EQ(said("MLAB_AGENT=/nowhere/mlab-agent " + folder + "/walker --fleet alpha"),
            "2 walker: --fleet needs mlab, or mlab-agent of the package missionlab-agent, and neither is "
            "beside this "
            "file or in PATH; MLAB_AGENT names its path (/nowhere/mlab-agent: No such file or directory)\n");
  EXPECT_EQ(
      said("MLAB_AGENT=" + folder + "/walker " + folder + "/walker --fleet alpha"),
      "2 walker: takes no --offer, it offers itself; where nobody said that, MLAB_AGENT or PATH names a "
      "robot program as mlab-agent\n");
  EXPECT_EQ(said(folder + "/walker --name f1"),
            "2 walker: takes no arguments but --help, --version, and those of --fleet\n");
}

}  // namespace
}  // namespace mlab
