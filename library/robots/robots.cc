// The library's robots by name.

#include <algorithm>

#include "mlab/library/library.h"

namespace mlab::library {
namespace {

// The stock robots of the historic toolset all mean the standard robot.
constexpr struct {
  std::string_view program;
  std::string_view robot;
} kRobots[] = {{"scout", "Scout"},          {"standard", "Scout"},       {"robot", "Scout"},
               {"mlab-2.0-robot", "Scout"}, {"tmr_robot-1998", "Scout"}, {"mrv2", "MRV2"},
               {"rover", "Rover"}};

bool is_same(std::string_view a, std::string_view b) {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::equal(a, b, {}, small, small);
}

}  // namespace

std::string_view find_robot(std::string_view name) {
  for (const auto& one : kRobots) {
    if (is_same(one.program, name)) return one.robot;
  }
  return {};
}

}  // namespace mlab::library
