#include "mlab/agents/conversation.h"

#include <utility>

#include "mlab/robot/remote/runner_server.h"

namespace mlab::agents {

Conversation::Conversation(robot::ProgramSources sources, Answer answer)
    : answer_(std::move(answer)), thread_([this, sources = std::move(sources)] { serve(sources); }) {}

Conversation::~Conversation() {
  end();
  thread_.join();
}

bool Conversation::add(std::string_view part) {
  const Assembly::Outcome outcome = assembly_.add(part);
  if (outcome == Assembly::Outcome::kNonsense) return false;
  if (outcome == Assembly::Outcome::kMoreFollows) return true;
  const std::scoped_lock lock(mutex_);
  waiting_.push_back(assembly_.message());
  changed_.notify_one();
  return true;
}

void Conversation::end() {
  const std::scoped_lock lock(mutex_);
  is_to_end_ = true;
  changed_.notify_one();
}

void Conversation::serve(const robot::ProgramSources& sources) {
  robot_remote::RunnerServer server(sources);
  const auto nobody_waits = [this] { return is_to_end_.load(); };
  for (;;) {
    std::string message;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return is_to_end_ || !waiting_.empty(); });
      if (is_to_end_) break;
      message = std::move(waiting_.front());
      waiting_.pop_front();
    }
    const std::string_view answer = server.answer(message, nobody_waits);
    robots_ = server.robot_count();
    if (!answer_(answer)) break;
  }
  has_ended_ = true;
}

}  // namespace mlab::agents
