#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>

#include "mlab/base/hash.h"
#include "mlab/geom/pose.h"
#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"

namespace mlab::schema {

/// The most tasks that a robot has at a time.
inline constexpr std::size_t kMostTasks = 32;

/// In the place of a task's name: any. As base::hash_text gives it.
inline constexpr std::uint64_t kAnyTask = base::hash_text("*");

/// Whether a robot has the task, and has not told yet that it is done.
inline bool is_held(const percept::Contract& contract, base::RobotId robot) {
  using percept::ContractState;
  return contract.contractor == robot &&
         (contract.state == ContractState::kAwarded || contract.state == ContractState::kStarted);
}

/// Whether a task is of that name (base::hash_text), or any counts.
inline bool is_named(const percept::Contract& contract, std::uint64_t name) {
  return name == kAnyTask || contract.task == name;
}

/// The way of a robot to the places of tasks, one after the other. Each task is put in where it makes the way
/// least longer; then pieces of the way are turned round or moved as long as that shortens it.
/// @source  cheapest insertion: Rosenkrantz, Stearns, Lewis 1977, "An Analysis of Several Heuristics for the
/// Traveling
///          Salesman Problem"; as bids: Lagoudakis et al. 2005, "Auction-Based Multi-Robot Routing"
///          (BidSumPath)
class TaskWay {
 public:
  explicit TaskWay(geom::Point start) : start_(start) {}
  /// The way to the tasks that this robot has, put in in the order in which it was awarded them.
  /// @param without  one that is left out; null: none
  explicit TaskWay(const percept::Percepts& percepts, const percept::Contract* without = nullptr);

  std::size_t size() const { return size_; }
  std::span<const percept::Contract* const> tasks() const { return {tasks_.data(), size_}; }
  /// How much longer the way becomes with that place [m].
  double added(geom::Point place) const { return best(place).length; }
  /// Leaves it as it is where it has kMostTasks already.
  void insert(const percept::Contract& contract);
  /// From its start over all places [m].
  double length() const;
  /// Turns pieces round, and moves single places, as long as the way becomes shorter by that.
  /// @source  2-opt: Croes 1958, "A Method for Solving Traveling-Salesman Problems"; places that move: Or
  /// 1976
  void shorten();

 private:
  static constexpr double kShorter = 1e-6;  // than before [m]
  struct Insertion {
    std::size_t at;
    double length;
  };
  Insertion best(geom::Point place) const;
  geom::Point place(std::size_t i) const { return i == 0 ? start_ : tasks_[i - 1]->place; }
  bool turn_a_piece();
  bool move_a_place();

  geom::Point start_;
  std::array<const percept::Contract*, kMostTasks> tasks_{};
  std::size_t size_ = 0;
};

inline TaskWay::Insertion TaskWay::best(geom::Point place) const {
  Insertion out{0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i <= size_; ++i) {
    const geom::Point before = i == 0 ? start_ : tasks_[i - 1]->place;
    double length = geom::distance(before, place);
    if (i < size_)
      length += geom::distance(place, tasks_[i]->place) - geom::distance(before, tasks_[i]->place);
    if (length < out.length) out = {i, length};
  }
  return out;
}

inline void TaskWay::insert(const percept::Contract& contract) {
  if (size_ == kMostTasks) return;
  const std::size_t at = best(contract.place).at;
  std::copy_backward(tasks_.begin() + static_cast<std::ptrdiff_t>(at),
                     tasks_.begin() + static_cast<std::ptrdiff_t>(size_),
                     tasks_.begin() + static_cast<std::ptrdiff_t>(size_ + 1));
  tasks_[at] = &contract;
  ++size_;
}

inline double TaskWay::length() const {
  double out = 0.0;
  for (std::size_t i = 0; i < size_; ++i)
    out += geom::distance(i == 0 ? start_ : tasks_[i - 1]->place, tasks_[i]->place);
  return out;
}

inline bool TaskWay::turn_a_piece() {
  for (std::size_t i = 0; i + 1 < size_; ++i) {
    for (std::size_t j = i + 1; j < size_; ++j) {
      double change = geom::distance(place(i), tasks_[j]->place) - geom::distance(place(i), tasks_[i]->place);
      if (j + 1 < size_) {
        change += geom::distance(tasks_[i]->place, tasks_[j + 1]->place) -
                  geom::distance(tasks_[j]->place, tasks_[j + 1]->place);
      }
      if (!(change < -kShorter)) continue;
      std::reverse(tasks_.begin() + static_cast<std::ptrdiff_t>(i),
                   tasks_.begin() + static_cast<std::ptrdiff_t>(j + 1));
      return true;
    }
  }
  return false;
}

inline bool TaskWay::move_a_place() {
  const double before = length();
  for (std::size_t i = 0; i < size_ && size_ > 1; ++i) {
    TaskWay other = *this;
    std::copy(other.tasks_.begin() + static_cast<std::ptrdiff_t>(i + 1),
              other.tasks_.begin() + static_cast<std::ptrdiff_t>(size_),
              other.tasks_.begin() + static_cast<std::ptrdiff_t>(i));
    --other.size_;
    other.insert(*tasks_[i]);
    if (!(other.length() < before - kShorter)) continue;
    *this = other;
    return true;
  }
  return false;
}

inline void TaskWay::shorten() {
  // Where places are so far away that the last digits count, what seems shorter need not be.
  constexpr int kMostChanges = 1000;
  for (int i = 0; i < kMostChanges && (turn_a_piece() || move_a_place()); ++i) {
  }
}

inline TaskWay::TaskWay(const percept::Percepts& percepts, const percept::Contract* without)
    : start_(percepts.pose.position) {
  std::array<const percept::Contract*, kMostTasks> held{};
  std::size_t count = 0;
  for (const percept::Contract& contract : percepts.contracts) {
    if (&contract != without && count < kMostTasks && is_held(contract, percepts.id))
      held[count++] = &contract;
  }
  // A team awards one task in a cycle; equal times are those of merged teams, which stay as they stand.
  std::span<const percept::Contract*> all(held.data(), count);
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t j = i; j > 0 && all[j]->time < all[j - 1]->time; --j) std::swap(all[j], all[j - 1]);
  }
  for (const percept::Contract* contract : all) insert(*contract);
  shorten();
}

/// The first task of a name on a robot's way to all that it has; null: it has none.
inline const percept::Contract* next_task(const percept::Percepts& percepts, std::uint64_t name) {
  const TaskWay way(percepts);
  for (const percept::Contract* contract : way.tasks()) {
    if (is_named(*contract, name)) return contract;
  }
  return nullptr;
}

/// A request about a task.
inline percept::Request about_task(percept::Request::Kind kind, const percept::Contract& contract) {
  percept::Request out;
  out.kind = kind;
  out.notification = contract.task;
  out.object = contract.object;
  return out;
}

/// Asks for what no other node of the cycle has asked for already. @return  false: there is no room
inline bool ask_once(percept::Action& action, const percept::Request& request) {
  for (std::uint8_t i = 0; i < action.request_count; ++i) {
    const percept::Request& one = action.requests[i];
    if (one.kind == request.kind && one.notification == request.notification && one.object == request.object)
      return true;
  }
  return action.ask(request);
}

/// Tells that this robot still works on the tasks that it has, where it has some.
inline void keep_tasks(const percept::Percepts& percepts, percept::Action& action) {
  for (const percept::Contract& contract : percepts.contracts) {
    if (!is_held(contract, percepts.id)) continue;
    percept::Request request;
    request.kind = percept::Request::Kind::kKeepTasks;
    ask_once(action, request);
    return;
  }
}

}  // namespace mlab::schema
