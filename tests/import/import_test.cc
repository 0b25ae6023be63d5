// Historic configurations become programs that run; the table of library names agrees with the library.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/fleet/fleet.h"
#include "mlab/flow/program.h"
#include "mlab/lang/cdl/print/format.h"
#include "mlab/lang/cdl/syntax/parser.h"
#include "mlab/lang/cdl_historic/import.h"
#include "mlab/lang/cdl_historic/layout.h"
#include "mlab/lang/cdl_historic/library_names.h"
#include "mlab/lang/cdl_historic/standing.h"
#include "mlab/percept/percepts.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/sim/simulated_binding.h"
#include "mlab/text/testing/golden.h"

namespace mlab {
namespace {

namespace fs = std::filesystem;

fs::path corpus() {
  const char* named = std::getenv("MLAB_CORPUS");  // NOLINT(concurrency-mt-unsafe): nobody sets it here
  return (named != nullptr ? fs::path(named) : fs::path(base::source_folder()) / "../shared/corpus") /
         "configurations";
}

const cdl_historic::Vocabulary& vocabulary() {
  static const cdl_historic::Vocabulary kVocabulary(robot::component_library(),
                                                    robot::library_environment().built_in);
  return kVocabulary;
}

// The file as a text of ours.
text::SourcePtr imported(const fs::path& path) {
  const auto source = text::read_source(path.string());
  if (!source) return nullptr;
  text::Diagnostics sink;
  std::string out = cdl_historic::import_as_text(*source, vocabulary(), sink);
  EXPECT_FALSE(sink.has_errors()) << text::render(sink);
  return std::make_shared<const text::Source>(path.filename().string(), std::move(out));
}

void expect_runs(const text::SourcePtr& source, const std::string& name) {
  text::Diagnostics sink;
  const auto robot = robot::configure(source, name, "", {}, {}, sink);
  ASSERT_TRUE(robot.has_value()) << name << "\n" << text::render(sink) << source->text();
  flow::Frame frame = robot->built.program->make_frame();
  percept::Percepts percepts;
  for (std::uint64_t cycle = 1; cycle <= 50; ++cycle) {
    percept::Action action;
    robot->built.program->step(frame.data(), percepts, action, cycle, 1);
  }
}

TEST(Import, EveryFileOfTheCorpusChecksAndItsRobotsRun) {
  if (!fs::is_directory(corpus())) GTEST_SKIP() << "no corpus at " << corpus();
  for (const fs::path& path : text::testing::golden_files(corpus(), ".cdl")) {
    const text::SourcePtr source = imported(path);
    ASSERT_NE(source, nullptr) << path;
    text::Diagnostics sink;
    robot::check_configuration(source, {}, sink);
    EXPECT_FALSE(sink.has_errors()) << path << "\n" << text::render(sink);
    if (sink.has_errors()) continue;
    text::Diagnostics again;
    for (const cdl::Item& item : cdl::parse(source, again).items) {
      if (const auto* robot = std::get_if<cdl::Robot>(&item)) expect_runs(source, robot->name.text);
    }
  }
}

// The importer's own examples hold every construct of the historic language, and every slip.
TEST(Import, WhateverTheImporterReadsChecks) {
  const fs::path folder = fs::path(base::source_folder()) / "src/mlab/lang/cdl_historic/testdata";
  int files = 0;
  for (const fs::path& path : text::testing::golden_files(folder, ".cdl")) {
    const auto whole = text::read_source(path.string());
    ASSERT_TRUE(whole.has_value()) << path;
    const std::string_view text = (*whole)->text();
    const auto historic = std::make_shared<const text::Source>(
        path.filename().string(), std::string(text.substr(0, text.find("// EXPECTED"))));
    text::Diagnostics sink;
    const std::string out = cdl_historic::import_as_text(historic, vocabulary(), sink);
    if (sink.has_errors()) continue;
    ++files;
    text::Diagnostics checked;
    robot::check_configuration(std::make_shared<const text::Source>("ours.cdl", out), {}, checked);
    EXPECT_FALSE(checked.has_errors()) << path << "\n" << text::render(checked) << out;
  }
  EXPECT_GE(files, 14);
}

TEST(Import, WritesTheCanonicalLayout) {
  if (!fs::is_directory(corpus())) GTEST_SKIP() << "no corpus at " << corpus();
  for (const fs::path& path : text::testing::golden_files(corpus(), ".cdl")) {
    const text::SourcePtr source = imported(path);
    text::Diagnostics sink;
    const auto formatted = cdl::format(source, sink);
    ASSERT_TRUE(formatted.has_value()) << text::render(sink);
    EXPECT_EQ(*formatted, source->text()) << path;
  }
}

TEST(Import, DrawsNothingOverSomethingElse) {
  if (!fs::is_directory(corpus())) GTEST_SKIP() << "no corpus at " << corpus();
  std::size_t boxes = 0;
  for (const fs::path& path : text::testing::golden_files(corpus(), ".cdl")) {
    text::Diagnostics sink;
    for (const cdl::Item& item : cdl::parse(imported(path), sink).items) {
      const auto* layout = std::get_if<cdl::Layout>(&item);
      if (layout == nullptr) continue;
      EXPECT_FALSE(layout->entries.empty()) << path;
      boxes += layout->entries.size();
      for (auto a = layout->entries.begin(); a != layout->entries.end(); ++a) {
        for (auto b = layout->entries.begin(); b != a; ++b) {
          EXPECT_TRUE(std::abs(a->x - b->x) >= cdl_historic::kNodeWidth - 1 ||
                      std::abs(a->y - b->y) >= cdl_historic::kNodeHeight - 1)
              << path << ": " << a->node.text << " and " << b->node.text;
        }
      }
    }
  }
  EXPECT_GT(boxes, 100U);
}

// What is missing in the robots of imported configurations.
struct Missing {
  int robots = 0;
  int with_stubs = 0;  // in a file that declares empty assemblages
  int standing = 0;    // moved by nothing, in some state or in all
  friend bool operator==(const Missing&, const Missing&) = default;
};

Missing missing_in(const text::SourcePtr& source) {
  text::Diagnostics sink;
  const cdl::Tree tree = cdl::parse(source, sink);
  Missing out;
  bool has_stubs = false;
  for (const cdl::Item& item : tree.items) {
    if (std::holds_alternative<cdl::Robot>(item)) ++out.robots;
    const auto* assemblage = std::get_if<cdl::Assemblage>(&item);
    has_stubs |= assemblage != nullptr && assemblage->body == nullptr;
  }
  if (has_stubs) out.with_stubs = out.robots;
  out.standing = static_cast<int>(cdl_historic::standing_robots(tree).size());
  return out;
}

// A catalog's names answered is what a user gets: robots that do something.
TEST(Import, LeavesNoRobotOfTheCorpusWithoutAPart) {
  if (!fs::is_directory(corpus())) GTEST_SKIP() << "no corpus at " << corpus();
  Missing all;
  for (const fs::path& path : text::testing::golden_files(corpus(), ".cdl")) {
    const Missing one = missing_in(imported(path));
    all = {all.robots + one.robots, all.with_stubs + one.with_stubs, all.standing + one.standing};
  }
  EXPECT_GE(all.robots, 41);
  EXPECT_EQ(all.with_stubs, 0);
  EXPECT_EQ(all.standing, 0);
}

// The console's robot finds an enemy and announces that he is to be tracked; the nearer bidder gets the task,
// follows him until the console ends that, and the mission is over.
TEST(Import, AHistoricTeamDividesItsTaskByTheContractNet) {
  const fs::path path = corpus() / "ao-fnc_demos__sample-type-I-track.cdl";
  if (!fs::exists(path)) GTEST_SKIP() << "no corpus at " << corpus();
  const text::SourcePtr source = imported(path);
  mission::Mission mission;
  mission::Unit unit;
  std::vector<robot::RobotProgram> programs;
  for (std::uint32_t id = 1; id <= 3; ++id) {
    text::Diagnostics sink;
    const auto made =
        robot::configure(source, "sample_type_I_trackRobot" + std::to_string(id), "", {}, {}, sink);
    ASSERT_TRUE(made.has_value()) << text::render(sink);
    robot::RobotProgram program;
    program.program = made->built.program;
    program.initial = program.program->make_frame();
    programs.push_back(std::move(program));
    mission::Robot robot;
    robot.id = {id};
    robot.type = id - 1;
    mission.robots.push_back(robot);
    unit.members.push_back({id});
  }
  mission.types.resize(3);
  mission.units.push_back(unit);
  sim::World world;
  world.objects.push_back(
      {{1}, percept::ObjectClass::kEnemyRobot, percept::ObjectStyle::kFixed, {90, 0}, 0.3, {}, {}});
  sim::SimulatedBinding bodies(world);
  fleet::Fleet fleet(mission, programs, std::vector<binding::BodySpec>(3), bodies, 1);
  for (const std::uint32_t id : {1U, 2U, 3U}) ASSERT_TRUE(fleet.start({id}, {{10.0 * id, 5.0 * id}, 0.0}));
  const auto task = [&] {
    const percept::Percepts told = fleet.perceive_at(*fleet.find({1}), {}, {}, 0.1);
    return told.contracts.empty() ? percept::Contract{} : told.contracts.front();
  };
  bool is_over = false;
  for (int cycle = 0; cycle < 3000 && !is_over; ++cycle) {
    fleet.step(0.1);
    is_over = task().state == percept::ContractState::kDone;
  }
  EXPECT_TRUE(is_over);
  EXPECT_EQ(task().contractor.value, 3U) << "the nearest";
  EXPECT_LT(geom::distance(fleet.pose(*fleet.find({3})).position, {90, 0}), 21.0);
  EXPECT_LT(geom::distance(fleet.pose(*fleet.find({2})).position, {20, 10}), 0.1) << "had no task";
}

// A configuration that uses a library name in its own place, with this value for all of its parameters.
text::SourcePtr using_the_name(const cdl_historic::LibraryName& row, const std::string& value) {
  const char* architecture = (row.architectures & cdl_historic::kUrban) != 0   ? "AuRA.urban"
                             : (row.architectures & cdl_historic::kNaval) != 0 ? "AuRA.naval"
                             : (row.architectures & cdl_historic::kAura) != 0  ? "AuRA"
                                                                               : "UGV";
  std::string group = "[ ";
  for (const cdl_historic::LibraryPort& port : row.ports) {
    if (!port.historic.empty()) group += "%" + std::string(port.historic) + " = {" + value + "}, ";
  }
  group += std::string(row.historic) + " ]<10,10>";
  const bool is_trigger = row.type == "bool";
  const std::string state = is_trigger ? "[ Stop ]" : group;
  const std::string trigger = is_trigger ? group : "[ FirstTime ]";
  return std::make_shared<const text::Source>(
      "uses_" + std::string(row.historic) + ".cdl",
      std::string("bindArch ") + architecture + ";\n" +
          "instBP<0,0> $W from movement( bound_to = base:DRIVE( max_vel = {" + value +
          "}, v = FSA( society[Start]<50,50>|Start| = [ Stop ], society[$A]<50,50>|A| = " + state +
          ", rules[Start]<50,50>|Start| = if " + trigger + " goto $A ) ) );\n" +
          "instBP<0,0> $V from vehicle( bound_to = r:MRV2( r:[ $W ] ) );\n[ $V ]\n");
}

TEST(Import, EveryLibraryNameChecksWhateverItsParametersAre) {
  for (const cdl_historic::LibraryName& row : cdl_historic::library_names()) {
    for (const char* value : {"1", "0", "-5", "1000000", "180", "2, 3", "Mines | Flags", "\"some text\"",
                              "word", "", "true", "-0.0001", "1e9", "nan", "{"}) {
      const text::SourcePtr historic = using_the_name(row, value);
      text::Diagnostics sink;
      const std::string out = cdl_historic::import_as_text(historic, vocabulary(), sink);
      ASSERT_FALSE(sink.has_errors()) << text::render(sink);
      const auto ours = std::make_shared<const text::Source>("ours.cdl", out);
      text::Diagnostics checked;
      robot::check_configuration(ours, {}, checked);
      ASSERT_FALSE(checked.has_errors()) << row.historic << " " << value << "\n"
                                         << text::render(checked) << out;
    }
  }
}

TEST(Import, EveryLibraryNameIsInTheLibraryWithItsParameters) {
  for (const cdl_historic::LibraryName& row : cdl_historic::library_names()) {
    const cdl_historic::Signature* ours = vocabulary().find(row.ours);
    ASSERT_NE(ours, nullptr) << row.historic << " should be " << row.ours;
    EXPECT_EQ(ours->result, row.type) << row.historic;
    for (const cdl_historic::LibraryPort& port : row.ports) {
      if (port.ours.empty() || port.ours == cdl_historic::kOnScreen) continue;  // means nothing here
      EXPECT_NE(ours->find(port.ours), nullptr)
          << row.historic << ": " << row.ours << " has no " << port.ours;
    }
  }
}

}  // namespace
}  // namespace mlab
