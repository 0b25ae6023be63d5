#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/base/random.h"
#include "mlab/base/testing/processor_time.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/lang/mdl/tree.h"

namespace mlab::mdl {
namespace {

constexpr std::size_t kSize = base::kMegabyte;

std::string repeated(const std::string& piece, std::size_t size = kSize) {
  std::string out;
  while (out.size() < size) out += piece;
  return out;
}

std::string numbered(const std::function<std::string(int)>& piece, std::size_t size = kSize) {
  std::string out;
  for (int i = 0; out.size() < size; ++i) out += piece(i);
  return out;
}

// All that can be asked of a text. False: it has mistakes.
bool answer(const std::string& text) {
  text::Diagnostics sink;
  const auto source = std::make_shared<const text::Source>("test.mdl", text);
  const auto mission = check_mission(source, "/nowhere", sink);
  EXPECT_EQ(mission == nullptr, sink.has_errors());
  static_cast<void>(text::render(sink));
  static_cast<void>(looks_like_mdl(text));
  text::Diagnostics again;
  const Tree tree = parse(source, again);
  if (!again.has_errors()) static_cast<void>(print(tree));
  return mission != nullptr;
}

double times_longer(const std::string& text) {
  static const std::string kOrdinary =
      "SP a 1 1\nSP b 90 90\nUNIT <u> ROBOT\nCOMMAND LIST:\n0. UNIT u START a\n" + numbered([](int i) {
        return std::to_string(i + 1) + (i % 2 == 0 ? ". UNIT u MOVETO b\n" : ". UNIT u MOVETO a\n");
      });
  static const base::Yardstick kYardstick([] { EXPECT_TRUE(answer(kOrdinary)); });
  return kYardstick.times([&] { answer(text); }, base::kPatience);
}

TEST(MdlLimits, AMegabyteOfAnyBytesIsAnsweredSoon) {
  base::Random random(1);
  std::string bytes;
  while (bytes.size() < kSize) bytes += static_cast<char>(random.below(256));
  EXPECT_LT(times_longer(bytes), base::kPatience);
  std::string printable;
  while (printable.size() < kSize)
    printable += static_cast<char>(random.below(96) + 32 - (random.below(20) == 0 ? 22 : 0));
  EXPECT_LT(times_longer(printable), base::kPatience);
}

TEST(MdlLimits, AMegabyteOfOneThingIsAnsweredSoon) {
  const std::string begin = "SP a 1 1\nUNIT <u> ROBOT\nCOMMAND LIST:\n";
  for (const std::string& text : {
           repeated("("),
           repeated("<"),
           repeated("\""),
           repeated("\"\n"),
           repeated("-"),
           repeated("--\n"),
           repeated("+"),
           repeated("\n"),
           repeated("a"),
           repeated("a "),
           repeated("a\n"),
           repeated("1"),
           repeated("1 "),
           repeated("1."),
           repeated("1. "),
           repeated("\x80"),
           repeated("MISSION "),
           repeated("UNIT "),
           repeated("UNIT\n"),
           repeated("UNIT <a>\n"),
           repeated("AND "),
           repeated("SET SEED 5\n"),
           repeated("CREATE-OBSTACLES\n"),
           repeated("OVERLAY x.odl\n"),
           repeated("LOAD-MAP x\n"),
           repeated("MISSION                \n"),
           repeated("OBSTACLE 1 1 1\n"),
           repeated("UNIT <a> ROBOT\n"),
           repeated("NEW-ROBOT a b\n"),
           repeated("COMMAND LIST:\n"),
           "UNIT <a> " + repeated("(<b> "),
           "UNIT <a> " + repeated("(<b> ROBOT)"),
           "UNIT <a> " + repeated("ROBOT "),
           "NEW-ROBOT a b (" + repeated("a = 1, "),
           "NEW-ROBOT a b (" + repeated("a = 1, ") + "a = 1)\n" + begin + "0. QUIT\n",
           begin + repeated("0. UNIT u MOVETO a\n"),
           begin + repeated("0. UNIT v MOVETO b\n"),
           begin + repeated("0. UNIT u MOVETO a AND\n"),
           begin + repeated("0. UNIT u START a "),
           begin + "0. UNIT u MOVETO a " + repeated("PHASE-LINE a "),
           begin + "0. UNIT u MOVETO a " + repeated("SPEED 3 "),
           begin + repeated("0. QUIT\n"),
           begin + repeated("UNIT u STOP "),
       }) {
    EXPECT_LT(times_longer(text), base::kPatience) << text.substr(0, 60);
  }
}

TEST(MdlLimits, AMegabyteOfDifferentThingsIsAnsweredSoon) {
  const std::size_t half = kSize / 2;
  const auto points = numbered([](int i) { return "SP a" + std::to_string(i) + " 1 1\n"; }, half);
  const auto units = numbered([](int i) { return "UNIT <u" + std::to_string(i) + "> ROBOT\n"; }, half);
  const auto types = numbered([](int i) { return "NEW-ROBOT t" + std::to_string(i) + " x\n"; }, half);
  const std::string list = "COMMAND LIST:\n";
  for (const std::string& text : {
           // names that are there, that are not, and that only the last way of looking finds
           points + "UNIT <u> ROBOT\n" + list +
               numbered(
                   [](int i) {
                     return std::to_string(i) + ". UNIT u MOVETO PP-A" + std::to_string(i) + "\n";
                   },
                   half),
           points + "UNIT <u> ROBOT\n" + list +
               numbered([](int i) { return "1. UNIT u MOVETO b" + std::to_string(i) + "\n"; }, half),
           points + "UNIT <u> ROBOT\n" + list + "0. UNIT u MOVETO a1" +
               numbered([](int i) { return " PHASE-LINE a" + std::to_string(i); }, half),
           units + list +
               numbered([](int i) { return "1. UNIT u" + std::to_string(i) + " START 1 1\n"; }, half),
           units + list +
               numbered([](int i) { return "1. UNIT v" + std::to_string(i) + " START 1 1\n"; }, half),
           types + numbered([](int i) { return "UNIT <u> t" + std::to_string(i) + "\n"; }, half) + list +
               "0. QUIT\n",
           types + numbered([](int i) { return "UNIT <u> s" + std::to_string(i) + "\n"; }, half) + list +
               "0. QUIT\n",
           // a crowd, sent around many times
           "UNIT <u> " + repeated("ROBOT ", half) + list + repeated("0. UNIT u START 1 1 1 1\n", half),
           "UNIT <u> " + repeated("ROBOT ", half) + list + "0. UNIT u START 1 1 1 1\n" +
               repeated("1. UNIT u MOVETO 5 5 Wedge\n", half),
           repeated("OBSTACLE 1 1 1\n", half) + "UNIT <u> " + repeated("ROBOT ", half) + list +
               "0. UNIT u START 1 1 1 1\n",
           numbered([](int i) {
             return "UNIT <u" + std::to_string(i) + "> " + std::string(static_cast<std::size_t>(i) * 6, ' ') +
                    "ROBOT\n";
           }),
       }) {
    EXPECT_LT(times_longer(text), base::kPatience) << text.substr(text.size() - 60);
  }
}

TEST(MdlLimits, GroupsNestedToTheLimitWork) {
  std::string text = "UNIT <a> ";
  for (std::uint32_t i = 1; i < kMaxGroupDepth; ++i) text += "(<b" + std::to_string(i) + "> ";
  text += "ROBOT" + std::string(kMaxGroupDepth - 1, ')') + "\nCOMMAND LIST:\n0. UNIT a START 5 5\n";
  text::Diagnostics sink;
  const auto source = std::make_shared<const text::Source>("test.mdl", text);
  const auto mission = check_mission(source, "", sink);
  ASSERT_NE(mission, nullptr) << text::render(sink);
  EXPECT_EQ(mission->units.size(), kMaxGroupDepth);
  EXPECT_NE(print(parse(source, sink)).find("(<b63> ROBOT)"), std::string::npos);
}

TEST(MdlLimits, LinesOfMillionsOfPointsAreNotCopiedForEveryCommand) {
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(::testing::TempDir()) / "mdl_limits";
  fs::create_directories(folder);
  std::ofstream(folder / "long.odl") << "SITE x\nCONTROL MEASURES:\nPL long "
                                     << repeated("1 2 3 4 ", 2 * kSize);
  const std::string text = "OVERLAY long.odl\nUNIT <u> ROBOT\nCOMMAND LIST:\n0. UNIT u START 1 1\n" +
                           repeated("1. UNIT u FOLLOW long\n", 10000);
  text::Diagnostics sink;
  EXPECT_EQ(check_mission(std::make_shared<const text::Source>("test.mdl", text), folder.string(), sink),
            nullptr);
  ASSERT_TRUE(sink.has_errors());
  EXPECT_EQ(sink.items()[0].kind, "too-many-points") << text::render(sink.items()[0]);
  fs::remove_all(folder);
}

TEST(MdlLimits, TypedLinesOfAnyBytesGetAnAnswer) {
  text::Diagnostics none;
  const auto mission = check_mission(
      std::make_shared<const text::Source>("test.mdl", "SET SHOW-TRAILS\nCOMMAND LIST:\n0. QUIT\n"), "",
      none);
  ASSERT_NE(mission, nullptr);
  base::Random random(2);
  for (int i = 0; i < 2000; ++i) {
    std::string line;
    for (std::uint64_t n = random.below(60); n > 0; --n) line += static_cast<char>(random.below(128));
    text::Diagnostics sink;
    const bool is_understood = parse_immediate(line, *mission, sink).has_value();
    EXPECT_EQ(is_understood, !sink.has_errors());
  }
}

// A room that nobody gets into, behind a field of obstacles, and one order after the other to go there: every
// search has to look at all of the field.
TEST(MdlLimits, WaysThatThereAreNoneOfAreLookedForForALimitedTime) {
  for (const int spacing : {9, 1'000'000}) {
    std::string text = "MISSION-AREA 500 500\nSP a 1 1\nSP b 400 400\n";
    for (int i = 0; i < 1'900; ++i)
      text += "OBSTACLE " + std::to_string(10 + i % 44 * spacing) + " " +
              std::to_string(10 + i / 44 * spacing) + " 2\n";
    for (int i = 0; i < 60; ++i) {  // discs all round b, with gaps of 0.1 m
      const double angle = i * 2.0 * std::numbers::pi / 60.0;
      text += "OBSTACLE " + std::to_string(400.0 + 40.0 * std::cos(angle)) + " " +
              std::to_string(400.0 + 40.0 * std::sin(angle)) + " 2.0435\n";
    }
    text += "UNIT <u> ROBOT\nCOMMAND LIST:\n0. UNIT u START a\n";
    for (int i = 1; i < 5'000; ++i) text += std::to_string(i) + ". UNIT u MOVETO b\n";
    EXPECT_LT(times_longer(text), 3.0 * base::kPatience) << spacing;
  }
}

}  // namespace
}  // namespace mlab::mdl
