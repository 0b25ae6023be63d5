#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>

#include "mlab/agents/topics.h"
#include "mlab/dds/reader.h"
#include "mlab/dds/waiter.h"
#include "mlab/robot/remote/live_line.h"
#include "mlab/robot/remote/runner_server.h"

namespace mlab::agents {

/// One run's conversation with an agent, on a thread of its own. Its robots end with it.
class Conversation {
 public:
  /// Writes an answer; called on the conversation's thread. False: it can't be written any more.
  /// @param is_awaited  false as soon as nobody waits for the answer any more
  using Answer = std::function<bool(std::string_view message, const std::function<bool()>& is_awaited)>;

  /// Opens what passes in real time; called on the conversation's thread, at most once. Null: it can't be
  /// opened.
  using GoLive = std::function<std::shared_ptr<robot_remote::LiveLine>()>;

  /// @param terms   what they refer to outlives this
  /// @param waiter  is signalled by `requests`
  /// @param requests  what its run says from its second message on; until it goes live
  Conversation(robot_remote::AgentTerms terms, dds::Waiter waiter, dds::Reader::Branch requests,
               Answer answer, GoLive go_live);
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;
  ~Conversation();

  /// Takes a part of a message that has arrived otherwise. False: it is none, or one too many (each is
  /// answered before the next is sent), and the conversation is over.
  bool add(std::string_view part);
  /// It ends as soon as it can; nobody waits for its robots.
  void end();
  /// Whether an emergency stop holds has changed: it is heeded at once.
  void look_at_stop();
  bool has_ended() const { return has_ended_.load(); }
  /// A run has said who it is: it is more than a question.
  bool has_opened() const { return has_opened_.load(); }
  /// Its run has said that it ends.
  bool has_left() const { return has_left_.load(); }
  std::size_t robot_count() const { return robots_.load(); }
  /// It is in real time, and bears that nothing is heard of its run for a while.
  bool is_live() const { return is_live_.load(); }
  /// When something of the run was heard last; in real time only.
  robot_remote::Clock::time_point heard() const { return heard_.load(); }

 private:
  void serve(const robot_remote::AgentTerms& terms);
  std::optional<std::string> next_request(robot_remote::RunnerServer& server);
  std::optional<std::string> next_live(robot_remote::RunnerServer& server);

  bool take_part(std::string_view part);  // under the mutex
  bool hear_requests();

  dds::Waiter waiter_;
  std::optional<dds::Reader::Branch> requests_;  // of the conversation's thread; nothing: it is live
  Answer answer_;
  GoLive go_live_;
  std::function<bool()> is_stopped_;
  std::shared_ptr<robot_remote::LiveLine> live_;  // null: in lock-step
  Assembly assembly_;
  std::mutex mutex_;
  std::deque<std::string> waiting_;
  std::atomic<bool> is_to_end_ = false;
  std::stop_source stop_;  // of what is built or started for it
  std::atomic<bool> has_ended_ = false;
  std::atomic<std::size_t> robots_ = 0;
  std::atomic<bool> has_opened_ = false;
  std::atomic<bool> has_left_ = false;
  std::atomic<bool> is_live_ = false;
  std::atomic<robot_remote::Clock::time_point> heard_;
  bool stands_ = false;  // of the conversation's thread: all have been told to stand
  std::thread thread_;
};

}  // namespace mlab::agents
