#include "mlab/agents/conversation.h"

#include <chrono>
#include <utility>

#include "mlab/robot/remote/runner_server.h"

namespace mlab::agents {
namespace {

constexpr std::size_t kMostWaiting = 4;               // messages
constexpr std::chrono::seconds kOpeningPatience(10);  // for a run to say who it is

}  // namespace

Conversation::Conversation(robot::ProgramSources sources, Answer answer) : answer_(std::move(answer)) {
  sources.ends = stop_.get_token();
  thread_ = std::thread([this, sources = std::move(sources)] { serve(sources); });
}

Conversation::~Conversation() {
  end();
  thread_.join();
}

bool Conversation::add(std::string_view part) {
  const Assembly::Outcome outcome = assembly_.add(part);
  if (outcome == Assembly::Outcome::kNonsense) return false;
  if (outcome == Assembly::Outcome::kMoreFollows) return true;
  const std::scoped_lock lock(mutex_);
  if (waiting_.size() >= kMostWaiting) return false;
  waiting_.push_back(assembly_.message());
  changed_.notify_one();
  return true;
}

void Conversation::end() {
  const std::scoped_lock lock(mutex_);
  is_to_end_ = true;
  stop_.request_stop();
  changed_.notify_one();
}

void Conversation::serve(const robot::ProgramSources& sources) {
  robot_remote::RunnerServer server(sources);
  const auto nobody_waits = [this] { return is_to_end_.load(); };
  for (;;) {
    std::string message;
    {
      std::unique_lock lock(mutex_);
      const auto has_news = [this] { return is_to_end_ || !waiting_.empty(); };
      if (server.is_open())
        changed_.wait(lock, has_news);
      else
        changed_.wait_for(lock, kOpeningPatience, has_news);
      if (is_to_end_ || waiting_.empty()) break;
      message = std::move(waiting_.front());
      waiting_.pop_front();
    }
    const std::string_view answer = server.answer(message, nobody_waits);
    robots_ = server.robot_count();
    if (!answer_(answer, [this] { return !is_to_end_.load(); })) break;
  }
  has_ended_ = true;
}

}  // namespace mlab::agents
