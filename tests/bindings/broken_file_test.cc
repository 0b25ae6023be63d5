// Files of percepts that are broken, cut or none give an error that says what was seen.

#include "mlab/robot_wire/framing.h"
#include "recorded.h"

namespace mlab::testing {
namespace {

class BrokenFile : public ::testing::Test {
 protected:
  BrokenFile() {
    record(Plan("demo_c"), 20, file_.path());
    bytes_ = file_.read();
  }
  std::string error_of(const std::string& bytes) const {
    file_.write(bytes);
    const auto opened = recording::PerceptsReader::open(file_.path());
    return opened ? "" : opened.error().message;
  }
  const std::string& bytes() const { return bytes_; }
  std::string prefix() const { return "`" + file_.path() + "`: "; }

 private:
  TemporaryFile file_{"percepts_broken"};
  std::string bytes_;
};

TEST_F(BrokenFile, AsItWasWrittenIsSound) {
  EXPECT_EQ(error_of(bytes()), "");
}

TEST_F(BrokenFile, ThatIsCutSaysWhere) {
  for (const std::size_t length : {std::size_t{2}, bytes().size() / 3, bytes().size() - 1})
    EXPECT_NE(error_of(bytes().substr(0, length)).find("it was cut off"), std::string::npos) << length;
  EXPECT_EQ(error_of(""),
            prefix() + "at byte 0: the file ends with 0 of the 4 bytes of a length: it was cut off");
}

// The end is an entry of its own, so that what was cut between two entries is told, too.
TEST_F(BrokenFile, ThatIsCutBetweenTwoEntriesHasNoEnd) {
  wire::RecordedEntry end;
  end.mutable_end()->set_cycles(20);
  std::string last;
  robot_wire::append_framed(end, last);
  ASSERT_TRUE(bytes().ends_with(last));
  const std::string cut = bytes().substr(0, bytes().size() - last.size());
  EXPECT_EQ(error_of(cut),
            prefix() + "at byte " + std::to_string(cut.size()) +
                ": the file ends after 20 cycles without an end: it was cut off, or its run was killed");
  end.mutable_end()->set_cycles(21);
  last.clear();
  robot_wire::append_framed(end, last);
  EXPECT_EQ(error_of(cut + last), prefix() + "at byte " + std::to_string(cut.size()) +
                                      ": the end speaks of 21 cycles, and 20 stand before it");
}

TEST_F(BrokenFile, ThatGoesOnBehindItsEndIsRefused) {
  EXPECT_EQ(error_of(bytes() + "more"),
            prefix() + "at byte " + std::to_string(bytes().size()) + ": 4 bytes behind the end");
}

TEST_F(BrokenFile, OfAnotherKindIsRefused) {
  EXPECT_NE(error_of("UNIT <scouts> robot robot\n").find("this is no file of percepts, or broken"),
            std::string::npos);
  wire::RecordedEntry entry;
  entry.mutable_end();
  std::string other;
  robot_wire::append_framed(entry, other);
  EXPECT_EQ(error_of(other),
            prefix() + "at byte 0: no head of a file of percepts stands here: it is another kind of file");
  entry.mutable_head()->set_magic("missionlab percepts");
  entry.mutable_head()->set_format(7);
  other.clear();
  robot_wire::append_framed(entry, other);
  EXPECT_EQ(error_of(other), prefix() + "at byte 0: format 7, and this program knows only format 1");
}

TEST_F(BrokenFile, WithPerceptsThatDoNotFitNamesTheRobot) {
  wire::RecordedEntry head;
  head.mutable_head()->set_magic("missionlab percepts");
  head.mutable_head()->set_format(1);
  wire::RecordedEntry cycle;
  cycle.mutable_cycle()->set_duration(0.1);
  wire::RecordedRobot& robot = *cycle.mutable_cycle()->add_robots();
  robot.set_robot(12);
  robot.mutable_percepts()->mutable_obstacles()->add_x(1.0);
  std::string made;
  robot_wire::append_framed(head, made);
  const std::size_t at = made.size();
  robot_wire::append_framed(cycle, made);
  EXPECT_EQ(error_of(made).find(prefix() + "at byte " + std::to_string(at) + ": of robot 12: "), 0U)
      << error_of(made);
  cycle.mutable_cycle()->set_duration(0.0);
  made.resize(at);
  robot_wire::append_framed(cycle, made);
  EXPECT_EQ(error_of(made), prefix() + "at byte " + std::to_string(at) + ": a cycle lasts 0 s");
}

// Whatever a byte is changed to, the file is refused or read, and what is read can be acted on.
TEST_F(BrokenFile, WithAnyByteChangedHarmsNobody) {
  const Plan plan("demo_c");
  for (std::size_t at = 0; at < bytes().size(); at += 1 + bytes().size() / 150) {
    std::string changed = bytes();
    changed[at] = static_cast<char>(changed[at] ^ 0x55);
    if (const std::string error = error_of(changed); !error.empty()) {
      EXPECT_EQ(error.find(prefix()), 0U) << error;
      continue;
    }
    const TemporaryFile file("percepts_changed_byte");
    file.write(changed);
    const Replay replay(plan, file.path());
    ASSERT_TRUE(replay.run);
    carry_out(*replay.run, 30);
  }
}

TEST(PerceptsReader, SaysThatThereIsNoFile) {
  const auto opened = recording::PerceptsReader::open("/nowhere/at/all");
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().message, "`/nowhere/at/all`: there is no such file, or it can't be read");
}

}  // namespace
}  // namespace mlab::testing
