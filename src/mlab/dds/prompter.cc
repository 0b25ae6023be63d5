#include "mlab/dds/prompter.h"

#include <algorithm>
#include <utility>

namespace mlab::dds {

void Prompter::Pace::written(Clock::time_point now) {
  const Clock::duration between = now - std::exchange(last_, now);
  // The shortest of late: one cycle in which something was lost must not make the next loss be noticed later.
  if (between < kSlowest) usual_ = std::min(between, usual_ + usual_ / 4 + std::chrono::microseconds(50));
}

Prompter::Clock::duration Prompter::Pace::patience(const Patience& most) const {
  return std::clamp<Clock::duration>(most.cycles * usual_, kFirst, most.longest);
}

Prompter::Task::Task(Prompter& prompter, std::function<bool()> prompt)
    : prompter_(prompter), prompt_(std::move(prompt)) {
  const std::scoped_lock lock(prompter_.mutex_);
  prompter_.tasks_.push_back(this);
}

Prompter::Task::~Task() {
  std::unique_lock lock(prompter_.mutex_);
  std::erase(prompter_.tasks_, this);
  prompter_.changed_.wait(lock, [this] { return prompter_.prompted_ != this; });
}

void Prompter::Task::written() {
  const Clock::time_point now = Clock::now();
  const std::scoped_lock lock(prompter_.mutex_);
  pace_.written(now);
  expect(now, pace_.patience(prompter_.patience_), kPrompts);
}

void Prompter::Task::matched() {
  const std::scoped_lock lock(prompter_.mutex_);
  expect(Clock::now(), Clock::duration::zero(), std::max(left_, 1));
}

void Prompter::Task::expect(Clock::time_point now, Clock::duration patience, int prompts) {
  began_ = now;
  due_ = now + patience;
  left_ = prompts;
  if (due_ >= prompter_.wakes_at_ || std::exchange(prompter_.is_too_late_, true)) return;
  prompter_.changed_.notify_all();
}

Prompter::Prompter(Patience patience)
    : patience_(patience), thread_([this](const std::stop_token& stop) { serve(stop); }) {}

Prompter::~Prompter() {
  thread_.request_stop();
}

// When the next one is due.
Prompter::Clock::time_point Prompter::prompt_the_due(std::unique_lock<std::mutex>& lock) {
  const auto is_earlier = [](const Task* one, const Task* other) {
    return std::pair(one->left_ == 0, one->due_) < std::pair(other->left_ == 0, other->due_);
  };
  for (;;) {
    const auto next = std::ranges::min_element(tasks_, is_earlier);
    if (next == tasks_.end() || (*next)->left_ == 0) return Clock::time_point::max();
    Task& task = **next;
    const Clock::time_point now = Clock::now();
    if (task.due_ > now) return task.due_;
    --task.left_;
    task.due_ = now + std::clamp<Clock::duration>((now - task.began_) / 2, kFirst, kMost);
    prompted_ = &task;
    lock.unlock();
    const bool has_to_answer = task.prompt_();
    lock.lock();
    if (has_to_answer) task.left_ = std::max(task.left_, 1);
    prompted_ = nullptr;
    changed_.notify_all();
  }
}

void Prompter::serve(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    wakes_at_ = prompt_the_due(lock);
    is_too_late_ = false;
    const auto is_too_late = [this] { return is_too_late_; };
    if (wakes_at_ == Clock::time_point::max())
      changed_.wait(lock, stop, is_too_late);
    else
      changed_.wait_until(lock, stop, wakes_at_, is_too_late);
  }
}

}  // namespace mlab::dds
