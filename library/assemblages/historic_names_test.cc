// Every state and trigger of the historic AuRA, AuRA.urban and AuRA.naval libraries has its component here,
// which runs and which has a test of its own; or the documentation says why there is none.

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "mlab/base/testing/source_folder.h"
#include "mlab/lang/cdl_historic/library_names.h"

#include "../testing/trial.h"

namespace mlab::library_test {
namespace {

namespace fs = std::filesystem;

// A name of the catalog and the component with which a configuration says the same today.
struct Counterpart {
  const char* historic;
  const char* ours;
};

constexpr Counterpart kStates[] = {
    {"AboutFace", "AboutFace()"},
    {"Alert", "Alert(subject = \"fire\", message = \"in the hall\")"},
    {"CARMEN_GoTo", "GoTo(goal = [3 m, 2 m], avoid_obstacle_gain = 1, avoid_obstacle_sphere = 3 m)"},
    {"CNP_BidOnTask", "BidOnTask()"},
    {"CNP_ExecuteWonTask", "ExecuteTask()"},
    {"CNP_InjectTask", "AnnounceTask(task = \"EODTask\")"},
    {"CNP_NotifyTaskCompleted", "ReportResult(reneged = false)"},
    {"CNP_NotifyTaskReneged", "ReportResult(reneged = true)"},
    {"CNP_NotifyWonTaskStarted", "StartTask()"},
    {"CNP_SaveDynConstraints_Track", "TellTarget()"},
    {"CNP_SaveTargetLocation", "NotifyRobots_ObjectLocation()"},
    {"CNP_SaveTargetVehicleType", "Stand()"},
    {"CNP_SaveTargetVelocity", "Stand()"},
    {"ChangeRobotColor", "ChangeRobotColor(color = \"blue\")"},
    {"DropObject", "PutInBasket(classes = Basket)"},
    {"EnterRoom", "EnterRoom()"},
    {"Follow", "Follow()"},
    {"FollowCMDLiCommands", "FollowCommands()"},
    {"FollowCSBAdvise", "FollowSignalAdvice()"},
    {"GoTo", "GoTo(goal = [3 m, 2 m])"},
    {"GoToOutdoor_CBR", "GoTo(goal = [3 m, 2 m], avoid_obstacle_gain = 0.5)"},
    {"GoToSoundSource", "GoToSoundSource(volume = 1)"},
    {"GoTo_Dstar", "GoTo_Dstar(goal = [3 m, 2 m])"},
    {"GoTo_LM", "GoTo_LM(goal = [3 m, 2 m])"},
    {"InitiaizeCSB", "Stand()"},
    {"Intercept", "Intercept()"},
    {"LOS_GoTo", "GoTo(goal = [3 m, 2 m], avoid_obstacle_gain = 1)"},
    {"LeaveRoom", "LeaveRoom()"},
    {"Localize", "Localize(place = [1 m, 1 m])"},
    {"LookFor", "LookFor()"},
    {"MarkDoorway", "MarkDoorway()"},
    {"MarkObjectAs", "MarkObjectAs(classes = Mine)"},
    {"MoveAway", "MoveAway()"},
    {"MoveForward", "GoStraight()"},
    {"MoveTo", "MoveToward(classes = Mine)"},
    {"MoveToward", "MoveToward(classes = Mine)"},
    {"MoveToward_NotifiedObject", "MoveToward_NotifiedObject()"},
    {"Notify", "NotifySelf(message = \"done\")"},
    {"NotifyRobots", "Notify(message = \"done\")"},
    {"NotifyRobots_ObjectLocation", "NotifyRobots_ObjectLocation()"},
    {"PickUp", "PickUpObject()"},
    {"ProbeObject", "ProbeNearestObject()"},
    {"PutInEOD", "PutInBasket()"},
    {"ResetWorld", "Stand()"},
    {"Run_EODTask", "RunEODTask()"},
    {"Run_InspectTask", "RunInspectTask()"},
    {"Run_InterceptTask", "RunInterceptTask()"},
    {"Run_ObserveTask", "RunObserveTask()"},
    {"Run_TrackTask", "RunTrackTask()"},
    {"SetMobilityType", "Stand()"},
    {"SetRobotColorId", "Stand()"},
    {"Standby*", "Standby()"},
    {"Stop", "Stand()"},
    {"SurveyRoom*", "SurveyRoom()"},
    {"Terminate", "Halt()"},
    {"TerminateEnemy", "PickUpObject(classes = EnemyRobot, reach = 10 m)"},
    {"TerminateMission", "TerminateMission()"},
    {"TerminateObject", "PickUpObject(reach = 50 m)"},
    {"TrackTarget", "TrackTarget()"},
    {"UpdateCSBSensorData", "Stand()"},
    {"Wander", "Wander()"},
};

constexpr Counterpart kTriggers[] = {
    {"AboutFaceCompleted", "AboutFaceCompleted()"},
    {"Alerted", "AlertedOnce()"},
    {"AtDoorway", "AtDoorway()"},
    {"AtEndOfHall", "AtEndOfHall()"},
    {"AtGoal", "AtGoal(goal = [3 m, 2 m])"},
    {"AwayFrom", "AwayFrom(Mine)"},
    {"CNP_AuctionReady", "IsTaskOpen()"},
    {"CNP_IsAuctionEnded", "IsAuctionEnded()"},
    {"CNP_IsAuctionFailed", "IsAuctionFailed()"},
    {"CNP_LostTask", "IsTaskLost()"},
    {"CNP_TaskCompletionNotified", "IsTaskDone(task = \"EODTask\")"},
    {"CNP_TaskRenegingNotified", "IsTaskReneged(task = \"EODTask\")"},
    {"CNP_WonTask", "IsTaskAwarded()"},
    {"CNP_WonTaskIs", "IsTaskAwarded(task = \"EODTask\")"},
    {"Detect", "Detect(Mine)"},
    {"DetectMotivated", "DetectMotivated(Mine)"},
    {"DetectSound", "DetectSound()"},
    {"DetectSoundMotivated", "DetectSoundMotivated()"},
    {"FirstTime", "Constant()"},
    {"Holding", "Holding(Mine)"},
    {"Immediate", "Constant()"},
    {"InHallway", "InHallway()"},
    {"InRoom", "InRoom()"},
    {"MarkedDoorway", "MarkedDoorway()"},
    {"MessageSent", "Constant()"},
    {"MovedDistance", "MovedDistance()"},
    {"Near", "Near(Mine)"},
    {"NearNotifiedObject", "NearNotifiedObject()"},
    {"NotDetected", "NotDetected(Mine)"},
    {"NotHolding", "NotHolding(Mine)"},
    {"Notified", "NotifiedOnce(message = \"go\")"},
    {"Notified_ObjectLocation", "IsPlaceNotified()"},
    {"SigSense", "SigSense(key = 100)"},
    {"StrongCommSignal", "IsSignalStrong()"},
    {"TargetUntrackable", "NotDetected(EnemyRobot)"},
    {"TaskExited", "NotifiedOnce(message = \"go\")"},
    {"UnDetect", "NotDetected(Mine)"},
    {"Wait", "Wait()"},
    {"WeakCommSignal", "IsSignalWeak()"},
};

std::string callee(std::string_view call) {
  return std::string(call.substr(0, call.find('(')));
}

const Counterpart* counterpart(std::string_view historic) {
  const auto is_it = [&](const Counterpart& one) { return historic == one.historic; };
  const auto* state = std::ranges::find_if(kStates, is_it);
  if (state != std::end(kStates)) return state;
  const auto* trigger = std::ranges::find_if(kTriggers, is_it);
  return trigger == std::end(kTriggers) ? nullptr : trigger;
}

std::string read(const fs::path& path) {
  const std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

// Obstacles, objects and another robot, so that there is something to perceive.
sim::World lively_world() {
  sim::World world;
  world.discs.push_back({{4, 4}, 0.5});
  world.objects.push_back(
      {{1}, percept::ObjectClass::kMine, percept::ObjectStyle::kMovable, {3, 1}, 0.2, {}, {}});
  world.objects.push_back(
      {{2}, percept::ObjectClass::kBasket, percept::ObjectStyle::kContainer, {-2, 1}, 0.3, {}, {}});
  return world;
}

TEST(HistoricStates, RunAsStatesOfASequence) {
  for (const Counterpart& one : kStates) {
    SCOPED_TRACE(one.historic);
    Trial trial(std::string("sequence { start A: ") + one.ours +
                    "; when Wait(delay = 1 s) goto B; final B: NotifySelf(\"over\"); }",
                lively_world(), {{0, 0}, 0});
    trial.add({6, 0}, 0, 0.2);
    const bool ends = trial.run(3, [&] { return trial.has_heard("over"); });
    EXPECT_TRUE(ends);
  }
}

TEST(HistoricStates, FitTheDevicesOfEveryRobot) {
  for (const char* robot_class : {"MRV2", "Rover"}) {
    for (const Counterpart& one : kStates) {
      SCOPED_TRACE(std::string(one.historic) + " on " + robot_class);
      Trial trial(one.ours, lively_world(), {{0, 0}, 0}, robot_class);
      trial.run(0.5);
    }
  }
}

TEST(HistoricTriggers, RunAsTriggersOfASequence) {
  for (const Counterpart& one : kTriggers) {
    SCOPED_TRACE(one.historic);
    Trial trial(std::string("sequence { start A: Wander(); when ") + one.ours +
                    " or Wait(delay = 2 s) goto B; final B: NotifySelf(\"over\"); }",
                lively_world(), {{0, 0}, 0});
    EXPECT_TRUE(trial.run(4, [&] { return trial.has_heard("over"); }));
  }
}

// Whether a test file of the library speaks of the component: `TEST(Wander, ...)`, `probe("Halt")`, a call.
bool has_test(const std::string& tests, const std::string& component) {
  for (const std::string& sign : {"TEST(" + component + ",", "\"" + component + "\"", component + "("})
    if (tests.find(sign) != std::string::npos) return true;
  return false;
}

TEST(HistoricNames, HaveCounterpartsThatHaveTestsOfTheirOwn) {
  std::string tests;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(base::source_folder()) / "library")) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with("_test.cc") && name != "historic_names_test.cc") tests += read(entry.path());
  }
  for (const Counterpart& one : kStates) EXPECT_TRUE(has_test(tests, callee(one.ours))) << one.ours;
  for (const Counterpart& one : kTriggers) EXPECT_TRUE(has_test(tests, callee(one.ours))) << one.ours;
}

TEST(HistoricNames, AreImportedAsTheirCounterparts) {
  for (const cdl_historic::LibraryName& row : cdl_historic::library_names()) {
    const Counterpart* one = counterpart(row.historic);
    ASSERT_NE(one, nullptr) << row.historic;
    EXPECT_EQ(row.ours, callee(one->ours)) << row.historic;
  }
}

TEST(HistoricNames, AreDocumented) {
  const std::string page = read(fs::path(base::source_folder()) / "docs/assemblages.md");
  const auto says = [&](std::string_view name) { return page.find(name) != std::string::npos; };
  for (const cdl_historic::LibraryName& row : cdl_historic::library_names()) {
    std::string name(row.historic);
    if (name.ends_with('*')) name.pop_back();
    const bool is_family = name.starts_with("CNP_") || name.starts_with("Run_");
    EXPECT_TRUE(says("`" + name + "`") || (is_family && says("`" + name.substr(0, 4)))) << name;
  }
}

// Names in the first column of the catalog's tables of states and triggers.
std::set<std::string> names_in_catalog(const std::string& catalog) {
  std::set<std::string> out;
  std::istringstream lines(catalog);
  bool is_table = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("## "))
      is_table = line.find("usable as FSA states") != std::string::npos ||
                 line.find("usable in `if") != std::string::npos;
    if (!is_table || !line.starts_with("| ") || line.starts_with("| name")) continue;
    out.insert(line.substr(2, line.find(' ', 2) - 2));
  }
  return out;
}

TEST(HistoricNames, AreAllThatTheCatalogHas) {
  const fs::path path = fs::path(base::source_folder()) / "../shared/reference/library_catalog.md";
  if (!fs::exists(path)) GTEST_SKIP() << "the catalog is not beside the project";
  std::set<std::string> known;
  for (const cdl_historic::LibraryName& row : cdl_historic::library_names())
    known.insert(std::string(row.historic));
  const std::set<std::string> catalog = names_in_catalog(read(path));
  EXPECT_GT(catalog.size(), 80U);
  EXPECT_EQ(catalog, known);
}

}  // namespace
}  // namespace mlab::library_test
