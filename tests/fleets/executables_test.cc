// Executables of `mlab build` that a person starts on some machine: they take part in the missions that name
// them.

#include "fleets.h"

#include <csignal>

namespace mlab::testing {
namespace {

namespace fs = std::filesystem;
using network::Process;

constexpr const char* kWalker = R"(
parameter double [m/s] pace = 2 in 0 .. 10;
node order_goal is GetOrderGoal with nend
node goal is DetectGoal with goal = order_goal; nend
node to_goal is MoveToGoal with goal = goal; success_radius = 1; nend
node noise is Noise with persistence = 2; nend
node sum is WeightedSum with members = to_goal; members = noise; gains = 1; gains = 0.3; nend
node wheels is Drive with v = sum; base_velocity = pace; max_velocity = 5; nend
node report is ReportStatus with unit_goal = goal; offset = to_goal; nend
)";
constexpr const char* kMap =
    "SITE Test\nMISSION-AREA 300 200\nCONTROL MEASURES:\nPP Here 30 100\nPP There 90 100\n";
constexpr const char* kMission =
    "MISSION NAME Test\nOVERLAY map.odl\nNEW-ROBOT walker \"./walker\" green f1 (pace = 3)\n"
    "UNIT <all> walker walker ROBOT\nCOMMAND LIST:\n0. UNIT all START Here 0 10\n"
    "1. UNIT all MOVETO There\n";

std::string in_words(const std::vector<std::string>& words) {
  return fmt::format("{}", fmt::join(words, " "));
}

class FleetExecutables : public Fleets {
 protected:
  static void SetUpTestSuite() {
    folder = fs::path(::testing::TempDir()) / fmt::format("mlab_fleet_executables_{}", ::getpid());
    fs::create_directories(folder / "other");
    std::ofstream(folder / "walker.cnl") << kWalker;
    std::ofstream(folder / "map.odl") << kMap;
    std::ofstream(folder / "m.mdl") << kMission;
    built = build("walker", kWalker);
  }
  static void TearDownTestSuite() {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
  void SetUp() override {
    Fleets::SetUp();
    if (IsSkipped()) return;
    ASSERT_TRUE(built);
  }

  /// Makes an executable out of a network.
  static bool build(const std::string& name, const std::string& network,
                    const std::vector<std::string>& more = {}) {
    std::ofstream(folder / (name + ".cnl")) << network;
    return call({MLAB_COMMAND, "build", (folder / (name + ".cnl")).string(), in_words(more), "> /dev/null"});
  }
  static bool call(const std::vector<std::string>& words) {
    return std::system(in_words(words).c_str()) ==
           0;  // NOLINT(concurrency-mt-unsafe): no other thread calls it
  }
  /// The mission, with its executable.
  void bring_mission(const std::string& host) {
    fs::create_directories(net().host(host).path("/tmp/m"));
    for (const char* file : {"walker", "map.odl", "m.mdl"})
      fs::copy_file(folder / file, net().host(host).path(std::string("/tmp/m/") + file));
  }
  /// What a person there starts.
  Process start_executable(const std::string& host, const std::string& name,
                           const std::string& file = "walker") {
    fs::copy_file(folder / file, net().host(host).path("/tmp/walker"));
    return net().host(host).start(
        {"/tmp/walker", "--fleet", "alpha", "--name", name, "--network", net().host(host).address()},
        {.environment = {{"XDG_STATE_HOME", kAgentState}}});
  }
  /// Of the mission, all in one process.
  Json embedded() {
    const std::string report = (folder / "report.json").string();
    EXPECT_TRUE(
        call({MLAB_COMMAND, "run", (folder / "m.mdl").string(),
              "--headless --proceed --quiet --threads 1 --allow-native --report", report, "> /dev/null"}));
    return but_for_its_circumstances(report_in(report));
  }
  // What a run tells but for how fast it was, and where its mission lies.
  static Json but_for_its_circumstances(Json report) {
    if (!report.is_object()) return report;
    report.erase("performance");
    report["mission"].erase("file");
    return report;
  }

  static fs::path folder;
  static bool built;
};
fs::path FleetExecutables::folder;
bool FleetExecutables::built = false;

TEST_F(FleetExecutables, CarryTheRobotsOfMissionsThatNameThem) {
  make_network(31);
  const Process north = start_executable("north", "f1");
  ASSERT_TRUE(north.prints("waits for runs", kFleetPatience)) << north.output() << north.errors();
  const Process south = agent("south");
  bring_mission("base");
  Process far = run("/tmp/m/m.mdl", {"--allow-native"});
  const auto ending = far.wait(kFleetPatience);
  ASSERT_TRUE(ending) << far.output() << far.errors();
  EXPECT_EQ(ending->words(), "exit status 0") << far.output() << far.errors();
  EXPECT_EQ(embedded().dump(2), but_for_its_circumstances(report()).dump(2));
  EXPECT_TRUE(north.prints("a run has gone, and 2 robots with it", kFleetPatience)) << north.output();
  EXPECT_TRUE(south.prints("a run has gone, and 1 robot with it", kFleetPatience)) << south.output();
}

TEST_F(FleetExecutables, ASecondLookAtTheFleetNamesThemAndTheirAgentsLog) {
  make_network(34);
  const Process north = start_executable("north", "f1");
  ASSERT_TRUE(north.prints("waits for runs", kFleetPatience)) << north.output() << north.errors();
  const auto asked = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {MLAB_COMMAND, "fleet", "alpha", "--network", base().address()};
    words.insert(words.end(), more.begin(), more.end());
    Process out = base().start(words);
    const auto ending = out.wait(kFleetPatience);
    return fmt::format("{}: {}{}", ending ? ending->words() : "hangs", out.output(), out.errors());
  };
  EXPECT_NE(asked({"--once"}).find(", `walker` only"), std::string::npos) << asked({"--once"});
  const std::string log = asked({"--log", "f1"});
  EXPECT_TRUE(log.starts_with("exit status 0: ")) << log;
  EXPECT_NE(log.find("which carries robots of /tmp/walker only"), std::string::npos) << log;
  EXPECT_EQ(asked({"--log", "f2"}),
            "exit status 1: mlab fleet: no agent `f2` is heard in the fleet `alpha`\n");
}

TEST_F(FleetExecutables, AnotherVersionIsNotTakenForIt) {
  std::string faster = kWalker;
  faster.replace(faster.find("gains = 0.3"), 11, "gains = 0.4");
  ASSERT_TRUE(build("other/walker", faster));
  make_network(32);
  const Process north = start_executable("north", "f1", "other/walker");
  ASSERT_TRUE(north.prints("waits for runs", kFleetPatience)) << north.output() << north.errors();
  bring_mission("base");
  Process far = run("/tmp/m/m.mdl", {"--allow-native", "--patience", "20"});
  const auto ending = far.wait(kFleetPatience);
  ASSERT_TRUE(ending) << far.output() << far.errors();
  EXPECT_EQ(ending->words(), "exit status 1");
  EXPECT_NE(far.output().find("has no agent: `f1` offers another version of `walker`: copy yours to it, and "
                              "start it anew"),
            std::string::npos)
      << far.output();
}

TEST_F(FleetExecutables, WhoStartsThemIsToldWhatIsMissing) {
  make_network(33);
  bring_mission("base");
  Process far = run("/tmp/m/m.mdl", {"--allow-native", "--patience", "20"});
  const auto ending = far.wait(kFleetPatience);
  ASSERT_TRUE(ending) << far.output() << far.errors();
  EXPECT_EQ(ending->words(), "exit status 1");
  EXPECT_NE(
      far.output().find("has no agent: none of the name `f1` in the fleet `alpha` offers `walker`: there, "
                        "`./walker --fleet alpha --name f1 --network ADDRESS` does"),
      std::string::npos)
      << far.output();
}

TEST_F(FleetExecutables, WhoCantBeStartedFailsAtOnceInWordsThatAShellTakes) {
  make_network(34);
  bring_mission("base");
  fs::copy_file(folder / "walker", base().path("/tmp/m/my walker"));
  std::string mission = kMission;
  mission.replace(mission.find("./walker"), 8, "./my walker");
  std::ofstream(base().path("/tmp/m/m.mdl")) << mission;
  Process far = run("/tmp/m/m.mdl", {"--allow-native"});
  const auto ending = far.wait(kFleetPatience);
  ASSERT_TRUE(ending) << "nothing comes of waiting: " << far.output() << far.errors();
  EXPECT_EQ(ending->words(), "exit status 1");
  EXPECT_NE(far.output().find("`'./my walker' --fleet alpha --name f1 --network ADDRESS` does"),
            std::string::npos)
      << far.output();
}

TEST_F(FleetExecutables, DoNotServeMissionsInText) {
  make_network(35);
  const Process north = start_executable("north", "f1");
  ASSERT_TRUE(north.prints("waits for runs", kFleetPatience)) << north.output() << north.errors();
  Process far = run(mission("patrol"));
  const auto ending = far.wait(kFleetPatience);
  ASSERT_TRUE(ending) << far.output() << far.errors();
  EXPECT_EQ(ending->words(), "exit status 1");
  EXPECT_NE(
      far.output().find("has no agent: nobody in the fleet `alpha` builds robots from text, `f1` carries "
                        "those of the executable `walker` only: `mlab agent --fleet alpha --network"),
      std::string::npos)
      << far.output();
}

}  // namespace
}  // namespace mlab::testing
