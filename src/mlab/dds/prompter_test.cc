#include "mlab/dds/prompter.h"

#include <atomic>
#include <thread>

#include <gtest/gtest.h>

namespace mlab::dds {
namespace {

using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

/// How long readers are left alone after a hundred writes.
Clock::duration patience_after(Prompter::Clock::duration between, Prompter::Patience most = {}) {
  Prompter::Pace pace;
  Clock::time_point now;
  for (int i = 0; i < 100; ++i) pace.written(now += between);
  return pace.patience(most);
}

TEST(DdsPrompter, LeavesReadersAloneForSomeCyclesHoweverSlowTheyAre) {
  EXPECT_EQ(patience_after(std::chrono::microseconds(100)), Prompter::kFirst);
  EXPECT_EQ(patience_after(milliseconds(3)), milliseconds(15));
  EXPECT_EQ(patience_after(milliseconds(17)), milliseconds(85));
  EXPECT_EQ(patience_after(milliseconds(49)), Prompter::Patience().longest);
  EXPECT_EQ(patience_after(milliseconds(51)), Prompter::kFirst) << "a command now and then";
}

TEST(DdsPrompter, LeavesReadersAloneForLongerWhereNothingIsLost) {
  constexpr Prompter::Patience kMost = Prompter::kWhereNothingIsLost;
  EXPECT_EQ(patience_after(std::chrono::microseconds(20), kMost), Prompter::kFirst);
  EXPECT_EQ(patience_after(milliseconds(3), kMost), milliseconds(150));
  EXPECT_EQ(patience_after(milliseconds(17), kMost), kMost.longest);
  EXPECT_EQ(patience_after(milliseconds(51), kMost), Prompter::kFirst);
}

TEST(DdsPrompter, NoticesTheNextLossAsSoonAsTheOneBefore) {
  Prompter::Pace pace;
  Clock::time_point now;
  for (int i = 0; i < 100; ++i) pace.written(now += milliseconds(2));
  pace.written(now += milliseconds(30));
  EXPECT_LE(pace.patience({}), milliseconds(13));
  pace.written(now += milliseconds(2));
  EXPECT_EQ(pace.patience({}), milliseconds(10));
}

TEST(DdsPrompter, PromptsSomeTimesAfterTheLastWriteAndThenNoMore) {
  std::atomic<int> prompts = 0;
  Prompter prompter{Prompter::Patience()};
  Prompter::Task task(prompter, [&] {
    ++prompts;
    return false;
  });
  std::this_thread::sleep_for(milliseconds(20));
  EXPECT_EQ(prompts, 0) << "nothing was written";
  task.written();
  const auto until = Clock::now() + std::chrono::seconds(20);
  while (prompts < Prompter::kPrompts && Clock::now() < until) std::this_thread::sleep_for(milliseconds(1));
  std::this_thread::sleep_for(3 * Prompter::kMost);
  EXPECT_EQ(prompts, Prompter::kPrompts);
}

TEST(DdsPrompter, PromptsWhoHasMatchedUntilHeAnswersHoweverOftenThatIs) {
  constexpr int kAnswers = Prompter::kPrompts + 5;
  std::atomic<int> prompts = 0;
  Prompter prompter{Prompter::Patience()};
  Prompter::Task task(prompter, [&] { return ++prompts < kAnswers; });
  task.matched();
  const auto until = Clock::now() + std::chrono::seconds(20);
  while (prompts < kAnswers && Clock::now() < until) std::this_thread::sleep_for(milliseconds(1));
  std::this_thread::sleep_for(3 * Prompter::kMost);
  EXPECT_EQ(prompts, kAnswers);
}

TEST(DdsPrompter, PromptsNobodyBeforeItsTime) {
  std::atomic<Clock::time_point> prompted = Clock::time_point::max();
  Prompter prompter{Prompter::Patience()};
  Prompter::Task task(prompter, [&] {
    if (prompted.load() == Clock::time_point::max()) prompted = Clock::now();
    return false;
  });
  const auto wrote = Clock::now();
  task.written();
  while (prompted.load() == Clock::time_point::max()) std::this_thread::sleep_for(milliseconds(1));
  EXPECT_GE(prompted.load() - wrote, Prompter::kFirst);
}

TEST(DdsPrompter, CallsNothingOfATaskThatHasEnded) {
  for (int i = 0; i < 50; ++i) {
    Prompter prompter{Prompter::Patience()};
    std::atomic<bool> is_there = true;
    std::atomic<int> late = 0;
    {
      Prompter::Task task(prompter, [&] {
        late += is_there ? 0 : 1;
        return false;
      });
      task.written();
      std::this_thread::sleep_for(std::chrono::microseconds(100 * i));
    }
    is_there = false;
    std::this_thread::sleep_for(milliseconds(3));
    EXPECT_EQ(late, 0);
  }
}

}  // namespace
}  // namespace mlab::dds
