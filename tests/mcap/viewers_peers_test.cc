// What is recorded for viewers, read by somebody else's reader and held against the schemas that Foxglove
// publishes.

#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "mlab/base/testing/source_folder.h"

namespace mlab {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

class ViewersPeers : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::is_directory(fs::path(MLAB_MCAP_FOLDER) / "node_modules/@foxglove/schemas"))
      GTEST_SKIP() << "no schemas of Foxglove in " << MLAB_MCAP_FOLDER
                   << ": ./mlab test --only e2e installs them";
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  static std::string printed(const std::string& command) {
    FILE* const pipe = ::popen((command + " 2>&1").c_str(), "r");
    std::string out;
    std::array<char, 4096> buffer{};
    while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
      out.append(buffer.data(), n);
    const int status = ::pclose(pipe);
    EXPECT_EQ(status, 0) << out;
    return status == 0 ? out : "";
  }

  const fs::path folder_ =
      fs::path(::testing::TempDir()) / fmt::format("mlab_viewers_{}", static_cast<int>(::getpid()));
};

TEST_F(ViewersPeers, OthersReadTheRunByPublishedSchemas) {
  const std::string file = (folder_ / "run.mcap").string();
  printed(
      fmt::format("'{}' run '{}/missions/demo_c/demo_c.mdl' --headless --proceed --quiet --limit 60 "
                  "--record '{}' --record-for viewers || test $? -eq 1",
                  MLAB_COMMAND, base::source_folder(), file));
  const Json is = Json::parse(printed(fmt::format("node '{}/tests/mcap/viewers.mjs' '{}' '{}'",
                                                  base::source_folder(), MLAB_MCAP_FOLDER, file)),
                              nullptr, false);
  ASSERT_TRUE(is.is_object());
  EXPECT_EQ(is["disagreements"], Json::array());
  EXPECT_GT(is["types"], 20) << "so many types were held against the published ones";
  const Json& topics = is["topics"];
  const auto schema = [&](const char* topic) { return topics[topic]["schema"]; };
  EXPECT_EQ(schema("/tf"), "foxglove.FrameTransforms");
  EXPECT_EQ(schema("/scene"), "foxglove.SceneUpdate");
  EXPECT_EQ(schema("/scene/robots"), "foxglove.SceneUpdate");
  EXPECT_EQ(schema("/scene/goals"), "foxglove.SceneUpdate");
  EXPECT_EQ(schema("/log"), "foxglove.Log");
  EXPECT_EQ(schema("/robots/4/pose"), "foxglove.PoseInFrame");
  EXPECT_EQ(topics["/tf"]["encoding"], "protobuf");
  EXPECT_EQ(topics["/tf"]["count"], 600) << "ten times in each of 60 s";
  EXPECT_EQ(topics["/scene"]["count"], 1);
  EXPECT_EQ(topics["/tf"]["last"]["transforms"].size(), 4U);
  EXPECT_EQ(topics["/tf"]["last"]["transforms"][0]["child_frame_id"], "robot_1");
  EXPECT_EQ(topics["/scene/robots"]["last"]["entities"][0]["id"], "robot/1");
  EXPECT_TRUE(topics.contains("/mlab/input")) << "the history is in the same file";
}

}  // namespace
}  // namespace mlab
