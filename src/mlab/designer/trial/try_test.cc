#include <cstddef>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/designer/testing/live_desk.h"
#include "mlab/designer/trial/trial.h"
#include "mlab/robot/program/configuration_file.h"

namespace mlab::designer {
namespace {

using console::Status;
using testing::LiveDesk;

constexpr const char* kDrift =
    "assemblage Drift(push: gain = 0.8) {\n"
    "  cooperate {\n"
    "    push: Noise(persistence = 3 s);\n"
    "    1: AvoidStaticObstacles(readings = sense_obstacles(range = 3 m), sphere = 1.5 m, safety_margin = "
    "0.4 m);\n"
    "  }\n"
    "}\n";

std::shared_ptr<const Model> model_of_text(const std::string& text) {
  return std::make_shared<const Model>(std::make_shared<const text::Source>("/p/test.cdl", text),
                                       robot::library_environment());
}

text::Result<TrialConfiguration> completed(const std::string& text, const TrialWish& wish = {}) {
  return complete_for_trial(model_of_text(text), robot::library_environment(), wish);
}

std::string errors_of(const text::SourcePtr& source) {
  Model model(source, robot::library_environment());
  model.check();
  std::string out;
  for (const text::Diagnostic& d : model.problems().items()) {
    if (d.severity == text::Severity::kError) out += text::render(d);
  }
  return out;
}

TEST(Trial, GivesAnAssemblageABodyAndARobot) {
  const auto out = completed(kDrift);
  ASSERT_TRUE(out.has_value()) << out.error().message;
  EXPECT_TRUE(out->source->text().starts_with(kDrift));
  EXPECT_EQ(errors_of(out->source), "");
  ASSERT_EQ(out->robots.size(), 1U);
  EXPECT_EQ(out->robots[0].first, "TrialDrift");
  EXPECT_FALSE(out->notes.empty());
}

TEST(Trial, AssumesWhatAParameterWithoutDefaultCouldBe) {
  const auto out = completed(
      "assemblage Go(place: Vector, what: Object, near: length) {\n"
      "  cooperate { 1: MoveToGoal(goal = place, success_radius = near); 0: PickUp(object = what, reach = "
      "0.5 "
      "m); }\n"
      "}\n");
  ASSERT_TRUE(out.has_value()) << out.error().message;
  EXPECT_EQ(errors_of(out->source), "");
  EXPECT_EQ(out->notes.size(), 4U) << "three parameters and a body";
}

TEST(Trial, GivesAnAbstractRobotABody) {
  const std::string text =
      std::string(kDrift) + "robot R(speed: gain = 1) {\n  movement = Drift(push = speed);\n}\n// end\n";
  const auto out = completed(text, {"R", 3});
  ASSERT_TRUE(out.has_value()) << out.error().message;
  EXPECT_EQ(errors_of(out->source), "");
  EXPECT_EQ(out->robots[0], std::pair(std::string("R"), 3));
  // Places of the completed text are found again in the author's.
  for (const char* words : {"Noise", "robot R", "push = speed", "// end"}) {
    const auto there = static_cast<std::uint32_t>(out->source->text().find(words));
    EXPECT_EQ(place_before_trial(text, out->source->text(), there), text.find(words)) << words;
  }
}

TEST(Trial, TakesTheRobotsOfASociety) {
  const auto out =
      completed(std::string(kDrift) +
                "robot A is Scout { movement = Drift(); }\nrobot B is MRV2 { movement = Drift(); }\n"
                "society S: caste { team of 2 A; B; };\n");
  ASSERT_TRUE(out.has_value()) << out.error().message;
  ASSERT_EQ(out->robots.size(), 2U);
  EXPECT_EQ(out->robots[0], std::pair(std::string("A"), 2));
  EXPECT_EQ(out->robots[1], std::pair(std::string("B"), 1));
}

TEST(Trial, SaysWhyNothingCanBeTried) {
  EXPECT_NE(completed("").error().message.find("nothing to run yet"), std::string::npos);
  EXPECT_NE(completed(kDrift, {"Fly", 1}).error().message.find("`Fly`"), std::string::npos);
  const std::string two = std::string(kDrift) + "assemblage Other() { Stand() }\n";
  EXPECT_NE(completed(two).error().message.find("several"), std::string::npos);
}

TEST(Try, RunsWhatWasNeverSaved) {
  LiveDesk desk;
  const std::string path = desk.write(kDrift);
  const Answer answer = desk.try_out(path, "Drift", 3);
  ASSERT_TRUE(answer.ok()) << answer.error();
  EXPECT_EQ(answer.problems_size(), 0);
  ASSERT_EQ(answer.trial().robots_size(), 1);
  EXPECT_EQ(answer.trial().robots(0), "TrialDrift");
  ASSERT_TRUE(desk.browser().wait([&] { return desk.browser().roster().robots_size() == 3; }));
  ASSERT_TRUE(desk.runs_until(20.0));
  EXPECT_EQ(desk.browser().status().mode(), Status::RUNNING);
  EXPECT_EQ(desk.browser().scene().width(), kTrialArea.width);
  EXPECT_GT(desk.browser().scene().obstacles_size(), 2);
  EXPECT_GT(desk.browser().scene().objects_size(), 2);
  EXPECT_TRUE(std::filesystem::is_empty(desk.folder().path("project"))) << "nothing is written";
}

TEST(Try, RunsForEver) {
  LiveDesk desk(0.0);
  const std::string path = desk.write("assemblage Rest() { Stand() }\n");
  ASSERT_TRUE(desk.try_out(path).ok());
  ASSERT_TRUE(desk.runs_until(700.0)) << "no patience ends it";
  EXPECT_EQ(desk.browser().status().mode(), Status::RUNNING);
}

TEST(Try, TellsErrorsWhereTheAuthorWroteThemAndLeavesTheRunAlone) {
  LiveDesk desk;
  const std::string path = desk.write(kDrift);
  ASSERT_TRUE(desk.try_out(path).ok());
  ASSERT_TRUE(desk.runs_until(1.0));
  std::string wrong = kDrift;
  wrong.replace(wrong.find("3 m"), 3, "3 kg");
  desk.type(path, wrong);
  const Answer answer = desk.try_out(path);
  EXPECT_FALSE(answer.ok());
  ASSERT_GT(answer.problems_size(), 0);
  EXPECT_EQ(answer.problems(0).diagnostic().document(), path);
  EXPECT_EQ(answer.problems(0).page(), "Drift");
  EXPECT_NE(answer.problems(0).node(), "");
  EXPECT_EQ(desk.browser().status().mode(), Status::RUNNING);
}

TEST(Try, ReplacesTheRunBefore) {
  LiveDesk desk;
  const std::string path = desk.write(kDrift);
  ASSERT_TRUE(desk.try_out(path, "Drift", 2).ok());
  ASSERT_TRUE(desk.runs_until(5.0));
  std::string changed = kDrift;
  changed.replace(changed.find("3 s"), 3, "7 s");
  desk.type(path, changed);
  ASSERT_TRUE(desk.try_out(path, "Drift", 1).ok());
  ASSERT_TRUE(desk.browser().wait([&] { return desk.browser().roster().robots_size() == 1; }));
  std::string persistence;
  for (const console::Port& port : desk.browser().roster().programs(0).ports()) {
    if (port.path() == "movement.Noise.persistence") persistence = port.initial();
  }
  EXPECT_EQ(persistence, "7");
}

TEST(Try, StartsRobotsWhereThePersonPutThem) {
  LiveDesk desk(1.0);
  const std::string path = desk.write("assemblage Rest() { Stand() }\n");
  const Answer answer = desk.try_out(path, "", 3, [](Try& request) {
    request.set_execute(false);
    for (const auto& [x, y] : {std::pair(5.0, 6.0), std::pair(30.0, 20.0)}) {
      request.add_starts()->set_x(x);
      request.mutable_starts()->rbegin()->set_y(y);
    }
  });
  ASSERT_TRUE(answer.ok()) << answer.error();
  ASSERT_TRUE(
      desk.browser().wait([&] { return desk.browser().starts().robots().size() == std::size_t{3} * 16; }));
  EXPECT_TRUE(desk.browser().wait([&] { return desk.browser().status().mode() == Status::READY; }));
  std::vector<float> place(2);
  std::memcpy(place.data(), desk.browser().starts().robots().data() + 4, 8);
  EXPECT_NEAR(place[0], 5.0F, 0.01F);
  EXPECT_NEAR(place[1], 6.0F, 0.01F);
}

TEST(Try, RunsTheSocietyOfAnExampleOnAnOverlayOfIt) {
  LiveDesk desk;
  const std::string path = desk.open("examples:forage/forager.cdl");
  const Answer answer = desk.try_out(path, "Foragers", 1,
                                     [](Try& request) { request.set_overlay("examples:forage/forage.odl"); });
  ASSERT_TRUE(answer.ok()) << answer.error() << answer.DebugString();
  ASSERT_TRUE(desk.browser().wait([&] { return desk.browser().roster().robots_size() == 3; }));
  EXPECT_EQ(desk.browser().scene().objects_size(), 11);
  ASSERT_TRUE(desk.runs_until(30.0));
}

TEST(Try, RunsALibraryComponentThatIsOpenReadOnly) {
  LiveDesk desk;
  const std::string path = desk.open("library:assemblages/wander.cdl");
  const Answer answer = desk.try_out(path, "Wander");
  ASSERT_TRUE(answer.ok()) << answer.error() << answer.DebugString();
  ASSERT_TRUE(desk.runs_until(5.0));
}

TEST(Try, AnswersWhatIsWrongWithTheRequest) {
  LiveDesk desk;
  const std::string path = desk.write(kDrift);
  EXPECT_FALSE(desk.try_out("nothing").ok());
  EXPECT_FALSE(desk.try_out(path, "Fly").ok());
  EXPECT_FALSE(desk.try_out(path, "", 100'000).ok());
  EXPECT_FALSE(desk.try_out(path, "", 1, [](Try& request) { request.set_overlay("../../etc/passwd"); }).ok());
  EXPECT_FALSE(desk.try_out(path, "", 1, [](Try& request) { request.add_starts()->set_x(1e300); }).ok());
}

}  // namespace
}  // namespace mlab::designer
