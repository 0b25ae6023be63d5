#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>

#include "mlab/agents/topics.h"
#include "mlab/robot/program/robot_program.h"

namespace mlab::agents {

/// One run's conversation with an agent, on a thread of its own. Its robots end with it.
class Conversation {
 public:
  /// Writes an answer; called on the conversation's thread. False: it can't be written any more.
  /// @param is_awaited  false as soon as nobody waits for the answer any more
  using Answer = std::function<bool(std::string_view message, const std::function<bool()>& is_awaited)>;

  Conversation(robot::ProgramSources sources, Answer answer);
  Conversation(const Conversation&) = delete;
  Conversation& operator=(const Conversation&) = delete;
  ~Conversation();

  /// Takes a part of a message that has arrived. False: it is none, or one too many (each is answered before
  /// the next is sent), and the conversation is over.
  bool add(std::string_view part);
  /// It ends as soon as it can; nobody waits for its robots.
  void end();
  bool has_ended() const { return has_ended_.load(); }
  std::size_t robot_count() const { return robots_.load(); }

 private:
  void serve(const robot::ProgramSources& sources);

  Answer answer_;
  Assembly assembly_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::string> waiting_;
  std::atomic<bool> is_to_end_ = false;
  std::stop_source stop_;  // of what is built or started for it
  std::atomic<bool> has_ended_ = false;
  std::atomic<std::size_t> robots_ = 0;
  std::thread thread_;
};

}  // namespace mlab::agents
