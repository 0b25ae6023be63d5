// What the guides show: the commands are carried out, and what they print stands in files beside the
// examples, from which the guides are cut.

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace mlab {
namespace {

namespace fs = std::filesystem;
const fs::path kExamples = fs::path(MLAB_SOURCE_DIR) / "docs" / "examples";

struct Answer {
  int status = -1;
  std::string output;
};

// `mlab WORDS` in a folder, with a cache of this test's own. Standard output and standard error come
// together.
Answer mlab(const fs::path& folder, const std::string& words) {
  static const fs::path kCache = fs::path(testing::TempDir()) / "mlab_examples_cache";
  const std::string command = fmt::format("cd '{}' && XDG_CACHE_HOME='{}' '{}' {} 2>&1 </dev/null",
                                          folder.string(), kCache.string(), MLAB_COMMAND, words);
  Answer answer;
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return answer;
  std::array<char, 4096> block{};
  for (std::size_t n = 0; (n = fread(block.data(), 1, block.size(), pipe)) > 0;)
    answer.output.append(block.data(), n);
  const int status = pclose(pipe);
  answer.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return answer;
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class OwnBehavior : public testing::Test {
 protected:
  const fs::path folder_ = kExamples / "own_behavior";
};

TEST_F(OwnBehavior, EveryFileIsRightAndInTheCanonicalLayout) {
  const Answer checked = mlab(folder_, "check field.odl wander.mdl wander.cnl mine.mdl mine.cnl");
  EXPECT_EQ(checked.status, 0) << checked.output;
  const Answer printed = mlab(folder_, "fmt --check wander.cnl mine.cnl mistake.cnl");
  EXPECT_EQ(printed.status, 0) << printed.output;
}

TEST_F(OwnBehavior, TheWandererStopsWhenItIsTired) {
  const Answer run = mlab(folder_, "run wander.mdl --headless --proceed");
  EXPECT_EQ(run.status, 0) << run.output;
  const std::string steps = text_of(folder_ / "wander.txt");
  ASSERT_FALSE(steps.empty());
  EXPECT_NE(run.output.find(steps), std::string::npos) << run.output;
}

TEST_F(OwnBehavior, TheRobotGoesWhereItIsToldWithoutAContact) {
  const Answer run = mlab(folder_, "run mine.mdl --headless --proceed");
  EXPECT_EQ(run.status, 0) << run.output;
  const std::string steps = text_of(folder_ / "mine.txt");
  ASSERT_FALSE(steps.empty());
  EXPECT_NE(run.output.find(steps), std::string::npos) << run.output;
  EXPECT_NE(run.output.find(" 0 collisions"), std::string::npos) << run.output;
}

TEST_F(OwnBehavior, MistakesInCppAreShownAtTheirPlaces) {
  const Answer checked = mlab(folder_, "check mistake.cnl");
  EXPECT_EQ(checked.status, 2);
  const std::string expected = text_of(folder_ / "mistake.txt");
  ASSERT_FALSE(expected.empty());
  EXPECT_NE(checked.output.find(expected), std::string::npos) << checked.output;
}

}  // namespace
}  // namespace mlab
