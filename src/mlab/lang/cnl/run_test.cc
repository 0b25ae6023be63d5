#include <cstdio>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/flow/program.h"
#include "mlab/lang/cnl/check.h"
#include "mlab/lang/cnl/elaborate.h"
#include "mlab/lang/cnl/load.h"

// What mlab_add_procedures made of testdata/run.
// NOLINTBEGIN(misc-use-internal-linkage): they are defined in generated code
std::span<const mlab::flow::Behavior* const> mlab_cnl_test_behaviors();
std::span<const mlab::flow::Behavior* const> mlab_cnl_state();
// NOLINTEND(misc-use-internal-linkage)

namespace mlab::cnl {
namespace {

/// A file's own network, on its own compiled procedures.
struct Robot {
  text::Diagnostics sink;
  flow::Library library;
  std::shared_ptr<const flow::Program> program;
  flow::Frame frame;
  percept::Percepts percepts;
  percept::Action action;

  explicit Robot(const std::string& file) {
    const std::string path = base::source_folder() + "/src/mlab/lang/cnl/testdata/run/" + file;
    const Tree tree = load(*text::read_source(path), sink);
    check_declarations(tree, sink);
    library.add(mlab_cnl_test_behaviors());
    program = flow::build_program(elaborate(tree, sink), library, sink);
    EXPECT_FALSE(sink.has_errors()) << text::render(sink);
    if (program) frame = program->make_frame();
  }
  void step() {
    action = {};
    program->step(frame.data(), percepts, action, 1, 1);
    percepts.time += percepts.cycle_duration;
  }
  template <class T>
  const T& value(std::string_view path) const {
    return *reinterpret_cast<const T*>(frame.data() + program->find(path)->offset);
  }
  void set(std::string_view path, std::string_view text) {
    EXPECT_EQ(program->set(frame.data(), *program->find(path), text), std::nullopt);
  }
};

const flow::Behavior& behavior(const std::string& name) {
  for (const flow::Behavior* one : mlab_cnl_state()) {
    if (one->name == name) return *one;
  }
  ADD_FAILURE() << name;
  return *mlab_cnl_state().front();
}

TEST(CompiledProcedure, TheMinimalExampleCountsAndPrints) {
  Robot robot("minimal.cnl");
  testing::internal::CaptureStdout();
  for (int i = 0; i < 3; ++i) robot.step();
  std::fflush(stdout);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "1 1.5\n2 1.5\n3 1.5\n");
}

TEST(CompiledProcedure, TheReportsFigureTwoPullsToTheGoalWithFullStrength) {
  Robot robot("figure_2.cnl");
  robot.step();
  EXPECT_EQ(robot.action.velocity, (geom::Vector{0.6, 0.8, 0.0}));
  robot.set("goal", "{3, 4}");  // on the success circle
  robot.step();
  EXPECT_EQ(robot.action.velocity, geom::Vector{});
}

TEST(CompiledProcedure, OnceVariablesPersistWhenTheHeaderStartsAnew) {
  Robot robot("state.cnl");
  for (int i = 0; i < 3; ++i) robot.step();
  EXPECT_EQ(robot.value<geom::Vector>("active"), (geom::Vector{5 + 100 + 3, 3, 5}));
  robot.set("part", "2");
  robot.step();
  EXPECT_EQ(robot.value<geom::Vector>("active"), (geom::Vector{101, 1, 3}))
      << "the other node has a state of its own";
  robot.set("part", "1");
  robot.step();
  EXPECT_EQ(robot.value<geom::Vector>("active"), (geom::Vector{5 + 200 + 4, 1, 6}));
}

TEST(CompiledProcedure, TheHeaderKeepsEveryKindOfVariable) {
  Robot robot("state.cnl");
  robot.step();
  const double constant = 2 + 7 + 3 + 9 + 10 + 0.5 + 12 + 1 + 13 + 14 + 3 + 1 + 20 + 30;
  const double plain = 1 + 2;  // two values are linked
  const double scaled = 1;     // captured before the header added to `plain`
  EXPECT_DOUBLE_EQ(robot.value<double>("everything"), constant + plain + scaled + 4);
  robot.step();  // the first body returned before it doubled
  EXPECT_DOUBLE_EQ(robot.value<double>("everything"), constant + plain + scaled + 4);
  robot.step();
  EXPECT_DOUBLE_EQ(robot.value<double>("everything"), constant + plain + scaled + 8);
}

TEST(CompiledProcedure, SeesTimeCycleAndRandomnessOfItsCycle) {
  Robot robot("state.cnl");
  robot.percepts.time = 50.0;
  robot.percepts.order.halted = true;
  robot.step();
  EXPECT_EQ(robot.action.velocity, (geom::Vector{0.0, 0.1, 1.0}));
  EXPECT_TRUE(robot.action.drives);
  const double first = robot.action.spin;
  robot.step();
  EXPECT_NEAR(robot.action.velocity.x, 0.1, 1e-9);
  EXPECT_NE(robot.action.spin, first);
  Robot again("state.cnl");
  again.step();
  EXPECT_EQ(again.action.spin, first);
}

TEST(CompiledProcedure, ReadingsFlowByIndexAndTypesOfItsOwnByValue) {
  Robot robot("state.cnl");
  const percept::Obstacle obstacles[] = {{{2, 0, 0}, 1.0}, {{9, 0, 0}, 1.0}};
  robot.percepts.obstacles = obstacles;
  robot.step();
  EXPECT_EQ(robot.value<int>("count"), 3);
  EXPECT_EQ(robot.value<int>("sum"), 15);
  EXPECT_EQ(robot.value<int>("names"), 28);
}

TEST(CompiledProcedure, ACopyOfTheFrameGoesOnFromThere) {
  Robot robot("state.cnl");
  for (int i = 0; i < 4; ++i) robot.step();
  const flow::Frame checkpoint = robot.frame;
  for (int i = 0; i < 4; ++i) robot.step();
  const flow::Frame later = robot.frame;
  robot.frame = checkpoint;
  robot.percepts.time = 0.4;
  for (int i = 0; i < 4; ++i) robot.step();
  EXPECT_EQ(robot.value<geom::Vector>("active"), (geom::Vector{5 + 100 + 8, 8, 10}));
  EXPECT_TRUE(robot.frame == later);
}

TEST(CompiledDescriptor, TellsWhatTheAuthorWrote) {
  const flow::Behavior& counters = behavior("Counters");
  EXPECT_EQ(counters.help,
            "How often it ran: in the whole run, since it last started, and the second entry of a table kept "
            "for the whole run.");
  EXPECT_EQ(counters.file, "state.cnl:12");
  EXPECT_EQ(counters.output->name, "Vector");
  ASSERT_EQ(counters.inputs.size(), 1U);
  EXPECT_EQ(counters.inputs[0].unit, "m");
  EXPECT_EQ(counters.inputs[0].help, "added to the first");
  EXPECT_EQ(counters.inputs[0].default_text, "0");
  EXPECT_TRUE(counters.has_header);
  EXPECT_EQ(counters.state_size, 5 * sizeof(int) + sizeof(int)) << "cycles, table, spare; since";
  EXPECT_EQ(behavior("Everything").state_alignment, 32U);
  EXPECT_FALSE(behavior("All").has_header);
  EXPECT_EQ(behavior("All").state_size, 0U);
  EXPECT_EQ(behavior("Watch").output, nullptr);
}

TEST(CompiledDescriptor, TellsSensorsAliasesAndTypes) {
  const flow::Behavior& context = behavior("Context");
  ASSERT_EQ(context.needs.size(), 2U);
  EXPECT_EQ(context.needs[0].sensor, percept::Sensor::kObstacles);
  EXPECT_EQ(context.needs[0].range_input, 0);
  EXPECT_EQ(context.needs[1].sensor, percept::Sensor::kRanges);
  EXPECT_EQ(context.inputs[0].max, 100.0);
  const flow::Behavior& sum = behavior("SumPair");
  EXPECT_TRUE(sum.is_pure);
  ASSERT_EQ(sum.aliases.size(), 1U);
  EXPECT_EQ(sum.aliases[0].name, "SUM_PAIR");
  EXPECT_EQ(sum.aliases[0].output_unit, "deg");
  EXPECT_EQ(sum.aliases[0].inputs[0].name, "p|value");
  ASSERT_EQ(sum.aliases[0].ignored_inputs.size(), 1U);
  EXPECT_EQ(sum.aliases[0].ignored_inputs[0], "old");
  EXPECT_EQ(sum.inputs[0].type->name, "Pair");
  EXPECT_EQ(sum.inputs[0].type->size, 8U);
}

}  // namespace
}  // namespace mlab::cnl
