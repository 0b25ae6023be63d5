#include "mlab/robot/host/hosted_cycle.h"

#include <algorithm>
#include <cstring>
#include <ctime>
#include <ranges>
#include <utility>

#include <fmt/core.h>

#include "mlab/text/shown.h"

namespace mlab::robot_host {
namespace {

using robot_wire::Control;
using robot_wire::PlaceHeader;

// Between two looks at how the program is. Where a machine has many robots a cycle of all takes longer than
// some milliseconds, and to wake up in each only to see that nothing has happened yet took more than the
// program.
constexpr timespec kNap{0, 20'000'000};
constexpr double kAsleep = 0.02;              // a program that takes less of the time sleeps
constexpr double kSlowest = 150.0;            // times its processor time, on a busy machine
constexpr std::uint32_t kAskedAtOnce = 4;     // robots; to ask for each costs more
constexpr int kMostPatienceWithoutPlace = 3;  // processes that may end while nobody's program runs

}  // namespace

// It has nothing to bring to an end, so nobody waits for it.
HostedCycle::~HostedCycle() {
  if (process_) process_->fail(kNotAwaited);
}

void HostedCycle::begin() {
  count_ = 0;
  asked_.clear();
  if (memory_) memory_->clear_percepts();
}

std::size_t HostedCycle::join(std::uint32_t robot, std::uint64_t seed) {
  if (count_ == joined_.size()) joined_.emplace_back();
  Joined& one = joined_[count_];
  one.robot = robot;
  one.seed = seed;
  one.is_set.store(false, std::memory_order_relaxed);
  one.failure.clear();
  return count_++;
}

void HostedCycle::open() {
  if (count_ == 0) return;
  if (const auto problem = prepare())
    fail_all(*problem);
  else
    begin_asking();
}

std::optional<std::string> HostedCycle::prepare() {
  if (!memory_) {
    auto made = SharedMemory::make(program_->frame_size);
    if (!made) return made.error();
    memory_.emplace(std::move(*made));
  }
  if (!memory_->make_room(count_)) return "has no memory to share with its run";
  return ensure_process();
}

// The process that computes; started where there is none.
std::optional<std::string> HostedCycle::ensure_process() {
  if (process_ && !process_->has_failed()) return std::nullopt;
  if (process_) said_before_ = process_->said();
  process_.reset();
  memory_->begin_anew(asked_ever_);
  auto started = start_hosted(*program_, &*memory_);
  if (!started) return started.error();
  process_.emplace(std::move(started->process));
  return std::nullopt;
}

void HostedCycle::fail_all(const std::string& why) {
  for (std::size_t i = 0; i < count_; ++i) {
    if (joined_[i].failure.empty()) joined_[i].failure = why;
  }
  asked_.clear();
}

void HostedCycle::begin_asking() {
  asked_.clear();
  next_ = 0;
  memory_->control().before = asked_ever_;
}

void HostedCycle::hand_over(Joined& one) {
  one.slot = asked_.size();
  PlaceHeader& header = memory_->header(one.slot);
  header.robot = one.robot;
  header.seed = one.seed;
  header.percepts = one.percepts;
  std::memcpy(memory_->frame(one.slot), one.frame.data(), one.frame.size());
  header.has_interventions = one.interventions != nullptr ? 1 : 0;
  if (one.interventions != nullptr) memory_->interventions(one.slot) = *one.interventions;
  asked_.push_back(&one);
  ++asked_ever_;
}

void HostedCycle::set(std::size_t place, const percept::Percepts& percepts, std::span<const std::byte> frame,
                      const flow::Interventions* interventions) {
  Joined& one = joined_[place];
  if (!one.failure.empty()) return;
  one.percepts = memory_->add_percepts(percepts);
  one.frame = frame;
  one.interventions = interventions;
  one.is_set.store(true, std::memory_order_release);
  // Whoever comes while another thread hands over leaves it to that one, or to those who come later.
  if (!is_early_) return;
  if (const std::unique_lock lock(handing_over_, std::try_to_lock); lock) hand_over_what_is_set();
}

// In the order in which they joined, whatever thread it is.
void HostedCycle::hand_over_what_is_set() {
  while (next_ < count_ && joined_[next_].is_set.load(std::memory_order_acquire) &&
         memory_->has_all_percepts())
    hand_over(joined_[next_++]);
  if (asked_ever_ - asked_for_ >= kAskedAtOnce) ask_for_all();
}

void HostedCycle::ask_for_all() {
  asked_for_ = asked_ever_;
  memory_->control().asked.set(asked_for_);
}

void HostedCycle::ask() {
  if (count_ == 0 || !joined_[0].failure.empty()) return;
  if (!memory_->finish_percepts()) {
    process_->fail("has no memory to share with its run");  // it may be computing
    fail_all(process_->failure());
    return;
  }
  const std::scoped_lock lock(handing_over_);
  hand_over_what_is_set();
  ask_for_all();
}

void HostedCycle::wait(const Meanwhile& meanwhile) {
  int without_place = 0;
  int kills = 0;
  while (!asked_.empty()) {
    const std::optional<Failure> failure = await(meanwhile);
    if (!failure) return;
    std::optional<std::string> problem;
    const bool is_nobodys = failure->place == Control::kNobody || (failure->was_killed && kills++ == 0);
    if (!is_nobodys)
      blame(*failure);
    else if (++without_place == kMostPatienceWithoutPlace)
      problem = failure->what;
    asked_.clear();
    const bool are_all_failed = std::ranges::none_of(joined_ | std::views::take(count_),
                                                     [](const Joined& one) { return one.failure.empty(); });
    if (are_all_failed) return;
    if (!problem) problem = ensure_process();
    if (problem) {
      fail_all(*problem);
      return;
    }
    ask_again();
  }
}

// The others' cycle, from the frames that they had before it.
void HostedCycle::ask_again() {
  begin_asking();
  for (; next_ < count_; ++next_) {
    if (joined_[next_].failure.empty()) hand_over(joined_[next_]);
  }
  ask_for_all();
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
  const auto are_all = [this](std::uint32_t answered) { return answered == asked_ever_; };
  if (control.answered.is_soon(are_all, looks_)) return std::nullopt;
  std::uint32_t place = Control::kNobody;
  auto began = Clock::now();
  // As of the first look: of what a program took before that nothing has to be known where it answers in
  // time.
  std::optional<double> used;
  while (!control.answered.is_after_sleep(are_all, kNap)) {
    if (process_->note_end()) {
      Failure out = failure_of(process_->failure());
      out.was_killed = process_->was_killed();
      return out;
    }
    if (meanwhile && meanwhile()) {
      process_->fail(kNotAwaited);
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
    if (!used) used = process_->processor_time();
    const double computed = process_->processor_time() - *used;
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
  Joined& one = *asked_[failure.place];
  one.failure = failure.what;
  if (failure.node < program_->codes.size() && !program_->codes[failure.node].empty())
    one.failure += fmt::format(", in {}", program_->codes[failure.node]);
}

HostedCycle::Outcome HostedCycle::take(std::size_t place, percept::Action& action,
                                       flow::Interventions* interventions) {
  const Joined& one = joined_[place];
  if (!one.failure.empty()) return {{}, one.failure};
  if (!robot_wire::read_action(memory_->header(one.slot).action, action))
    return {{}, "answers nonsense: its action has fields that there are not"};
  if (interventions != nullptr) interventions->take_notes_of(memory_->interventions(one.slot));
  return {{memory_->frame(one.slot), memory_->frame_size()}, ""};
}

std::string HostedCycle::said() {
  return said_before_ + (process_ ? process_->said() : "");
}

}  // namespace mlab::robot_host
