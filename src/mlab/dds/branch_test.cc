// Messages that go to another thread than the rest of their topic.

#include <optional>

#include <gtest/gtest.h>

#include "mlab/dds/participant.h"
#include "mlab/dds/testing/fleet.h"

namespace mlab::dds {
namespace {

using Kind = Arrival::Kind;

std::vector<std::string> messages(Waiter& waits, Reader::Branch& branch, std::size_t count) {
  std::vector<std::string> out;
  comes_true(waits, [&] {
    for (Arrival& one : branch.take()) out.push_back(std::move(one.body));
    return out.size() >= count;
  });
  return out;
}

TEST(DdsBranch, HasTheMessagesOfItsKeyAndTheReaderAllOthers) {
  Participant here = participant();
  Participant there = participant();
  Waiter waits = waiter();
  Waiter branch_waits = waiter();
  Reader reads = reader(here, "requests", ChannelKind::kLockStepPercepts, waits);
  Writer writes = writer(there, "requests", ChannelKind::kLockStepPercepts, &waits);
  ASSERT_TRUE(comes_true(waits, [&] { return !writes.readers().empty(); }));
  std::optional<Reader::Branch> branch(reads.branch(there.guid(), "a", branch_waits));
  const Reader::Branch other_sender = reads.branch(here.guid(), "b", branch_waits);
  for (const std::string number : {"1", "2"}) {
    write_surely(writes, "a", "a" + number);
    write_surely(writes, "b", "b" + number);
  }
  EXPECT_EQ(messages(branch_waits, *branch, 2), (std::vector<std::string>{"a1", "a2"}));
  EXPECT_EQ(bodies(arrivals(waits, reads, Kind::kMessage, 2)), (std::vector<std::string>{"b1", "b2"}));
  branch.reset();
  write_surely(writes, "a", "a3");
  EXPECT_EQ(bodies(arrivals(waits, reads, Kind::kMessage)), std::vector<std::string>{"a3"});
}

TEST(DdsBranch, LeavesItToTheReaderThatASenderHasGone) {
  Participant here = participant();
  std::optional<Participant> there(participant());
  Waiter waits = waiter();
  Waiter branch_waits = waiter();
  Reader reads = reader(here, "requests", ChannelKind::kLockStepPercepts, waits);
  std::optional<Writer> writes(writer(*there, "requests", ChannelKind::kLockStepPercepts, &waits));
  ASSERT_TRUE(comes_true(waits, [&] { return !writes->readers().empty(); }));
  Reader::Branch branch = reads.branch(there->guid(), "a", branch_waits);
  write_surely(*writes, "a", "last");
  EXPECT_EQ(messages(branch_waits, branch, 1), std::vector<std::string>{"last"});
  const Guid sender = there->guid();
  writes.reset();
  there.reset();
  EXPECT_EQ(first_of(arrivals(waits, reads, Kind::kUnmatched), Kind::kUnmatched).sender, sender);
  EXPECT_TRUE(branch.take().empty());
}

TEST(DdsBranch, PromptsAreNoMessages) {
  Participant here = participant();
  Participant there = participant();
  Waiter waits = waiter();
  Reader reads = reader(here, "requests", ChannelKind::kLockStepPercepts, waits);
  Writer writes = writer(there, "requests", ChannelKind::kLockStepPercepts, &waits);
  ASSERT_TRUE(comes_true(waits, [&] { return !writes.readers().empty(); }));
  EXPECT_EQ(writes.write("\x01prompt", ""), Written::kBadKey);
  write_surely(writes, "a", "only");
  EXPECT_EQ(bodies(arrivals(waits, reads, Kind::kMessage, 2, std::chrono::milliseconds(300))),
            std::vector<std::string>{"only"});
}

}  // namespace
}  // namespace mlab::dds
