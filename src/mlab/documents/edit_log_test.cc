#include "mlab/documents/edit_log.h"

#include <string>

#include <gtest/gtest.h>

namespace mlab::documents {
namespace {

// A number that edits change, with the log of them.
struct Counter {
  int value = 0;
  EditLog log;

  void add(int amount, const std::string& name, double now) {
    value += amount;
    log.add({name, [this, amount] { value -= amount; }, [this, amount] { value += amount; }}, now);
  }
};

TEST(EditLog, UndoesAndDoesAgainInOrderAndSaysWhat) {
  Counter c;
  c.add(1, "a", 0.0);
  c.add(10, "b", 5.0);
  EXPECT_EQ(c.log.undo_name(), "b");
  EXPECT_EQ(c.log.redo_name(), "");
  EXPECT_TRUE(c.log.undo());
  EXPECT_EQ(c.value, 1);
  EXPECT_EQ(c.log.redo_name(), "b");
  EXPECT_TRUE(c.log.undo());
  EXPECT_EQ(c.value, 0);
  EXPECT_FALSE(c.log.undo());
  EXPECT_TRUE(c.log.redo());
  EXPECT_TRUE(c.log.redo());
  EXPECT_EQ(c.value, 11);
  EXPECT_FALSE(c.log.redo());
}

TEST(EditLog, MergesEditsOfOneNameWithinASecondOfEachOther) {
  Counter c;
  for (int i = 0; i < 10; ++i) c.add(1, "drag", 0.9 * i);
  c.add(100, "other", 8.2);
  c.add(1, "drag", 8.3);
  EXPECT_TRUE(c.log.undo());
  EXPECT_EQ(c.value, 110);
  EXPECT_TRUE(c.log.undo());
  EXPECT_EQ(c.value, 10);
  EXPECT_TRUE(c.log.undo());
  EXPECT_EQ(c.value, 0);
  EXPECT_TRUE(c.log.redo());
  EXPECT_EQ(c.value, 10);
}

TEST(EditLog, KeepsEditsApartThatAreSlowOrWereSeparatedOrFollowAnUndo) {
  Counter c;
  c.add(1, "x", 0.0);
  c.add(1, "x", 1.5);
  c.log.separate();
  c.add(1, "x", 1.6);
  c.log.undo();
  EXPECT_EQ(c.value, 2);
  c.add(5, "x", 1.7);
  c.log.undo();
  EXPECT_EQ(c.value, 2);
  c.log.undo();
  EXPECT_EQ(c.value, 1);
}

TEST(EditLog, ForgetsWhatWasUndoneWhenSomethingNewIsDone) {
  Counter c;
  c.add(1, "a", 0.0);
  c.log.undo();
  c.add(2, "b", 0.1);
  EXPECT_FALSE(c.log.redo());
  EXPECT_EQ(c.value, 2);
}

TEST(EditLog, NumbersEveryNewEditHigher) {
  Counter c;
  EXPECT_EQ(c.log.undo_number(), 0U);
  c.add(1, "a", 0.0);
  const auto first = c.log.undo_number();
  c.log.undo();
  EXPECT_EQ(c.log.redo_number(), first);
  c.add(1, "b", 0.0);
  EXPECT_GT(c.log.undo_number(), first);
  c.log.clear();
  EXPECT_EQ(c.log.undo_number(), 0U);
  c.add(1, "c", 0.0);
  EXPECT_GT(c.log.undo_number(), first + 1);
}

}  // namespace
}  // namespace mlab::documents
