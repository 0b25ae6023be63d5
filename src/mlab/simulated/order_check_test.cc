#include "mlab/run/order_check.h"

#include <map>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "mlab/run/mission_run.h"
#include "mlab/simulated/run.h"

namespace mlab::run {
namespace {

using mission::UnitCommand;

constexpr const char* kCart =
    "class Cart { actuator wheels: Drive(max_velocity = 2 m/s, base_velocity = 1 m/s) binds movement; }\n";

const std::map<std::string, std::string> kFiles = {
    {"wander.cdl", std::string(kCart) + "robot R is Cart { movement = MoveAhead(); }"},
    {"sent.cdl",
     std::string(kCart) + "robot R is Cart { movement = ReportArrival(goal = DetectGoal(GetOrderGoal())); }"},
    {"told.cdl", std::string(kCart) + "robot R is Cart { movement = ReportDone(); }"},
    {"guard.cdl", std::string(kCart) + "robot R is Cart { movement = sequence { start Look: Stand();\n"
                                       "  when IsAnyObject(FilterObjectsByClass(DetectObjects(range = 50 m), "
                                       "classes = EnemyRobot)) goto Flee;\n"
                                       "  final Flee: MoveAhead(); }; }"}};

text::Files in_memory() {
  text::Files out;
  out.is_file = [](const std::string& path) { return kFiles.contains(path); };
  out.read = [](const std::string& path) -> text::Result<text::SourcePtr> {
    return std::make_shared<const text::Source>(path, kFiles.at(path));
  };
  return out;
}

// One robot that is started, and then perhaps sent somewhere.
std::shared_ptr<mission::Mission> mission_of(const std::string& program, bool has_order,
                                             bool has_until = false) {
  auto out = std::make_shared<mission::Mission>();
  const auto source =
      std::make_shared<const text::Source>("test.mdl", "NEW-ROBOT r x\nUNIT u START\nUNIT u MOVETO\n");
  out->source = source;
  out->types.push_back({"r", program, "blue", "", {}, {source, {0, 9}}});
  out->robots = {{{1}, 0, {}}};
  out->units.push_back({"u", {{1}}, {}, {}});
  UnitCommand start;
  start.task = mission::Task::kStart;
  start.goal = {100.0, 100.0};
  start.place = {source, {14, 20}};
  out->steps.push_back({"0", {start}, {}});
  UnitCommand go;
  go.goal = {300.0, 100.0};
  go.place = {source, {27, 33}};
  if (has_until) go.until = mission::MissionTime{};
  if (has_order) out->steps.push_back({"1", {go}, {}});
  return out;
}

std::unique_ptr<MissionRun> made(const std::shared_ptr<const mission::Mission>& mission,
                                 text::Diagnostics& sink, const RunSettings& settings = {}) {
  static const text::Files kInMemory = in_memory();
  robot::ProgramSources sources;
  sources.files = &kInMemory;
  return simulated::make_run(mission, sources, settings, sink);
}

std::string kinds_of(const std::string& program, bool has_order) {
  text::Diagnostics sink;
  EXPECT_NE(made(mission_of(program, has_order), sink), nullptr) << text::render(sink);
  std::string out;
  for (const text::Diagnostic& one : sink.items()) out += one.kind + " ";
  return out;
}

TEST(OrderCheck, WarnsOfOrdersThatAProgramNeverReportsOn) {
  EXPECT_EQ(kinds_of("wander.cdl", true), "never-reports ");
  EXPECT_EQ(kinds_of("told.cdl", true), "");
  EXPECT_EQ(kinds_of("sent.cdl", true), "");
  EXPECT_EQ(kinds_of("robot", true), "");
}

TEST(OrderCheck, WarnsOfRobotsThatTakeNoPartInWhatAUnitShares) {
  for (const auto& [program, kinds] : {std::pair{"told.cdl", "never-shares "},
                                       {"wander.cdl", "never-reports "},
                                       {"mrv2", "never-reports "},
                                       {"robot", ""}}) {
    text::Diagnostics sink;
    auto mission = mission_of(program, true);
    auto& visit = std::get<UnitCommand>(mission->steps.back().commands.front());
    visit.task = mission::Task::kVisit;
    visit.route = {visit.goal};
    EXPECT_NE(made(mission, sink), nullptr) << text::render(sink);
    std::string told;
    for (const text::Diagnostic& one : sink.items()) told += one.kind + " ";
    EXPECT_EQ(told, kinds) << program;
  }
}

TEST(OrderCheck, WarnsNotOfOrdersThatEndAtATime) {
  text::Diagnostics sink;
  EXPECT_NE(made(mission_of("wander.cdl", true, true), sink), nullptr);
  EXPECT_EQ(sink.items().size(), 0U) << text::render(sink);
}

TEST(OrderCheck, WarnsOfRobotsThatAreOnlyStartedAndActByThemselves) {
  EXPECT_EQ(kinds_of("wander.cdl", false), "only-started ");
  EXPECT_EQ(kinds_of("robot", false), "") << "the standard robot stands";
}

TEST(MissionRun, GoesOnAfterItIsDoneWhereThatIsWanted) {
  text::Diagnostics sink;
  const auto mission = mission_of("wander.cdl", false);
  const auto ends = made(mission, sink);
  RunSettings settings;
  settings.goes_on_when_done = true;
  const auto goes_on = made(mission, sink, settings);
  for (MissionRun* run : {ends.get(), goes_on.get()}) {
    run->post(mission::event::Execute{});
    for (int i = 0; i < 100; ++i) run->step();
  }
  EXPECT_TRUE(goes_on->is_over());
  EXPECT_NEAR(goes_on->time(), 10.0, 0.2);
  EXPECT_LT(ends->time(), 1.0);
  const auto x_of = [](const MissionRun& run) {
    return run.fleet().pose(run.fleet().robots().front()).position.x;
  };
  EXPECT_GT(x_of(*goes_on), x_of(*ends) + 5.0);
}

TEST(MissionRun, ShowsARobotToTheOthersAsItsColourSays) {
  for (const char* color : {"red", "blue", "pink"}) {
    auto mission = mission_of("guard.cdl", false);
    mission->types.push_back({"other", "robot", color, "", {}, {}});
    mission->robots.push_back({{2}, 1, {}});
    mission->units.push_back({"others", {{2}}, {}, {}});
    UnitCommand start = std::get<UnitCommand>(mission->steps[0].commands[0]);
    start.unit = 1;
    start.goal = {100.0, 120.0};
    mission->steps[0].commands.emplace_back(start);
    text::Diagnostics sink;
    RunSettings settings;
    settings.goes_on_when_done = true;
    const auto run = made(mission, sink, settings);
    ASSERT_NE(run, nullptr) << text::render(sink);
    run->post(mission::event::Execute{});
    for (int i = 0; i < 50; ++i) run->step();
    const double x = run->fleet().pose(*run->fleet().find({1})).position.x;
    EXPECT_EQ(x > 102.0, std::string_view(color) == "red") << color << " at " << x;
  }
}

}  // namespace
}  // namespace mlab::run
