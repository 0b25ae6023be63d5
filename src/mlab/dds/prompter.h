#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

namespace mlab::dds {

/// Has readers notice soon that the last thing written was lost: where nothing follows it they would not know
/// that there was something. So after each write readers are prompted, as long as nothing is written: 2 ms
/// later at first, then ever more seldom. In a fast lock-step the next cycle comes before that, and nobody
/// is. A reader that has just matched is prompted as well, until it has answered. Has a thread of its own.
class Prompter {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kFirst{2};
  static constexpr std::chrono::milliseconds kMost{16};  ///< between two
  static constexpr int kPrompts = 12;                    ///< after which Cyclone's own, slower means are left

  /// For how long readers are left alone where writes follow each other, so that the thread need not wake up
  /// in each cycle.
  struct Patience {
    int cycles = 5;
    std::chrono::milliseconds longest{100};
  };
  /// The same where nothing is lost on its way: a reader misses something only if it was flooded, and after
  /// this Cyclone's writers ask by themselves.
  static constexpr Patience kWhereNothingIsLost{.cycles = 50, .longest = std::chrono::milliseconds{400}};

  /// How fast writes follow each other, and how long readers may miss one before they are prompted.
  class Pace {
   public:
    /// Fifty robots of a secured fleet on one machine take twenty milliseconds for a cycle. Who was prompted
    /// in each had more to do, took longer, and was prompted more often.
    static constexpr std::chrono::milliseconds kSlowest{50};  ///< between writes that follow each other

    void written(Clock::time_point now);
    /// From the last write to the first prompt.
    Clock::duration patience(const Patience& most) const;

   private:
    Clock::time_point last_;   // write
    Clock::duration usual_{};  // between two writes, where they follow each other
  };

  /// A writer's part of it. May be used by any thread.
  class Task {
   public:
    /// @param prompt  called on the prompter's thread, until this is destroyed. It returns whether somebody
    ///                has to be prompted until he answers, however often that is
    Task(Prompter& prompter, std::function<bool()> prompt);
    Task(const Task&) = delete;
    Task& operator=(const Task&) = delete;
    ~Task();
    /// Something was written.
    void written();
    /// Somebody may have matched who has to answer.
    void matched();

   private:
    friend class Prompter;
    Prompter& prompter_;
    void expect(Clock::time_point now, Clock::duration patience, int prompts);  // under the prompter's mutex

    std::function<bool()> prompt_;
    // Under the prompter's mutex:
    Pace pace_;
    Clock::time_point began_;  // to wait for an answer
    Clock::time_point due_;    // of the next prompt
    int left_ = 0;             // prompts
  };

  explicit Prompter(Patience patience);
  Prompter(const Prompter&) = delete;
  Prompter& operator=(const Prompter&) = delete;
  ~Prompter();

 private:
  void serve(const std::stop_token& stop);
  Clock::time_point prompt_the_due(std::unique_lock<std::mutex>& lock);

  Patience patience_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::vector<Task*> tasks_;
  Task* prompted_ = nullptr;  // whose function runs at present
  Clock::time_point wakes_at_ = Clock::time_point::max();
  bool is_too_late_ = false;  // since something was written
  std::jthread thread_;
};

}  // namespace mlab::dds
