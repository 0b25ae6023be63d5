#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <string_view>

#include "mlab/base/random.h"
#include "mlab/flow/limit.h"
#include "mlab/flow/lists.h"
#include "mlab/flow/type_info.h"
#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"
#include "mlab/percept/sensors.h"

namespace mlab::flow {

/// One input of a behavior, as its author declared it.
struct Input {
  std::string_view name;
  const TypeInfo* type = nullptr;
  std::string_view unit;          ///< `m`, `m/s`, `rad`, `deg`, `s`, ...; empty: none said
  std::string_view help;          ///< one line
  bool is_list = false;           ///< takes any number of sources
  std::string_view default_text;  ///< as a constant of CNL; empty: the input has to be linked
  double min = -kNoLimit;         ///< of the values it takes, in `unit`
  double max = kNoLimit;
};

/// Another name of a behavior, with the port names and units that go with it: how historic networks call it.
struct Alias {
  std::string_view name;
  /// Per input of the behavior, in order: the name and unit it has under this alias; `a|b` gives it two
  /// names; an empty name hides the input, which then takes its default. Empty span: all as declared.
  struct Port {
    std::string_view name;
    std::string_view unit;
  };
  std::span<const Port> inputs;
  /// Inputs that historic networks link and that mean nothing here: accepted and ignored.
  std::span<const std::string_view> ignored_inputs;
  std::string_view output_unit;
};

/// A sensor that a behavior reads, and how far at most.
struct Need {
  percept::Sensor sensor = percept::Sensor::kObstacles;
  int range_input = -1;  ///< the input that holds the range [m]; -1: `range` does
  double range = 0.0;    ///< [m]; 0 where the sensor has its own
};

/// What all nodes of one robot share in one cycle.
struct Cycle {
  const percept::Percepts* percepts = nullptr;
  percept::Action* action = nullptr;
  std::uint64_t number = 0;  ///< of the cycle, from 1; grows by one with every step of the robot
  std::uint64_t seed = 0;    ///< of the run
  std::uint32_t robot = 0;   ///< id, keys the random streams
};

struct Call;
using FireFunction = void (*)(Call&);

/// A primitive behavior: a function with typed inputs and one output. Everything that anybody asks about it
/// stands here and nowhere else. Descriptors are constants with static lifetime (of the program, or of the
/// shared library that brought them).
struct Behavior {
  std::string_view name;
  std::string_view help;             ///< what it does; the first sentence is the one-line help
  std::string_view source;           ///< where the formula comes from; may be empty
  std::string_view file;             ///< the `.cnl` file and line that defines it: `move_to_goal.cnl:12`
  const TypeInfo* output = nullptr;  ///< null: a sink
  std::string_view output_unit;
  std::span<const Input> inputs;
  std::span<const Alias> aliases;
  std::span<const Need> needs;
  bool is_pure = false;          ///< no state, no randomness, reads neither percepts nor time
  int latency_cycles = 0;        ///< > 0: asynchronous; its value comes that many cycles after its inputs
  std::uint32_t state_size = 0;  ///< bytes of `once` variables and header variables together
  std::uint32_t state_alignment = 1;
  bool has_header = false;  ///< restarting it makes a difference
  FireFunction fire = nullptr;
  void (*write_initial_output)(void* out) = nullptr;  ///< value of the output before it ever fired
};

/// What of a firing is the same in each cycle: where the node's output and state are in the frame.
struct Firing {
  std::uint32_t output = 0;
  std::uint32_t state = 0;
  std::uint64_t path_hash = 0;
};

/// One firing of one node. Made by the program; the code that the CNL compiler generates reads it.
struct Call : Firing {
  const Cycle* cycle = nullptr;
  std::byte* frame = nullptr;
  /// Offsets in the frame, in input order. A list input takes one word with the count n, then n offsets.
  const std::uint32_t* inputs = nullptr;
  // Of nodes that have no state, and no header, nobody knows when they fired.
  std::uint32_t now = 0;    ///< the cycle
  std::uint32_t fired = 0;  ///< the cycle in which the node fired last; 0: in none

  /// The node never fired before: `once` runs.
  bool is_first() const { return fired == 0; }
  /// It did not fire in the cycle before: the header runs (true as well where is_first).
  bool is_restart() const { return fired != now - 1 || is_first(); }
  template <class T>
  T& at(std::uint32_t offset) const {
    return *std::launder(reinterpret_cast<T*>(frame + offset));
  }
  base::Random random() const {
    return base::Random::of(cycle->seed, cycle->robot, path_hash, cycle->number);
  }
};

/// How a procedure sees a value that flows: itself, except for readings, which it sees as lists of this
/// cycle.
template <class T>
const T& view(const T& value, const percept::Percepts&) {
  return value;
}
inline ListView<percept::Obstacle> view(const Obstacles& list, const percept::Percepts& p) {
  return {list, p.obstacles};
}
inline ListView<percept::RobotReading> view(const Robots& list, const percept::Percepts& p) {
  return {list, p.robots};
}
inline ListView<percept::ObjectReading> view(const Objects& list, const percept::Percepts& p) {
  return {list, p.objects};
}
inline std::span<const percept::RangeReading> view(const Ranges& ring, const percept::Percepts& p) {
  return p.ranges.first(ring.count <= p.ranges.size() ? ring.count : p.ranges.size());
}

/// How a procedure sees a list input: values by position, in the order of the links.
template <class T>
class ListInput {
 public:
  ListInput(const std::byte* frame, const std::uint32_t* offsets, std::size_t count)
      : frame_(frame), offsets_(offsets), count_(count) {}
  std::size_t size() const { return count_; }
  const T& operator[](std::size_t i) const {
    return *std::launder(reinterpret_cast<const T*>(frame_ + offsets_[i]));
  }

 private:
  const std::byte* frame_;
  const std::uint32_t* offsets_;
  std::size_t count_;
};

}  // namespace mlab::flow
