// What is exported means the same elsewhere: interpreters that are not ours are in the robot's states, cycle
// by cycle.

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "author.h"
#include "mlab/base/hash.h"
#include "mlab/base/testing/source_folder.h"
#include "mlab/export/format.h"
#include "mlab/flow/program.h"
#include "mlab/robot/program/brought_code.h"
#include "mlab/robot/program/configuration_file.h"
#include "mlab/text/testing/golden.h"

namespace mlab {
namespace {

namespace fs = std::filesystem;
namespace golden = text::testing;
using Json = nlohmann::json;

const fs::path kFolder = fs::path(base::source_folder()) / "tests/exports";
constexpr int kCycles = 40;

struct Robot {
  robot::ConfiguredRobot configured;
  std::shared_ptr<robot::DescribedLibrary> library;

  std::optional<std::string> written(const std::string& format, text::Diagnostics& sink) const {
    const exports::Subject subject{configured.configuration,
                                   *configured.configuration.robots.at(configured.robot),
                                   configured.lowered.network, library->library};
    return exports::find_format(format)->write(subject, sink);
  }
};

std::optional<Robot> robot_of(const text::SourcePtr& source, text::Diagnostics& sink,
                              std::string_view name = "") {
  auto configured = robot::configure(source, name, "", {}, {}, sink);
  if (!configured) return std::nullopt;
  auto library = robot::describe_library(configured->configuration.procedures);
  return Robot{std::move(*configured), std::move(library)};
}

/// A robot that ran, and what it was told and did in each cycle.
struct Trace {
  Robot robot;
  std::vector<std::string> told;                   ///< the notifications that were there: "abd"
  std::vector<std::vector<std::string>> states;    ///< active ones, sorted
  std::vector<std::map<std::string, bool>> truth;  ///< of everything that is one, by path
};

// The program says of each sequence where it is, also of those that do not run because a state around them is
// not active. These run, sorted.
std::vector<std::string> running(const std::vector<std::string>& all) {
  const std::set<std::string> active(all.begin(), all.end());
  std::set<std::string> sequences;
  for (const std::string& state : all) sequences.insert(state.substr(0, state.rfind('.')));
  std::vector<std::string> out;
  for (const std::string& state : active) {
    bool runs = true;
    for (std::size_t at = state.rfind('.'); at != std::string::npos && at > 0;
         at = state.rfind('.', at - 1)) {
      const std::string around = state.substr(0, at);
      const bool is_state =
          around.rfind('.') != std::string::npos && sequences.contains(around.substr(0, around.rfind('.')));
      if (is_state && !active.contains(around)) runs = false;
    }
    if (runs) out.push_back(state);
  }
  return out;
}

Trace run_of(std::uint64_t seed, bool is_parallel) {
  exports_test::Author author(seed, is_parallel);
  const auto source = std::make_shared<const text::Source>("made_up.cdl", author.configuration());
  text::Diagnostics sink;
  auto robot = robot_of(source, sink);
  if (!robot) {
    ADD_FAILURE() << text::render(sink) << source->text();
    std::abort();
  }
  Trace out{std::move(*robot), {}, {}, {}};
  const flow::Program& program = *out.robot.configured.built.program;
  flow::Frame frame = program.make_frame();
  for (int cycle = 0; cycle < kCycles; ++cycle) {
    std::string flags;
    std::vector<std::uint64_t> inbox;
    for (const char* name : {"a", "b", "c", "d"}) {
      if (!author.flag()) continue;
      flags += name;
      inbox.push_back(base::hash_text(name));
    }
    std::ranges::sort(inbox);
    percept::Percepts percepts;
    percepts.notifications = inbox;
    percept::Action action;
    program.step(frame.data(), percepts, action, 1, 1);
    out.told.push_back(flags);
    out.states.push_back(running(program.active_states(frame.data())));
    std::map<std::string, bool>& truth = out.truth.emplace_back();
    for (const flow::Port& port : program.ports()) {
      if (port.type != nullptr && port.type->name == "bool")
        truth[port.path] = flow::Program::print(frame.data(), port) == "true";
    }
  }
  return out;
}

struct Answer {
  int status = -1;
  std::string output;
};

Answer answer_of(const std::string& command) {
  Answer answer;
  std::FILE* pipe = popen((command + " 2>&1 </dev/null").c_str(), "r");
  if (pipe == nullptr) return answer;
  std::array<char, 4096> block{};
  for (std::size_t n = 0; (n = fread(block.data(), 1, block.size(), pipe)) > 0;)
    answer.output.append(block.data(), n);
  answer.status = pclose(pipe);
  return answer;
}

bool is_there(const char* command) {
  return answer_of(fmt::format("command -v {}", command)).status == 0;
}

class Exports : public testing::Test {
 protected:
  Exports() : folder_(fs::path(testing::TempDir()) / fmt::format("mlab_exports_test_{}", ::getpid())) {
    fs::create_directories(folder_);
  }
  ~Exports() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  std::string put(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  // Of run_btcpp.mjs, one for each case.
  Json results_of(const Json& cases) const {
    const Answer answer = answer_of(
        fmt::format("node '{}' '{}'", (kFolder / "run_btcpp.mjs").string(), put("trees.json", cases.dump())));
    EXPECT_EQ(answer.status, 0) << answer.output;
    return Json::parse(answer.output, nullptr, false);
  }
  const fs::path folder_;
};

// `movement.S1`, `movement.S1.S0`: S1/S0.
std::string names_of(std::vector<std::string> states) {
  std::ranges::sort(states, {}, &std::string::size);
  std::vector<std::string> names;
  for (const std::string& state : states) names.push_back(state.substr(state.rfind('.') + 1));
  return fmt::format("{}\n", fmt::join(names, "/"));
}

TEST_F(Exports, APlanExecutedByALispIsInTheStatesOfTheRobot) {
  if (!is_there("clisp")) GTEST_SKIP() << "clisp is not here: apt-get install clisp, or ./mlab test";
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const Trace run = run_of(seed, false);
    text::Diagnostics sink;
    const auto plan = run.robot.written("sausages", sink);
    ASSERT_TRUE(plan) << text::render(sink);
    std::string cycles;
    std::string expected;
    for (int i = 0; i < kCycles; ++i) {
      const std::string& flags = run.told[static_cast<std::size_t>(i)];
      cycles += "(";
      for (const char flag : flags) cycles += fmt::format(" (is-notified (message \"{}\"))", flag);
      cycles += ")\n";
      expected += names_of(run.states[static_cast<std::size_t>(i)]);
    }
    const Answer answer =
        answer_of(fmt::format("clisp -q -q -norc '{}' '{}' '{}'", (kFolder / "sausages.lisp").string(),
                              put("plan.lisp", *plan), put("cycles.lisp", cycles)));
    EXPECT_EQ(answer.output, expected) << *plan;
    EXPECT_EQ(answer.status, 0);
  }
}

TEST_F(Exports, ABehaviorTreeExecutedByAnotherInterpreterIsInTheStatesOfTheRobot) {
  if (!is_there("node")) GTEST_SKIP() << "node is not here: apt-get install nodejs, or ./mlab test";
  Json cases = Json::array();
  std::vector<std::vector<std::string>> expected;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Trace run = run_of(seed, false);
    text::Diagnostics sink;
    const auto tree = run.robot.written("btcpp", sink);
    ASSERT_TRUE(tree) << text::render(sink);
    Json cycles = Json::array();
    for (const std::string& flags : run.told) {
      Json& messages = cycles.emplace_back(Json::array());
      for (const char flag : flags) messages.push_back(std::string(1, flag));
    }
    cases.push_back({{"tree", *tree}, {"cycles", cycles}});
    for (std::vector<std::string>& names = expected.emplace_back(); const auto& states : run.states) {
      names.push_back(names_of(states));
      names.back().pop_back();
    }
  }
  const Json results = results_of(cases);
  ASSERT_EQ(results.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_EQ(results[i], Json(expected[i])) << "seed " << i + 1 << "\n"
                                             << cases[i]["tree"].get<std::string>();
}

// A robot that is called as one of its skills is; skills and inputs with names that the library keeps; texts
// that would be names on the blackboard.
constexpr const char* kAwkward = R"(
class Cart { actuator wheels: Drive() binds movement; }
assemblage Sequence(name: text, _skipIf: gain = 1) -> Vector { cooperate { _skipIf: Stand(); 1: Noise(); } }
assemblage Delay(ID: text = "{=}", portable: text = "=") -> Vector { cooperate { Stand(); Noise(); } }
assemblage TrueNorth() -> Vector { cooperate { Stand(); Noise(); } }
robot trueNorth is Cart {
  movement = sequence {
    start A: Sequence("{a}", 2);
      when IsNotified(message = "{a}") goto B;
    B: Delay();
      when IsNotified(message = " {b} ") goto C;
    C: sequence {
      start D: TrueNorth();
        when IsNotified(message = "=") goto E;
      E: Stand();
    };
  };
}
robot TrueNorth is Cart { movement = sequence { start A: TrueNorth(); when IsNotified(message = "a") goto A restart; }; }
)";

TEST_F(Exports, NamesAndTextsThatTheLibraryOfBehaviorTreesKeepsForItselfPassItsParser) {
  if (!is_there("node")) GTEST_SKIP() << "node is not here: apt-get install nodejs, or ./mlab test";
  Json cases = Json::array();
  for (const char* name : {"trueNorth", "TrueNorth"}) {
    text::Diagnostics sink;
    const auto robot = robot_of(std::make_shared<const text::Source>("awkward.cdl", kAwkward), sink, name);
    ASSERT_TRUE(robot) << text::render(sink);
    const auto tree = robot->written("btcpp", sink);
    ASSERT_TRUE(tree) << text::render(sink);
    cases.push_back({{"tree", *tree}, {"cycles", {Json::array(), {"{b}"}, {"{a}"}, {" {b} "}, {"="}}}});
  }
  const Json results = results_of(cases);
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0], Json({"A", "A", "B", "C/D", "C/E"})) << cases[0]["tree"].get<std::string>();
  EXPECT_TRUE(results[1].is_array()) << results[1] << cases[1]["tree"].get<std::string>();
}

// What would be wrong with a tree, and what BehaviorTree.CPP 4.7 to 4.9 says of it.
struct Refused {
  const char* tree;
  const char* why;
};
const Refused kRefused[] = {
    {R"(<ReactiveSequence><Action ID="Wander"/></ReactiveSequence>)", "Unknown node type: Action"},
    {R"(<Sequence><Condition ID="IsNear"/></Sequence>)", "Unknown node type: Condition"},
    {R"(<Wander ID="Wander"/>)", "Attribute [ID] is not allowed in <Wander>"},
    {R"(<Action/>)", "The tag <Action> must have the attribute [ID]"},
    {R"(<Climb/>)", "Node not recognized: Climb"},
    {R"(<Wander gian="1"/>)", "a port with name [gian]"},
    {R"(<Wander _gain="1"/>)", "the attribute [_gain] would be dropped"},
    {R"(<Wander gain="1" gain="2"/>)", "gain stands twice"},
    {R"(<Wander><IsNear/></Wander>)", "The node 'Wander' must not have any child"},
    {R"(<Sequence/>)", "The node 'Sequence' must have 1 or more children"},
    {R"(<Inverter><IsNear/><IsNear/></Inverter>)", "The node 'Inverter' must have exactly 1 child"},
    {R"(<Wander/><Wander/>)", "The tag <BehaviorTree> with ID 'T' must have exactly 1 child"},
    {R"(<SubTree ID="Wander"/>)", "must not use the name of a registered Node"},
    {R"(<Script code="trueNorth:='A'"/>)", "Error in the script"},
    {R"(<Script code="a:='it's'"/>)", "Error in the script"},
    {R"(<Sequence><Wander/>)", "Error parsing the XML"},
};
constexpr const char* kModels =
    R"(<Action ID="Wander"><input_port name="gain"/></Action><Condition ID="IsNear"/>)";

std::string tree_file(const char* id, const std::string& inside, const std::string& models) {
  return fmt::format(
      R"(<root BTCPP_format="4" main_tree_to_execute="T"><BehaviorTree ID="{}">{}</BehaviorTree>)"
      R"(<TreeNodesModel>{}</TreeNodesModel></root>)",
      id, inside, models);
}

TEST_F(Exports, TheInterpreterRefusesWhatTheLibraryOfBehaviorTreesRefuses) {
  if (!is_there("node")) GTEST_SKIP() << "node is not here: apt-get install nodejs, or ./mlab test";
  const std::string models = kModels;
  Json cases = Json::array();
  std::vector<std::string> expected;
  const auto add = [&](const std::string& tree, const std::string& why) {
    cases.push_back({{"tree", tree}, {"cycles", Json::array()}});
    expected.push_back(why);
  };
  for (const Refused& one : kRefused) add(tree_file("T", one.tree, models), one.why);
  add(tree_file("Wander", "<Wander/>", models), "must not use the name of a registered Node");
  add(tree_file("Other", "<Wander/>", models), "Can't find a tree with name: T");
  add(tree_file("T", "<Wander/>", models + R"(<Action ID="Delay"/>)"), "ID [Delay] already registered");
  for (const char* port : {"name", "ID", "_while", "1st"}) {
    add(tree_file("T", "<A/>", fmt::format(R"(<Action ID="A"><input_port name="{}"/></Action>)", port)),
        "The name of a port must not be");
  }
  add(R"(<tree BTCPP_format="4"/>)", "The XML must have a root node called <root>");
  add(R"(<root BTCPP_format="4"><TreeNodesModel/><TreeNodesModel/></root>)",
      "Only a single node <TreeNodesModel> is supported");
  add(tree_file("T", R"(<Sequence><Wander gain="1"/></Sequence>)", models), "");
  const Json results = results_of(cases);
  ASSERT_EQ(results.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const std::string why = results[i].is_object() ? results[i]["refused"].get<std::string>() : "";
    EXPECT_EQ(why.empty(), expected[i].empty()) << why << cases[i]["tree"];
    EXPECT_NE(why.find(expected[i]), std::string::npos) << why << cases[i]["tree"];
  }
}

TEST_F(Exports, AStateChartExecutedByAnotherInterpreterIsInTheStatesOfTheRobot) {
  if (!fs::is_directory(fs::path(MLAB_SCXML_FOLDER) / "node_modules"))
    GTEST_SKIP() << "no SCXML interpreter in " << MLAB_SCXML_FOLDER << ": ./mlab test --only e2e installs it";
  Json cases = Json::array();
  std::vector<Trace> runs;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Trace run = run_of(seed, seed % 2 == 0);
    text::Diagnostics sink;
    const auto chart = run.robot.written("scxml", sink);
    ASSERT_TRUE(chart) << text::render(sink);
    cases.push_back({{"scxml", *chart}, {"cycles", run.truth}});
    runs.push_back(std::move(run));
  }
  const Answer answer = answer_of(fmt::format("node '{}' '{}' '{}'", (kFolder / "run_scxml.mjs").string(),
                                              MLAB_SCXML_FOLDER, put("cases.json", cases.dump())));
  ASSERT_EQ(answer.status, 0) << answer.output;
  const Json results = Json::parse(answer.output, nullptr, false);
  ASSERT_EQ(results.size(), runs.size()) << answer.output;
  std::size_t changes = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (std::size_t cycle = 0; cycle < kCycles; ++cycle) {
      ASSERT_EQ(results[i][cycle]["doing"], results[i][cycle]["states"])
          << cases[i]["scxml"].get<std::string>();
      ASSERT_EQ(results[i][cycle]["states"].get<std::vector<std::string>>(), runs[i].states[cycle])
          << "seed " << i + 1 << ", cycle " << cycle << "\nbefore: "
          << fmt::format("{}\nis so: {}\n", runs[i].states[cycle == 0 ? 0 : cycle - 1], runs[i].truth[cycle])
          << cases[i]["scxml"].get<std::string>();
      changes += cycle > 0 && runs[i].states[cycle] != runs[i].states[cycle - 1] ? 1 : 0;
    }
  }
  EXPECT_GT(changes, 300U) << "something happens in them";
}

TEST_F(Exports, GraphvizReadsTheDrawing) {
  if (!is_there("dot")) GTEST_SKIP() << "dot is not here: apt-get install graphviz, or ./mlab test";
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    text::Diagnostics sink;
    const auto drawing = run_of(seed, true).robot.written("dot", sink);
    ASSERT_TRUE(drawing) << text::render(sink);
    const Answer answer = answer_of(fmt::format("dot -Tsvg '{}'", put("drawing.dot", *drawing)));
    EXPECT_EQ(answer.status, 0) << answer.output;
    EXPECT_NE(answer.output.find("</svg>"), std::string::npos);
  }
}

TEST_F(Exports, TheGraphNamesWhatTheProgramHas) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Trace run = run_of(seed, true);
    text::Diagnostics sink;
    const auto text = run.robot.written("graph", sink);
    ASSERT_TRUE(text) << text::render(sink);
    const Json graph = Json::parse(*text, nullptr, false);
    ASSERT_TRUE(graph.is_object()) << *text;
    EXPECT_EQ(graph["nodes"].size(), run.robot.configured.lowered.network.nodes.size());
  }
}

// A file's name says the format: `btcpp_loop.cdl` is for btcpp.
TEST(ExportGoldens, GiveWhatStandsAtTheEndOfEachFile) {
  for (const fs::path& path : golden::golden_files(kFolder / "testdata", ".cdl")) {
    golden::check_golden(path, "//", [&](const text::SourcePtr& source) {
      const std::string stem = path.stem().string();
      text::Diagnostics sink;
      const auto robot = robot_of(source, sink);
      if (!robot) return text::render(sink);
      text::Diagnostics said;
      const auto out = robot->written(stem.substr(0, stem.find('_')), said);
      return out.value_or("") + text::render(said);
    });
  }
}

TEST(ExportGoldens, ShowEveryKindOfDiagnostic) {
  auto shown = golden::kinds_expected_in(golden::golden_files(kFolder / "testdata", ".cdl"));
  shown.insert("nested-too-deep");  // takes a file 200 sequences deep
  for (const std::string& kind :
       golden::kinds_said_in(fs::path(base::source_folder()) / "src/mlab/export", {"error(", "warning("}))
    EXPECT_TRUE(shown.contains(kind)) << kind;
}

}  // namespace
}  // namespace mlab
