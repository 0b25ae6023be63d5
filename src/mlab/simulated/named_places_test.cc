// Configurations that name places, in missions that have them.

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/run/mission_run.h"
#include "mlab/simulated/run.h"

namespace mlab::run {
namespace {

constexpr const char* kPlacesText =
    "class Cart { actuator wheels: Drive() binds movement; }\n"
    "robot R(home: Point = place(\"Gate\")) is Cart {\n"
    "  movement = cooperate { MoveToGoal(DetectGoal(home)); MoveToGoal(DetectGoal(place(\"PP-Mill\"))); "
    "};\n}\n";

overlay::ControlMeasure point_named(const char* name, geom::Point at) {
  overlay::ControlMeasure out;
  out.kind = overlay::MeasureKind::kPassagePoint;
  out.name = name;
  out.points = {at};
  return out;
}

struct PlacesMission {
  std::vector<mission::RobotParameter> parameters = {};
  bool has_gate = true;
};

std::shared_ptr<mission::Mission> mission_with_places(const PlacesMission& asked) {
  auto out = std::make_shared<mission::Mission>();
  const auto source = std::make_shared<const text::Source>("test.mdl", "NEW-ROBOT r x (home = y)\n");
  out->source = source;
  out->types.push_back({"r", "places.cdl", "blue", "", asked.parameters, {source, {12, 13}}});
  out->robots = {{{1}, 0, {}}};
  out->units.push_back({"u", {{1}}, {}, {}});
  if (asked.has_gate) out->overlay.measures.push_back(point_named("Gate", {10.0, 20.0}));
  out->overlay.measures.push_back(point_named("Mill", {30.0, 40.0}));
  out->overlay.origin = {1.0, 2.0};
  return out;
}

std::unique_ptr<MissionRun> run_with(const PlacesMission& asked, text::Diagnostics& sink) {
  static const text::Files kFiles = [] {
    text::Files out;
    out.is_file = [](const std::string&) { return true; };
    out.read = [](const std::string& path) -> text::Result<text::SourcePtr> {
      return std::make_shared<const text::Source>(path, kPlacesText);
    };
    return out;
  }();
  robot::ProgramSources sources;
  sources.files = &kFiles;
  return simulated::make_run(mission_with_places(asked), sources, {}, sink);
}

std::string value_in(const MissionRun& run, const char* path) {
  const auto workings = run.fleet().find({1})->workings();
  return flow::Program::print(workings.frame, *workings.program->find(path));
}

TEST(NamedPlace, IsWhereTheOverlayHasIt) {
  text::Diagnostics sink;
  const auto run = run_with({}, sink);
  ASSERT_NE(run, nullptr) << text::render(sink);
  EXPECT_EQ(value_in(*run, "home"), "{10, 20}");
  EXPECT_EQ(value_in(*run, "place_PP_Mill"), "{30, 40}");
}

TEST(NamedPlace, IsSetByTheMissionToAnotherOneOrToCoordinates) {
  text::Diagnostics sink;
  const auto named = run_with({.parameters = {{"home", "Mill", {}, {}}}}, sink);
  ASSERT_NE(named, nullptr) << text::render(sink);
  EXPECT_EQ(value_in(*named, "home"), "{30, 40}");
  const auto told = run_with({.parameters = {{"home", "5 6", {}, {}}}, .has_gate = false}, sink);
  ASSERT_NE(told, nullptr) << text::render(sink);
  EXPECT_EQ(value_in(*told, "home"), "{6, 8}");
}

TEST(NamedPlace, ThatIsNotThereIsToldWhereItIsNamed) {
  text::Diagnostics sink;
  EXPECT_EQ(run_with({.has_gate = false}, sink), nullptr);
  ASSERT_EQ(sink.items().size(), 1U);
  EXPECT_EQ(sink.items()[0].kind, "unknown-place");
  EXPECT_EQ(sink.items()[0].message, "the mission has no place `Gate`");
  EXPECT_EQ(sink.items()[0].place.source->text(sink.items()[0].place.span), "place(\"Gate\")");
  text::Diagnostics wrong;
  const auto set = std::make_shared<const text::Source>("--set", "home=Mil");
  EXPECT_EQ(run_with({.parameters = {{"home", "Mil", {set, {0, 4}}, {set, {5, 8}}}}}, wrong), nullptr);
  ASSERT_EQ(wrong.items().size(), 1U);
  EXPECT_EQ(wrong.items()[0].kind, "bad-parameter");
  EXPECT_EQ(set->text(wrong.items()[0].place.span), "Mil");
  EXPECT_EQ(wrong.items()[0].hints, std::vector<std::string>{"did you mean `Mill`?"});
}

TEST(NamedPlace, IsSetWhileTheRobotRuns) {
  text::Diagnostics sink;
  const auto run = run_with({}, sink);
  ASSERT_NE(run, nullptr);
  EXPECT_FALSE(run->set_parameter({1}, "home", "Mill").has_value());
  EXPECT_EQ(value_in(*run, "home"), "{30, 40}");
  EXPECT_FALSE(run->set_parameter({1}, "home", "{7, 8}").has_value());
  EXPECT_EQ(value_in(*run, "home"), "{7, 8}");
  EXPECT_TRUE(run->set_parameter({1}, "home", "Nowhere").has_value());
}

}  // namespace
}  // namespace mlab::run
