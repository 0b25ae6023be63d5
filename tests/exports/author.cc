#include "author.h"

#include <fmt/core.h>

namespace mlab::exports_test {

int Author::pick(int below) {
  state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
  return static_cast<int>((state_ >> 33U) % static_cast<std::uint64_t>(below));
}

std::string Author::configuration() {
  return fmt::format(
      "architecture UGV;\n"
      "class Cart {{\n  actuator wheels: Drive() binds movement;\n}}\n"
      "robot R is Cart {{\n"
      "  movement = {};\n}}\n",
      sequence(3));
}

std::string Author::trigger(int depth) {
  std::string one = fmt::format("IsNotified(message = \"{}\")", "abcd"[pick(4)]);
  if (depth == 0) return one;
  switch (pick(5)) {
    case 0:
      return fmt::format("not {}", one);
    case 1:
      return fmt::format("({} and {})", trigger(depth - 1), trigger(depth - 1));
    case 2:
      return fmt::format("({} or {})", trigger(depth - 1), trigger(depth - 1));
    default:
      return one;
  }
}

std::string Author::member(int depth) {
  const int kind = depth == 0 ? 0 : pick(4);
  if (kind == 1 || kind == 2) return sequence(depth - 1);
  if (kind == 3 && is_parallel_)
    return fmt::format("cooperate {{ 1: {} as Left; 1: {} as Right; }}", sequence(depth - 1),
                       sequence(depth - 1));
  return "Stand()";
}

std::string Author::sequence(int depth) {
  const int count = 2 + pick(3);
  const int start = pick(count);
  std::string out = "sequence {\n";
  for (int i = 0; i < count; ++i) {
    const int ways = pick(4);
    out += fmt::format("{}{}S{}: {};\n", i == start ? "start " : "", ways == 0 ? "final " : "", i,
                       member(depth));
    for (int way = 0; way < ways; ++way)
      out += fmt::format("when {} goto S{}{};\n", trigger(2), pick(count), pick(4) == 0 ? " restart" : "");
  }
  return out + "}";
}

}  // namespace mlab::exports_test
