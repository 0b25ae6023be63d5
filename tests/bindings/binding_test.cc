// What every binding has to keep to, whatever is behind it.

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mlab/sim/simulated_binding.h"
#include "recorded.h"

namespace mlab::testing {
namespace {

constexpr double kCycle = 0.1;
const percept::Needs kNeeds{{percept::Sensor::kObstacles, 20.0},
                            {percept::Sensor::kRobots, 20.0},
                            {percept::Sensor::kObjects, 20.0},
                            {percept::Sensor::kRanges}};

std::unique_ptr<binding::Binding> simulated_bodies() {
  sim::World world;
  world.discs = {{{5.0, 0.0}, 1.0}};
  return std::make_unique<sim::SimulatedBinding>(std::move(world), sim::SimulatorSettings{1, 1});
}

binding::BodySetup setup_of(std::uint32_t robot) {
  binding::BodySetup out;
  out.robot = {robot};
  out.pose = {{0.0, 3.0 * robot}, 0.0};
  out.spec.ring = {.count = 8, .range = 5.0};
  out.spec.radio = {.range = 3.5, .loss = 0.5};
  return out;
}

percept::Percepts percepts_of(binding::Binding& bodies, binding::BodyIndex body) {
  percept::Percepts out;
  const binding::Sensing sensing{body, &kNeeds, &out};
  bodies.percepts({&sensing, 1}, 0);
  return out;
}

geom::Pose pose_of(const binding::Binding& bodies, binding::BodyIndex body) {
  geom::Pose out;
  bodies.poses({&body, 1}, {&out, 1});
  return out;
}

// Whether the first two hear each other, and what of the one comes to the other: `o`, `-`, or `x` where they
// don't.
std::string heard(binding::Binding& bodies) {
  const binding::RadioLinks* const links = bodies.radio();
  if (links == nullptr) return "all";
  std::string out = links->net_of({0}) == links->net_of({1}) ? "" : "x";
  for (const auto& [from, to] : {std::pair{0U, 1U}, {1U, 0U}})
    out += links->arrives({from}, {to}) ? 'o' : '-';
  return out;
}

// Two robots; the first drives ahead for twenty cycles, out of the other's reach, which stands.
// @return  what each heard of the other, cycle by cycle
std::vector<std::string> drive(binding::Binding& bodies) {
  std::vector<std::string> out;
  for (const std::uint32_t robot : {1U, 2U}) EXPECT_TRUE(bodies.embody(setup_of(robot)));
  std::vector<percept::Action> actions(2);
  actions[0].drives = true;
  actions[0].velocity.x = 1.0;
  for (int i = 0; i < 20; ++i) {
    std::vector<binding::Ailment> ailments;
    bodies.health(ailments);
    EXPECT_TRUE(ailments.empty());
    for (const std::uint32_t body : {0U, 1U}) percepts_of(bodies, {body});
    out.push_back(heard(bodies));
    bodies.carry_out(actions, kCycle);
  }
  return out;
}

struct Kind {
  const char* name;
  std::unique_ptr<binding::Binding> (*make)(const std::string& file);
};

std::unique_ptr<binding::Binding> recording_bodies(const std::string& file) {
  auto writer = recording::PerceptsWriter::create(file, 1, "");
  return writer ? std::make_unique<recording::RecordingBinding>(simulated_bodies(), std::move(*writer))
                : nullptr;
}

std::unique_ptr<binding::Binding> recorded_bodies(const std::string& file) {
  {
    auto writer = recording::PerceptsWriter::create(file, 1, "");
    const std::shared_ptr<recording::PerceptsWriter> shared = std::move(*writer);
    recording::RecordingBinding bodies(simulated_bodies(), shared);
    drive(bodies);
    EXPECT_FALSE(shared->finish());
  }
  auto reader = recording::PerceptsReader::open(file);
  return reader ? std::make_unique<recording::RecordedBinding>(std::move(*reader), 1) : nullptr;
}

class EveryBinding : public ::testing::TestWithParam<Kind> {
 protected:
  binding::Binding& bodies() { return *bodies_; }

 private:
  TemporaryFile file_{"percepts_of_binding"};
  std::unique_ptr<binding::Binding> bodies_ = GetParam().make(file_.path());
};

TEST_P(EveryBinding, GivesBodiesNumbersInOrderAndSaysWhatTheyAre) {
  for (const std::uint32_t robot : {1U, 2U}) {
    const auto placement = bodies().embody(setup_of(robot));
    ASSERT_TRUE(placement);
    EXPECT_EQ(placement->body.value, robot - 1);
    EXPECT_EQ(placement->pose, setup_of(robot).pose);
    EXPECT_EQ(bodies().capabilities(placement->body), binding::capabilities_of(setup_of(robot).spec));
  }
}

TEST_P(EveryBinding, CarriesOutWhatItIsToldAndLetsTimePass) {
  drive(bodies());
  EXPECT_NEAR(bodies().time(), 2.0, 1e-9);
  EXPECT_NEAR(pose_of(bodies(), {0}).position.x, 2.0, 1e-9);
  EXPECT_EQ(pose_of(bodies(), {1}), setup_of(2).pose) << "nothing was asked of it";
  EXPECT_NEAR(bodies().view().body({0}).distance_driven, 2.0, 1e-9);
  EXPECT_EQ(bodies().view().body({1}).velocity, geom::Offset{});
}

TEST_P(EveryBinding, SensesTheSameTwice) {
  const auto placement = bodies().embody(setup_of(1));
  ASSERT_TRUE(placement);
  std::vector<binding::Ailment> ailments;
  bodies().health(ailments);
  const percept::Percepts first = percepts_of(bodies(), placement->body);
  ASSERT_EQ(first.obstacles.size(), 1U);
  ASSERT_EQ(first.ranges.size(), 8U);
  const geom::Vector center = first.obstacles[0].center;
  const percept::Percepts again = percepts_of(bodies(), placement->body);
  EXPECT_EQ(again.obstacles[0].center, center);
  EXPECT_EQ(again.pose, placement->pose);
}

TEST_P(EveryBinding, ShowsItsWorld) {
  ASSERT_EQ(bodies().view().discs().size(), 1U);
  EXPECT_EQ(bodies().view().discs()[0].center, (geom::Point{5.0, 0.0}));
}

TEST_P(EveryBinding, TellsWhoHearsWhomAndWhatIsLost) {
  const std::vector<std::string> told = drive(bodies());
  EXPECT_EQ(told, drive(*simulated_bodies()));
  EXPECT_EQ(std::set(told.begin(), told.end()), (std::set<std::string>{"oo", "o-", "-o", "--", "x--"}));
}

TEST_P(EveryBinding, ForeseesPlacesAndChangesNothing) {
  const std::vector<binding::BodySetup> setups = {setup_of(1), setup_of(2)};
  const auto places = bodies().places_for(setups);
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[1], std::optional(setup_of(2).pose));
  const auto placement = bodies().embody(setup_of(1));
  ASSERT_TRUE(placement);
  EXPECT_EQ(placement->body.value, 0U);
}

TEST_P(EveryBinding, HasNoBodyMoreOnceItIsReleased) {
  drive(bodies());
  bodies().release({0});
  bodies().carry_out({}, kCycle);
  EXPECT_EQ(pose_of(bodies(), {1}), setup_of(2).pose);
}

INSTANTIATE_TEST_SUITE_P(
    Bindings, EveryBinding,
    ::testing::Values(Kind{"simulated", [](const std::string&) { return simulated_bodies(); }},
                      Kind{"recording", recording_bodies}, Kind{"recorded", recorded_bodies}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace mlab::testing
