#include "mlab/viewers/viewers.h"

#include <algorithm>
#include <filesystem>
#include <memory>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"
#include "mlab/cell/testing/permission.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/simulated/run.h"
#include "mlab/viewers/colors.h"

namespace mlab::viewers {
namespace {

// Demo C, and what is told of it.
class ViewersOfDemo : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string path = base::source_folder() + "/missions/demo_c/demo_c.mdl";
    text::Diagnostics sink;
    const auto mission = mdl::load_mission(path, sink);
    ASSERT_NE(mission, nullptr) << text::render(sink);
    const auto crew = run::make_crew(
        mission, {cell::testing::code_permitted(), std::filesystem::path(path).parent_path().string()}, sink);
    ASSERT_NE(crew, nullptr) << text::render(sink);
    run::RunSettings settings;
    settings.executive.proceed_all = true;
    run_ = simulated::make_run(crew, settings);
    viewers_ = std::make_unique<Viewers>(
        [this](const std::string& topic, const google::protobuf::Message& message) {
          std::unique_ptr<google::protobuf::Message> copy(message.New());
          copy->CopyFrom(message);
          told_[topic].push_back(std::move(copy));
        },
        *run_, 1000.0);
    run_->set_observer([this](const mission::Effect& effect) { viewers_->see(effect); });
    viewers_->note_cycle();
  }
  void step(int cycles) {
    for (int i = 0; i < cycles; ++i) {
      if (run_->step() == run::MissionRun::Progress::kStepped) viewers_->note_cycle();
    }
  }
  template <class T>
  std::vector<const T*> told(const std::string& topic) const {
    std::vector<const T*> out;
    const auto found = told_.find(topic);
    if (found == told_.end()) return out;
    for (const auto& one : found->second) out.push_back(dynamic_cast<const T*>(one.get()));
    return out;
  }

  std::unique_ptr<run::MissionRun> run_;
  std::unique_ptr<Viewers> viewers_;
  std::map<std::string, std::vector<std::unique_ptr<google::protobuf::Message>>> told_;
};

TEST_F(ViewersOfDemo, TellTheMapOnceAndPosesTenTimesASecond) {
  run_->post(mission::event::Execute{});
  step(100);
  const auto maps = told<foxglove::SceneUpdate>("/scene");
  ASSERT_EQ(maps.size(), 1U);
  EXPECT_TRUE(std::ranges::any_of(maps[0]->entities(), [](const auto& one) {
    return one.id() == "measure/AA1";
  })) << maps[0]->ShortDebugString().substr(0, 2000);
  const auto transforms = told<foxglove::FrameTransforms>("/tf");
  ASSERT_EQ(transforms.size(), 100U);
  const auto& last = transforms.back()->transforms(0);
  EXPECT_EQ(last.parent_frame_id(), "map");
  EXPECT_EQ(last.child_frame_id(), "robot_1");
  EXPECT_DOUBLE_EQ(last.translation().x(), run_->fleet().pose(run_->fleet().robots()[0]).position.x);
  EXPECT_EQ(last.timestamp().seconds(), 1010);
  EXPECT_EQ(told<foxglove::PoseInFrame>("/robots/1/pose").size(), 100U);
  EXPECT_FALSE(told<foxglove::Log>("/log").empty());
  EXPECT_FALSE(told<foxglove::SceneUpdate>("/scene/goals").empty());
}

TEST_F(ViewersOfDemo, TellRobotsWholeWhereAnythingOfThemChanges) {
  run_->post(mission::event::Execute{});
  step(50);
  const auto robots = told<foxglove::SceneUpdate>("/scene/robots");
  ASSERT_FALSE(robots.empty());
  ASSERT_EQ(robots.back()->entities_size(), 4);
  EXPECT_EQ(robots.back()->entities(0).id(), "robot/1");
  EXPECT_EQ(robots.back()->entities(0).frame_id(), "robot_1");
  EXPECT_TRUE(robots.back()->entities(0).frame_locked());
  EXPECT_GT(robots.back()->entities(0).cylinders(0).size().x(), 0.0);
}

TEST_F(ViewersOfDemo, SayWhichGoalsAreGone) {
  run_->post(mission::event::Execute{});
  step(1500);
  std::set<std::string> there;
  std::size_t gone = 0;
  for (const auto* const update : told<foxglove::SceneUpdate>("/scene/goals")) {
    for (const auto& deletion : update->deletions()) gone += there.erase(deletion.id());
    for (const auto& entity : update->entities()) there.insert(entity.id());
    EXPECT_EQ(there.size(), static_cast<std::size_t>(update->entities_size())) << "each is complete";
  }
  EXPECT_GT(gone, 1U);
}

TEST_F(ViewersOfDemo, TellWaysPieceByPiece) {
  run_->post(mission::event::Execute{});
  step(900);
  std::set<std::string> ids;
  for (const auto* const update : told<foxglove::SceneUpdate>("/scene/ways")) {
    for (const auto& entity : update->entities()) {
      EXPECT_TRUE(ids.insert(entity.id()).second) << entity.id();
      EXPECT_EQ(entity.lines(0).points_size(), 30);
    }
  }
  EXPECT_TRUE(ids.contains("way/1/1"));
  EXPECT_TRUE(ids.contains("way/1/2"));
}

TEST(Colors, AreFoundHoweverTheyAreWritten) {
  EXPECT_EQ(color_named("Dark Sea Green").SerializeAsString(),
            color_named("darkseagreen").SerializeAsString());
  EXPECT_DOUBLE_EQ(color_named("red").r(), 1.0);
  EXPECT_DOUBLE_EQ(color_named("no such").r(), color_named("no such").b());
  EXPECT_DOUBLE_EQ(color_named("blue", 0.5).a(), 0.5);
}

}  // namespace
}  // namespace mlab::viewers
