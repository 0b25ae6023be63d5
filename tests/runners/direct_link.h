#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "mlab/robot/remote/link.h"
#include "mlab/robot/remote/runner_server.h"

namespace mlab::testing {

/// An agent on a thread of this process. It answers what comes until its link goes, or it is ended.
class DirectLink final : public robot_remote::Link {
 public:
  explicit DirectLink(robot::ProgramSources sources)
      : thread_([this, sources = std::move(sources)] { serve(sources); }) {}
  DirectLink(const DirectLink&) = delete;
  DirectLink& operator=(const DirectLink&) = delete;
  ~DirectLink() override { end(); }

  void send(std::string_view message) override {
    if (failure_.empty()) asked_.push(std::string(message));
  }
  std::optional<std::string_view> receive(robot_remote::Clock::time_point deadline) override {
    auto came = answers_.pop(deadline);
    if (!came) {
      if (answers_.has_ended() && failure_.empty()) failure_ = "ended";
      return std::nullopt;
    }
    last_ = std::move(*came);
    return last_;
  }
  const std::string& failure() const override { return failure_; }
  void fail(std::string why) override { failure_ = std::move(why); }

  /// From now on it takes so long for each answer.
  void slow_down(std::chrono::milliseconds by) { slowness_ = by; }
  /// As an agent that is killed.
  void end() {
    asked_.end();
    if (thread_.joinable()) thread_.join();
  }

 private:
  class Queue {
   public:
    void push(std::string message) {
      const std::scoped_lock lock(mutex_);
      messages_.push_back(std::move(message));
      changed_.notify_one();
    }
    void end() {
      const std::scoped_lock lock(mutex_);
      has_ended_ = true;
      changed_.notify_one();
    }
    bool has_ended() {
      const std::scoped_lock lock(mutex_);
      return has_ended_;
    }
    std::optional<std::string> pop(robot_remote::Clock::time_point deadline) {
      std::unique_lock lock(mutex_);
      changed_.wait_until(lock, deadline, [this] { return has_ended_ || !messages_.empty(); });
      if (messages_.empty()) return std::nullopt;
      std::string out = std::move(messages_.front());
      messages_.pop_front();
      return out;
    }

   private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::string> messages_;
    bool has_ended_ = false;
  };
  void serve(const robot::ProgramSources& sources) {
    robot_remote::RunnerServer server({.sources = sources});
    while (!asked_.has_ended()) {
      if (const auto message = asked_.pop(robot_remote::Clock::now() + std::chrono::seconds(1))) {
        std::string answer(server.answer(*message));
        std::this_thread::sleep_for(slowness_.load());
        answers_.push(std::move(answer));
      }
    }
    answers_.end();
  }

  Queue asked_;
  Queue answers_;
  std::atomic<std::chrono::milliseconds> slowness_ = std::chrono::milliseconds(0);
  std::string last_;
  std::string failure_;
  std::thread thread_;
};

}  // namespace mlab::testing
