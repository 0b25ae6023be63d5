#include "mlab/mavlink/parameters.h"

#include <filesystem>
#include <fstream>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "mlab/base/testing/source_folder.h"

namespace mlab::mavlink {
namespace {

using std::chrono::milliseconds;

const Parameters::Time kStart{std::chrono::hours(1)};

void tell(Parameters& parameters, std::string_view name, float value) {
  ParamValue message;
  message.param_id = field_of<16>(name);
  message.param_value = value;
  parameters.take(message, kStart);
}

// All are as they have to be.
Parameters well() {
  Parameters out(255, 2.5);
  for (const auto& [name, value] :
       std::initializer_list<std::pair<std::string_view, float>>{{"FS_GCS_ENABLE", 1},
                                                                 {"FS_ACTION", 2},
                                                                 {"FS_TIMEOUT", 1.5F},
                                                                 {"SYSID_MYGCS", 255},
                                                                 {"GUID_TIMEOUT", 1.5F},
                                                                 {"FS_EKF_ACTION", 1},
                                                                 {"FS_CRASH_CHECK", 0}})
    tell(out, name, value);
  return out;
}

// What is asked for within some time, in steps of 50 ms.
std::multiset<std::string> asked(Parameters& parameters, int from_ms, int to_ms) {
  std::multiset<std::string> out;
  for (int ms = from_ms; ms < to_ms; ms += 50) {
    if (const auto name = parameters.to_ask(kStart + milliseconds(ms))) out.emplace(*name);
  }
  return out;
}

TEST(Parameters, AreAskedForUntilTheyAreKnown) {
  Parameters parameters(255, 2.5);
  EXPECT_EQ(asked(parameters, 0, 700).size(), 7U);
  tell(parameters, "FS_ACTION", 2);
  const auto again = asked(parameters, 700, 1300);
  EXPECT_EQ(again.size(), 6U);
  EXPECT_EQ(again.count("FS_ACTION"), 0U);
  EXPECT_EQ(again.count("FS_TIMEOUT"), 1U);
  EXPECT_EQ(parameters.problem(), "has not told its parameter FS_GCS_ENABLE yet");
}

TEST(Parameters, AreAskedForAgainAfterHalfAMinute) {
  Parameters parameters = well();
  EXPECT_EQ(asked(parameters, 0, 1000).size(), 7U);
  EXPECT_EQ(asked(parameters, 1000, 29'000).size(), 0U);
  EXPECT_EQ(asked(parameters, 29'000, 32'000).size(), 7U);
}

TEST(Parameters, AreKnownByTheNamesOfOtherVersions) {
  Parameters parameters(200, 2.5);
  asked(parameters, 0, 1000);
  EXPECT_EQ(asked(parameters, 700, 1400).count("MAV_GCS_SYSID"), 1U);
  EXPECT_EQ(asked(parameters, 1400, 2100).count("SYSID_MYGCS"), 1U);
  tell(parameters, "MAV_GCS_SYSID", 200);
  for (const ParameterCheck& one : parameters.checks()) {
    if (one.name != "MAV_GCS_SYSID") continue;
    EXPECT_TRUE(one.is_right);
    EXPECT_EQ(one.wanted, "200");
    return;
  }
  FAIL() << "it stands under the name that was answered";
}

TEST(Parameters, ThatAreOnlyAdviceDoNotHinder) {
  const Parameters parameters = well();
  EXPECT_EQ(parameters.problem(), "");
  EXPECT_FALSE(parameters.checks().back().is_right);
  EXPECT_FALSE(parameters.checks().back().is_needed);
}

TEST(Parameters, LetNoSetPointLastLongerThanTheStatedTime) {
  Parameters parameters = well();
  tell(parameters, "GUID_TIMEOUT", 3.0F);
  EXPECT_EQ(parameters.problem(),
            "has GUID_TIMEOUT at 3, and it has to stand so soon after the last set-point: set it to 0.1 to "
            "1.5 with "
            "a ground station (QGroundControl, `param set GUID_TIMEOUT 1.5`)");
  tell(parameters, "GUID_TIMEOUT", std::numeric_limits<float>::quiet_NaN());
  tell(parameters, "SOMETHING_ELSE", 1.0F);
  EXPECT_NE(parameters.problem(), "") << "what is no number tells nothing";
}

TEST(Parameters, AreWrittenOnceASecondWhereTheyAreWrong) {
  Parameters parameters = well();
  EXPECT_FALSE(parameters.to_write(kStart));
  tell(parameters, "FS_TIMEOUT", 30);
  const auto write = parameters.to_write(kStart);
  ASSERT_TRUE(write);
  EXPECT_EQ(write->name, "FS_TIMEOUT");
  EXPECT_EQ(write->value, 5.0);
  EXPECT_FALSE(parameters.to_write(kStart + milliseconds(900)));
  EXPECT_TRUE(parameters.to_write(kStart + milliseconds(1100)));
}

TEST(Parameters, StandInTheDocumentationAsTheyAre) {
  std::ifstream file(std::filesystem::path(base::source_folder()) / "docs/mavlink.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  for (const ParameterCheck& one : Parameters(255, 2.5).checks()) {
    const std::size_t row = page.find("| `" + one.name + "`");
    ASSERT_NE(row, std::string::npos) << one.name;
    const std::string text = page.substr(row, page.find('\n', row) - row);
    const std::string range = one.wanted + (one.is_needed ? " | needed |" : " | advice |");
    EXPECT_NE(text.find("| " + range), std::string::npos) << text << " has to say " << range;
  }
}

TEST(Parameters, AreUnknownAfterItHasBegunAnew) {
  Parameters parameters = well();
  parameters.begin_anew();
  EXPECT_EQ(parameters.problem(), "has not told its parameter FS_GCS_ENABLE yet");
}

}  // namespace
}  // namespace mlab::mavlink
