#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/flow/behavior.h"
#include "mlab/flow/frame.h"

namespace mlab::flow {

/// Runs one behavior alone: set its inputs and percepts, step it, read its output. What tests of behaviors,
/// and authors who try one out, use; no network is needed.
///
///     BehaviorProbe probe(*library.find("MoveToGoal").behavior);
///     probe.set("goal", Vector{3, 4}).set("success_radius", 1.0);
///     probe.step();
///     EXPECT_EQ(probe.output<Vector>(), (Vector{0.6, 0.8}));
class BehaviorProbe {
 public:
  /// Inputs with a default have it; the others are all zero bytes until set; lists are empty.
  explicit BehaviorProbe(const Behavior& behavior, std::uint64_t seed = 1, std::uint32_t robot = 1);

  /// Sets a scalar input. The name and the type must be the behavior's: anything else ends the program with a
  /// message.
  template <class T>
  BehaviorProbe& set(std::string_view input, const T& value) {
    write(find(input, type_info<T>(), false), 0, &value);
    return *this;
  }
  template <class T>
  BehaviorProbe& set_list(std::string_view input, const std::vector<T>& values) {
    const std::size_t i = find(input, type_info<T>(), true);
    values_[i].assign(values.size(), {});
    for (std::size_t n = 0; n < values.size(); ++n) write(i, n, &values[n]);
    return *this;
  }
  /// Sets an input as a network would write it: `set_text("formation", "Column")`.
  BehaviorProbe& set_text(std::string_view name, std::string_view text);

  percept::Percepts percepts;
  percept::Action action;

  /// One cycle; advances percepts.time by percepts.cycle_duration afterwards.
  void step();
  /// A cycle in which the behavior is not needed: it restarts when it is stepped again.
  void skip();

  template <class T>
  const T& output() const {
    return *static_cast<const T*>(output_of(type_info<T>()));
  }

 private:
  std::size_t find(std::string_view name, const TypeInfo& type, bool is_list) const;
  void write(std::size_t input, std::size_t position, const void* value);
  const void* output_of(const TypeInfo& type) const;

  const Behavior& behavior_;
  std::uint64_t seed_;
  std::uint32_t robot_;
  std::uint64_t cycle_ = 0;
  std::uint64_t last_fired_ = 0;
  std::vector<std::vector<std::vector<std::byte>>> values_;  // per input, per position
  Frame output_and_state_;
  std::uint32_t state_offset_ = 0;
};

}  // namespace mlab::flow
