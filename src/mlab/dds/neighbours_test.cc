// Participants of one machine that have nothing to say to each other, and whoever has to hear them all.

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/dds/participant.h"
#include "mlab/dds/testing/fleet.h"

namespace mlab::dds {
namespace {

using std::chrono::milliseconds;

/// Says that it is there, and hears who is.
struct One {
  explicit One(Participant own) : participant(std::move(own)) {
    EXPECT_EQ(says.write("here", ""), Written::kDone);
  }
  bool has_met(const One& other) const {
    const std::vector<Guid> all = hears.senders();
    return std::ranges::find(all, other.participant.guid()) != all.end();
  }
  bool meets(const One& other, milliseconds limit = std::chrono::seconds(30)) {
    return comes_true(waits, [&] { return has_met(other); }, limit);
  }

  Participant participant;
  Waiter waits = waiter();
  Reader hears = reader(participant, "agents", ChannelKind::kPresence, waits);
  Writer says = writer(participant, "agents", ChannelKind::kPresence);
};

TEST(DdsNeighbours, MeetEverybodyElseWhoeverComesFirstAndNotEachOther) {
  One first(avoiding_participant());
  One second(avoiding_participant());
  One console(participant());
  One run(participant());
  One late(avoiding_participant());
  for (One* const all : {&console, &run}) {
    for (One* const one : {&first, &second, &late}) {
      EXPECT_TRUE(all->meets(*one));
      EXPECT_TRUE(one->meets(*all));
    }
  }
  EXPECT_TRUE(console.meets(run));
  EXPECT_TRUE(run.meets(console));
  // All have said by then once more that they are there.
  EXPECT_FALSE(first.meets(second, milliseconds(2500)));
  for (const One* const one : {&first, &second, &late}) {
    for (const One* const other : {&first, &second, &late}) EXPECT_EQ(one->has_met(*other), one == other);
  }
}

TEST(DdsNeighbours, AreFoundAtOnceByWhoComesLate) {
  One first(avoiding_participant());
  One second(avoiding_participant());
  One console(participant());
  const auto began = std::chrono::steady_clock::now();
  EXPECT_TRUE(console.meets(first));
  EXPECT_TRUE(console.meets(second));
  EXPECT_LT(std::chrono::steady_clock::now() - began, milliseconds(1500)) << "sooner than they say so again";
}

}  // namespace
}  // namespace mlab::dds
