#include "mlab/lang/mdl/mission_time.h"

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/lang/mdl/mdl.h"

namespace mlab::mdl {
namespace {

using Kind = mission::MissionTime::Kind;

TimeReading read(const std::string& until) {
  text::Diagnostics sink;
  const std::string text = "SET SHOW-TRAILS\nCOMMAND LIST:\n0. UNIT u OCCUPY a UNTIL " + until;
  const Tree tree = parse(std::make_shared<const text::Source>("test.mdl", text), sink);
  if (sink.has_errors()) return {std::nullopt, text::render(sink), {}};
  const auto& action = std::get<statement::UnitAction>(tree.steps.at(0).commands.at(0).what);
  return read_moment(std::get<clause::Until>(action.clauses.at(0).what).moment);
}

struct Case {
  std::string until;
  Kind kind;
  double seconds;
};

TEST(MissionTime, IsReadInAllItsForms) {
  for (const Case& c : std::vector<Case>{{"TIMEOUT 10", Kind::kSinceReached, 10},
                                         {"TIMEOUT 0", Kind::kSinceReached, 0},
                                         {"TIMEOUT 2.5", Kind::kSinceReached, 2.5},
                                         {"TIMEOUT 1:30", Kind::kSinceReached, 90},
                                         {"TIMEOUT +90:05", Kind::kSinceReached, 5405},
                                         {"TIMEOUT 1:00:05", Kind::kSinceReached, 3605},
                                         {"TIMEOUT +45", Kind::kSinceReached, 45},
                                         {"-30", Kind::kSinceReached, 30},
                                         {"12:30", Kind::kOfDay, 45000},
                                         {"0:00:01", Kind::kOfDay, 1},
                                         {"23:59:59", Kind::kOfDay, 86399},
                                         {"750", Kind::kOfDay, 45000},
                                         {"+1:30", Kind::kSinceStart, 5400},
                                         {"+1:30:15", Kind::kSinceStart, 5415},
                                         {"+5", Kind::kSinceStart, 300},
                                         {"00:00 1-01-00", Kind::kAbsolute, 946684800},
                                         {"02-29-24 12:00", Kind::kAbsolute, 1709208000},
                                         {"12:00:30 12-25-95", Kind::kAbsolute, 3975652830}}) {
    const TimeReading reading = read(c.until);
    ASSERT_TRUE(reading.time.has_value()) << c.until << ": " << reading.problem;
    EXPECT_EQ(reading.time->kind, c.kind) << c.until;
    EXPECT_DOUBLE_EQ(reading.time->seconds, c.seconds) << c.until;
  }
}

TEST(MissionTime, IsRefusedWhereNoClockShowsIt) {
  for (const char* until : {"24:00", "12:60", "12:00:60", "12:00 02-29-23", "12:00 0-10-26", "12:00 13-10-26",
                            "+1:00 12-25-26", "TIMEOUT -1", "TIMEOUT 1:60", "TIMEOUT 1:60:00", "+0:60"}) {
    EXPECT_FALSE(read(until).time.has_value()) << until;
  }
}

}  // namespace
}  // namespace mlab::mdl
