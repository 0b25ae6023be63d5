// Files of percepts that are broken, cut or none give an error that says what was seen.

#include <limits>

#include "mlab/robot/wire/framing.h"
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
  EXPECT_EQ(error_of("abc"),
            prefix() + "at byte 0: the file ends with 3 of the 4 bytes of a length: it was cut off");
  EXPECT_EQ(error_of(""), prefix() + "it is empty");
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

/// A head, and one entry behind it.
std::string file_with(const wire::RecordedEntry& entry) {
  wire::RecordedEntry head;
  head.mutable_head()->set_magic("missionlab percepts");
  head.mutable_head()->set_format(1);
  std::string out;
  robot_wire::append_framed(head, out);
  robot_wire::append_framed(entry, out);
  return out;
}

TEST_F(BrokenFile, WithAnEntryThatStandsForNothingSaysWhere) {
  using Entry = wire::RecordedEntry;
  struct Case {
    void (*write)(Entry&);
    const char* error;
  };
  const Case cases[] = {
      {[](Entry& entry) {
         entry.mutable_cycle()->set_duration(0.1);
         wire::RecordedRobot& robot = *entry.mutable_cycle()->add_robots();
         robot.set_robot(12);
         robot.mutable_percepts()->mutable_obstacles()->add_x(1.0);
       },
       "of robot 12: the columns of the obstacles are not equally long"},
      {[](Entry& entry) { entry.mutable_cycle(); }, "a cycle lasts 0 s"},
      {[](Entry& entry) {
         entry.mutable_cycle()->set_duration(0.1);
         entry.mutable_cycle()->mutable_radio()->add_robot(1);
       },
       "1 robots with radios are in 0 nets"},
      {[](Entry& entry) {
         entry.mutable_cycle()->set_duration(0.1);
         entry.mutable_cycle()->mutable_radio()->add_lost_to(1);
       },
       "what 0 robots told was lost to 1"},
      {[](Entry& entry) {
         entry.mutable_embodied()->mutable_pose()->set_x(std::numeric_limits<double>::quiet_NaN());
       },
       "embodied.pose.x is nan, where numbers from -1000000000 to 1000000000 can be"},
      {[](Entry& entry) {
         entry.mutable_cycle()->add_robots();
         wire::Percepts& percepts = *entry.mutable_cycle()->add_robots()->mutable_percepts();
         percepts.mutable_obstacles()->add_x(0.0);
         percepts.mutable_obstacles()->add_x(-std::numeric_limits<double>::infinity());
       },
       "cycle.robots[1].percepts.obstacles.x[1] is -inf, where numbers from -1000000000 to 1000000000 can "
       "be"},
      {[](Entry& entry) { entry.mutable_world()->add_objects()->set_style(wire::ObjectStyle(17)); },
       "world.objects[0].style is 17, which no ObjectStyle is"},
      {[](Entry& entry) { entry.mutable_world()->add_objects(); },
       "an object with the id 0, where 1 to 1048576 can be"},
      {[](Entry& entry) { entry.mutable_world()->add_disc_x(1.0); }, "1 discs have 0 y and 0 radii"},
      {[](Entry& entry) { entry.mutable_world()->add_wall_group(1); },
       "1 walls have 0 and 0 ends, and 0 say whether they are solid"},
      {[](Entry& entry) { entry.mutable_embodied()->set_range_sensors(70'000); },
       "robot 0 has 70000 range sensors, where 65535 are the most"},
      {[](Entry&) {}, "an entry of a kind that is not known"},
      {[](Entry& entry) { entry.mutable_head(); }, "a second head"},
  };
  const std::size_t at = file_with({}).size() - 4;
  for (const Case& one : cases) {
    Entry entry;
    one.write(entry);
    EXPECT_EQ(error_of(file_with(entry)), prefix() + "at byte " + std::to_string(at) + ": " + one.error);
  }
}

// Strangers' bytes ask for no more memory than they may have.
TEST_F(BrokenFile, ThatIsEnormousIsRefusedBeforeItIsRead) {
  EXPECT_EQ(error_of(std::string(8, '\xff')),
            prefix() +
                "at byte 0: an entry of 4294967295 bytes, where 33554432 are the most: this is no file of "
                "percepts, or broken");
  constexpr int kObjects = 1 << 20;
  std::string objects;
  for (int i = 0; i < kObjects; ++i) objects += std::string("\x42\x00", 2);  // field 8, with nothing in it
  wire::RecordedEntry entry;
  ASSERT_TRUE(entry.mutable_world()->MergeFromString(objects));
  ASSERT_EQ(entry.world().objects_size(), kObjects);
  EXPECT_NE(error_of(file_with(entry)).find("bytes with more than 1048576 parts"), std::string::npos);
}

TEST_F(BrokenFile, WithMoreStartsThanThereCanBeIsRefused) {
  wire::RecordedEntry entry;
  entry.mutable_embodied();
  std::string body;
  robot_wire::append_framed(entry, body);
  std::string file = file_with(entry);
  for (int i = 0; i < 100'000; ++i) file += body;
  EXPECT_NE(error_of(file).find("more than 100000 starts of robots"), std::string::npos);
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
  const auto error_of = [](const char* path) {
    const auto opened = recording::PerceptsReader::open(path);
    return opened ? "" : opened.error().message;
  };
  EXPECT_EQ(error_of("/nowhere/at/all"), "`/nowhere/at/all`: there is no such file");
  EXPECT_EQ(error_of("/"), "`/`: it is no ordinary file");
}

}  // namespace
}  // namespace mlab::testing
