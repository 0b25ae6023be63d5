#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "mlab/lang/cnl/elaborate.h"
#include "mlab/lang/cnl/load.h"
#include "mlab/robot/program/robot_program.h"
#include "mlab/training/action_columns.h"
#include "mlab/training/seen_columns.h"

namespace mlab::training {
namespace {

using Names = std::vector<std::string>;

std::shared_ptr<const flow::Program> program_of(const char* text) {
  text::Diagnostics sink;
  const auto source = std::make_shared<const text::Source>("test.cnl", text);
  const flow::Network network = cnl::elaborate(cnl::load(source, sink), sink);
  auto program = flow::build_program(network, robot::component_library(), sink);
  EXPECT_TRUE(program) << text::render(sink);
  return program;
}

const std::shared_ptr<const flow::Program>& forward() {
  static const auto kForward = program_of(R"(
parameter double [m/s] cruise = 0.5 in 0 .. 2;   ///< how fast
parameter Vector wish = {1, 0};
node pull is MoveTo with goal = wish; nend
node drive is Drive with v = pull; max_velocity = cruise; nend
)");
  return kForward;
}

std::vector<std::string> names(const std::vector<Column>& columns) {
  std::vector<std::string> out;
  for (const Column& one : columns) out.push_back(one.name);
  return out;
}

TEST(SeenColumns, TakeVectorsApart) {
  const auto columns = SeenColumns::of(*forward(), Names{"wish", "cruise", "wish.y"}, {});
  ASSERT_TRUE(columns) << columns.error();
  EXPECT_EQ(names(columns->columns()), (Names{"wish.x", "wish.y", "wish.z", "cruise", "wish.y"}));
  std::array<double, 5> row{};
  columns->read(forward()->initial_frame().data(), {}, row.data());
  EXPECT_EQ(row, (std::array<double, 5>{1.0, 0.0, 0.0, 0.5, 0.0}));
}

TEST(SeenColumns, ShowBodies) {
  const auto columns = SeenColumns::of(*forward(), Names{"body.pose", "body.contacts", "body.ranges"},
                                       {.count = 2, .range = 1.0});
  ASSERT_TRUE(columns) << columns.error();
  EXPECT_EQ(names(columns->columns()),
            (Names{"body.x", "body.y", "body.heading", "body.contacts", "body.ranges.0", "body.ranges.1"}));
  EXPECT_EQ(columns->columns()[5].help,
            "from the body's surface to what is met at 3.14159 rad from ahead, counter-clockwise");
  EXPECT_EQ(columns->columns()[5].high, 1.0);
  const std::array<percept::RangeReading, 2> ranges = {{{0.0F, 0.25F, true}, {1.0F, 1.0F, false}}};
  std::array<double, 6> row{};
  columns->read(forward()->initial_frame().data(),
                {.pose = {{3.0, 4.0}, 1.5}, .contacts = 7.0, .driven = 0.0, .ranges = ranges}, row.data());
  EXPECT_EQ(row, (std::array<double, 6>{3.0, 4.0, 1.5, 7.0, 0.25, 1.0}));
}

TEST(SeenColumns, ABeamThatNobodySensedIsNoNumber) {
  const auto columns = SeenColumns::of(*forward(), Names{"body.ranges"}, {.count = 1});
  ASSERT_TRUE(columns) << columns.error();
  double beam = 0.0;
  columns->read(forward()->initial_frame().data(), {}, &beam);
  EXPECT_TRUE(std::isnan(beam));
}

TEST(SeenColumns, SayWhatThereIsInPlaceOfWhatThereIsNot) {
  const auto none = SeenColumns::of(*forward(), Names{"cruse"}, {});
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().find("has no port `cruse`; did you mean `cruise`?"), std::string::npos)
      << none.error();
  const auto bodiless = SeenColumns::of(*forward(), Names{"body.nope"}, {});
  ASSERT_FALSE(bodiless);
  EXPECT_TRUE(bodiless.error().starts_with("`body.nope`: of a body there are body.pose, "))
      << bodiless.error();
  const auto ringless = SeenColumns::of(*forward(), Names{"body.ranges"}, {});
  ASSERT_FALSE(ringless);
  EXPECT_EQ(ringless.error(), "`body.ranges`: the robot has no ring of range sensors");
}

TEST(ActionColumns, SetParameters) {
  const auto columns = ActionColumns::of(*forward(), Names{"wish", "cruise"}, false);
  ASSERT_TRUE(columns) << columns.error();
  EXPECT_EQ(names(columns->columns()), (Names{"wish.x", "wish.y", "wish.z", "cruise"}));
  EXPECT_EQ(columns->columns()[3].low, 0.0);
  EXPECT_EQ(columns->columns()[3].high, 2.0);
  flow::Frame frame = forward()->make_frame();
  const std::array<double, 4> row = {0.25, -1.0, 0.5, 1.5};
  ASSERT_FALSE(columns->refused(row.data()));
  columns->write(frame.data(), row.data());
  EXPECT_EQ(flow::Program::vector(frame.data(), *forward()->find("wish")), (geom::Vector{0.25, -1.0, 0.5}));
  EXPECT_EQ(flow::Program::number(frame.data(), *forward()->find("cruise")), 1.5);
}

TEST(ActionColumns, AreWrittenAsAPersonWritesThem) {
  const auto columns = ActionColumns::of(*forward(), Names{"wish", "cruise"}, false);
  ASSERT_TRUE(columns) << columns.error();
  const std::array<double, 4> row = {0.1, -1.0, 1e-9, 1.0 / 3.0};
  flow::Frame by_text = forward()->make_frame();
  flow::Frame by_bytes = forward()->make_frame();
  for (const ActionColumns::Value& value : columns->values())
    EXPECT_EQ(forward()->set(by_text.data(), *value.port, ActionColumns::text_of(value, row.data())),
              std::nullopt);
  columns->write(by_bytes.data(), row.data());
  EXPECT_EQ(by_text, by_bytes);
}

TEST(ActionColumns, RefuseWhatTheirPortsDoNotTake) {
  const auto columns = ActionColumns::of(*forward(), Names{"cruise"}, false);
  ASSERT_TRUE(columns) << columns.error();
  for (const double wrong :
       {-0.1, 2.5, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_EQ(columns->refused(&wrong), 0U) << wrong;
  EXPECT_EQ(columns->why_refused(0, 2.5), "2.5: `cruise` takes numbers from 0 to 2 m/s");
}

TEST(ActionColumns, AnglesAreInRadians) {
  const auto program = program_of(
      "parameter double [deg] aim = 10 in -90 .. 90;\nnode turn is Spin with rate = aim; nend\n"
      "node drive is DriveAndSpin with v = turn; nend\n");
  const auto columns = ActionColumns::of(*program, Names{"aim"}, false);
  ASSERT_TRUE(columns) << columns.error();
  EXPECT_DOUBLE_EQ(columns->columns()[0].high, std::numbers::pi / 2);
  EXPECT_EQ(columns->columns()[0].unit, "rad");
  const double most = columns->columns()[0].high;
  flow::Frame frame = program->make_frame();
  EXPECT_EQ(
      program->set(frame.data(), *program->find("aim"), ActionColumns::text_of(columns->values()[0], &most)),
      std::nullopt);
  EXPECT_DOUBLE_EQ(flow::Program::number(frame.data(), *program->find("aim")).value_or(0.0), most);
}

TEST(ActionColumns, HaveNoLimitsWhereTheirPortsHaveNone) {
  const auto program = program_of(
      "parameter double [deg] aim = 10;\nparameter double [m/s] cruise = 0.5;\n"
      "node turn is Spin with rate = aim; nend\n"
      "node drive is DriveAndSpin with v = turn; max_velocity = cruise; nend\n");
  const auto columns = ActionColumns::of(*program, Names{"aim", "cruise"}, false);
  ASSERT_TRUE(columns) << columns.error();
  for (const Column& one : columns->columns()) {
    EXPECT_EQ(one.low, -std::numeric_limits<double>::infinity()) << one.name;
    EXPECT_EQ(one.high, std::numeric_limits<double>::infinity()) << one.name;
  }
  const std::array<double, 2> endless = {1.0, std::numeric_limits<double>::infinity()};
  EXPECT_EQ(columns->refused(endless.data()), 1U);
  EXPECT_EQ(columns->why_refused(1, endless[1]), "inf: `cruise` takes numbers");
  const std::array<double, 2> more_than_ports_take = {1.0, 1e301};
  EXPECT_EQ(columns->refused(more_than_ports_take.data()), 1U);
  const std::array<double, 2> plain = {-7.0, 1e6};
  EXPECT_EQ(columns->refused(plain.data()), std::nullopt);
}

TEST(ActionColumns, HoldOutputsOnlyWhereThatIsAskedFor) {
  const auto refused = ActionColumns::of(*forward(), Names{"pull"}, false);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error(), "`pull` is the output of a node; here parameters and constants are set");
  EXPECT_FALSE(ActionColumns::of(*forward(), Names{"cruise", "cruise"}, true));
}

}  // namespace
}  // namespace mlab::training
