#include "mlab/robot_host/hosted_cycle.h"

#include <algorithm>
#include <cstring>
#include <ctime>
#include <utility>

#include <fmt/core.h>

#include "mlab/text/shown.h"

namespace mlab::robot_host {
namespace {

using robot_wire::Control;
using robot_wire::PlaceHeader;

constexpr timespec kNap{0, 2'000'000};        // between two looks at how the program is
constexpr double kAsleep = 0.02;              // a program that takes less of the time sleeps
constexpr double kSlowest = 150.0;            // times its processor time, on a busy machine
constexpr int kMostPatienceWithoutPlace = 3;  // processes that may end while nobody's program runs

}  // namespace

void HostedCycle::begin() {
  joined_.clear();
  if (memory_) memory_->clear_percepts();
}

std::size_t HostedCycle::join(std::uint32_t robot, std::uint64_t seed) {
  if (!memory_) {
    auto made = SharedMemory::make(program_->frame_size);
    if (made) memory_.emplace(std::move(*made));
    if (!made) unasked_ = made.error();
  }
  Joined& one = joined_.emplace_back();
  one.robot = robot;
  one.seed = seed;
  return joined_.size() - 1;
}

void HostedCycle::set(std::size_t place, const percept::Percepts& percepts,
                      std::span<const std::byte> frame) {
  if (!memory_) return;
  joined_[place].percepts = memory_->add_percepts(percepts);
  joined_[place].frame = frame;
}

// The process that computes; started where there is none.
std::optional<std::string> HostedCycle::ensure_process() {
  if (process_ && !process_->has_failed()) return std::nullopt;
  process_.reset();
  memory_->begin_anew(cycle_);
  auto started = start_hosted(*program_, &*memory_);
  if (!started) return started.error();
  process_.emplace(std::move(started->process));
  return std::nullopt;
}

void HostedCycle::fail_all(const std::string& why) {
  for (Joined& one : joined_) {
    if (one.takes_part) one.result.failure = why;
    one.takes_part = false;
  }
  asked_.clear();
}

// Puts frames of all that take part side by side.
void HostedCycle::fill() {
  asked_.clear();
  for (std::size_t i = 0; i < joined_.size(); ++i) {
    const Joined& one = joined_[i];
    if (!one.takes_part) continue;
    PlaceHeader& header = memory_->header(asked_.size());
    header.robot = one.robot;
    header.seed = one.seed;
    header.percepts = one.percepts;
    std::memcpy(memory_->frame(asked_.size()), one.frame.data(), one.frame.size());
    asked_.push_back(i);
  }
}

void HostedCycle::begin_cycle() {
  Control& control = memory_->control();
  control.count = static_cast<std::uint32_t>(asked_.size());
  control.asked.set(++cycle_);
}

void HostedCycle::ask() {
  asked_.clear();
  if (joined_.empty()) return;
  std::optional<std::string> problem;
  if (!memory_) {
    problem = unasked_;
  } else if (!memory_->make_room(joined_.size()) || !memory_->finish_percepts()) {
    problem = "has no memory to share with its run";
  } else {
    problem = ensure_process();
  }
  if (problem) {
    fail_all(*problem);
    return;
  }
  fill();
  begin_cycle();
}

void HostedCycle::wait(const Meanwhile& meanwhile) {
  int without_place = 0;
  while (!asked_.empty()) {
    const std::optional<Failure> failure = await(meanwhile);
    if (!failure) {
      take_results();
      return;
    }
    std::optional<std::string> problem;
    if (failure->place != Control::kNobody)
      blame(*failure);
    else if (++without_place == kMostPatienceWithoutPlace)
      problem = failure->what;
    // The others' cycle, from the frames that they had before it.
    asked_.clear();
    if (!std::ranges::any_of(joined_, &Joined::takes_part)) return;
    if (!problem) problem = ensure_process();
    if (problem) {
      fail_all(*problem);
      return;
    }
    fill();
    begin_cycle();
  }
}

HostedCycle::Failure HostedCycle::failure_of(std::string what) {
  const Control& control = memory_->control();
  Failure out{std::move(what), control.place.load(), control.node.load()};
  if (control.out_of_memory.load() != 0)
    out.what = fmt::format("needed more than {} MB of memory", program_->launch.policy.memory >> 20);
  if (out.place >= asked_.size()) out.place = Control::kNobody;
  return out;
}

std::optional<HostedCycle::Failure> HostedCycle::await(const Meanwhile& meanwhile) {
  Control& control = memory_->control();
  const auto is_this_cycle = [this](std::uint32_t answered) { return answered == cycle_; };
  if (control.answered.is_soon(is_this_cycle)) return std::nullopt;
  std::uint32_t place = Control::kNobody;
  auto began = Clock::now();
  double used = process_->processor_time();
  while (!control.answered.is_after_sleep(is_this_cycle, kNap)) {
    if (process_->note_end()) return failure_of(process_->failure());
    if (meanwhile && meanwhile()) {
      process_->fail("was ended, because nobody waits for it any more");
      return failure_of(process_->failure());
    }
    // Each robot's program has the whole time. They run in their order, so a program that plays with the
    // number gains no more than that.
    const std::uint32_t now = control.place.load();
    if (now < asked_.size() && (place == Control::kNobody || now > place)) {
      place = now;
      began = Clock::now();
      used = process_->processor_time();
      continue;
    }
    const double computed = process_->processor_time() - used;
    const double waited = std::chrono::duration<double>(Clock::now() - began).count();
    if (computed > program_->limits.cycle)
      process_->fail(
          fmt::format("did not come to an end within {} s of processor time", program_->limits.cycle));
    else if (waited > program_->limits.cycle_wall &&
             (computed < kAsleep * waited || waited > kSlowest * program_->limits.cycle))
      process_->fail(fmt::format("gave no answer for {} s", program_->limits.cycle_wall));
    if (process_->has_failed()) return failure_of(process_->failure());
  }
  return std::nullopt;
}

void HostedCycle::blame(const Failure& failure) {
  Joined& one = joined_[asked_[failure.place]];
  one.takes_part = false;
  one.result.failure = failure.what;
  if (failure.node < program_->codes.size() && !program_->codes[failure.node].empty())
    one.result.failure += fmt::format(", in {}", program_->codes[failure.node]);
}

void HostedCycle::take_results() {
  for (std::size_t i = 0; i < asked_.size(); ++i) {
    Joined& one = joined_[asked_[i]];
    const auto action = robot_wire::sound_action(memory_->header(i).action);
    if (!action) {
      one.result.failure = "answers nonsense: its action has fields that there are not";
      continue;
    }
    one.result.action = *action;
    one.result.frame = {memory_->frame(i), memory_->frame_size()};
  }
}

}  // namespace mlab::robot_host
