#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace mlab::robot {

/// Robots by number; those of robots that went are given again.
template <class Robot>
class Members {
 public:
  std::uint32_t add(Robot robot) {
    if (free_.empty()) {
      all_.push_back(std::move(robot));
      return static_cast<std::uint32_t>(all_.size() - 1);
    }
    const std::uint32_t member = free_.back();
    free_.pop_back();
    all_[member] = std::move(robot);
    return member;
  }
  void remove(std::uint32_t member) {
    all_[member] = {};
    free_.push_back(member);
  }
  Robot& operator[](std::uint32_t member) { return all_[member]; }
  const Robot& operator[](std::uint32_t member) const { return all_[member]; }
  auto begin() const { return all_.begin(); }
  auto end() const { return all_.end(); }

 private:
  std::vector<Robot> all_;
  std::vector<std::uint32_t> free_;
};

}  // namespace mlab::robot
