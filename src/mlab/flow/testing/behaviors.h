#pragma once

#include <string>
#include <utility>
#include <vector>

#include "mlab/flow/port_types.h"
#include "mlab/flow/program.h"

namespace mlab::flow::test {

/// Counts how often it fired since its header ran; `start` is added.
inline void fire_count(Call& call) {
  int& state = call.at<int>(call.state);
  if (call.is_restart()) state = 0;
  call.at<int>(call.output) = ++state + call.at<int>(call.inputs[0]);
}
inline const Behavior& count() {
  static const Input kInputs[] = {{"start", &type_info<int>(), "", "", false, "0", -100, 100}};
  static const Behavior kBehavior = [] {
    Behavior b;
    b.name = "Count";
    b.help = "Counts its firings.";
    b.output = &type_info<int>();
    b.inputs = kInputs;
    b.state_size = b.state_alignment = sizeof(int);
    b.has_header = true;
    b.fire = fire_count;
    return b;
  }();
  return kBehavior;
}

/// Sum of two, pure.
inline void fire_add(Call& call) {
  call.at<double>(call.output) = call.at<double>(call.inputs[0]) + call.at<double>(call.inputs[1]);
}
inline const Behavior& add() {
  static const Input kInputs[] = {{"a", &type_info<double>(), "", "", false, "", -kNoLimit, kNoLimit},
                                  {"b", &type_info<double>(), "", "", false, "0", -kNoLimit, kNoLimit}};
  static const Behavior kBehavior = [] {
    Behavior b;
    b.name = "Add";
    b.output = &type_info<double>();
    b.inputs = kInputs;
    b.is_pure = true;
    b.fire = fire_add;
    return b;
  }();
  return kBehavior;
}

/// True from the `at`-th firing after a restart on.
inline void fire_after(Call& call) {
  int& state = call.at<int>(call.state);
  if (call.is_restart()) state = 0;
  call.at<bool>(call.output) = ++state >= call.at<int>(call.inputs[0]);
}
inline const Behavior& after() {
  static const Input kInputs[] = {{"at", &type_info<int>(), "", "", false, "1", 0, 1000}};
  static const Behavior kBehavior = [] {
    Behavior b;
    b.name = "After";
    b.output = &type_info<bool>();
    b.inputs = kInputs;
    b.state_size = b.state_alignment = sizeof(int);
    b.has_header = true;
    b.fire = fire_after;
    return b;
  }();
  return kBehavior;
}

/// Direction of a heading [rad], pure; its historic name counts in degrees.
inline void fire_heading(Call& call) {
  call.at<double>(call.output) = call.at<double>(call.inputs[0]);
}
inline const Behavior& heading() {
  static const Input kInputs[] = {{"angle", &type_info<double>(), "rad", "", false, "", -10, 10}};
  static const Alias::Port kPorts[] = {{"angle_degrees|angle_d", "deg"}};
  static const Alias kAliases[] = {{"HEADING", kPorts, {}, "deg"}};
  static const Behavior kBehavior = [] {
    Behavior b;
    b.name = "Heading";
    b.output = &type_info<double>();
    b.output_unit = "rad";
    b.inputs = kInputs;
    b.aliases = kAliases;
    b.is_pure = true;
    b.fire = fire_heading;
    return b;
  }();
  return kBehavior;
}

/// Sums a list of numbers.
inline void fire_sum(Call& call) {
  double sum = 0.0;
  for (std::uint32_t i = 0; i < call.inputs[0]; ++i) sum += call.at<double>(call.inputs[1 + i]);
  call.at<double>(call.output) = sum;
}
inline const Behavior& sum() {
  static const Input kInputs[] = {{"values", &type_info<double>(), "", "", true, "", -kNoLimit, kNoLimit}};
  static const Behavior kBehavior = [] {
    Behavior b;
    b.name = "Sum";
    b.output = &type_info<double>();
    b.inputs = kInputs;
    b.is_pure = true;
    b.fire = fire_sum;
    return b;
  }();
  return kBehavior;
}

/// Sinks: make a value be evaluated, and show it as the action's forward speed.
inline void fire_show(Call& call) {
  call.cycle->action->velocity.x = call.at<double>(call.inputs[0]);
  call.cycle->action->drives = true;
}
inline const Behavior& show() {
  static const Input kInputs[] = {{"value", &type_info<double>(), "", "", false, "", -kNoLimit, kNoLimit}};
  static const Behavior kBehavior = [] {
    Behavior b;
    b.name = "Show";
    b.inputs = kInputs;
    b.fire = fire_show;
    return b;
  }();
  return kBehavior;
}

/// Takes three cycles: the square of its input. Keeps how often it ran in its state.
inline void fire_square(Call& call) {
  int& runs = call.at<int>(call.state);
  if (call.is_first()) runs = 0;
  ++runs;
  const double x = call.at<double>(call.inputs[0]);
  call.at<double>(call.output) = x * x + 1000.0 * runs;
}
inline const Behavior& slow_square() {
  static const Input kInputs[] = {{"x", &type_info<double>(), "", "", false, "", -kNoLimit, kNoLimit}};
  static const Behavior kBehavior = [] {
    Behavior b;
    b.name = "SlowSquare";
    b.output = &type_info<double>();
    b.inputs = kInputs;
    b.latency_cycles = 3;
    b.state_size = b.state_alignment = sizeof(int);
    b.fire = fire_square;
    return b;
  }();
  return kBehavior;
}

/// How many obstacles are in sight.
inline void fire_look(Call& call) {
  call.at<int>(call.output) = static_cast<int>(call.cycle->percepts->obstacles.size());
}
inline const Behavior& look() {
  static const Input kInputs[] = {{"range", &type_info<double>(), "", "", false, "1", 0, 1e6}};
  static const Need kNeeds[] = {{percept::Sensor::kObstacles, 0}};
  static const Behavior kBehavior = [] {
    Behavior b;
    b.name = "Look";
    b.output = &type_info<int>();
    b.inputs = kInputs;
    b.needs = kNeeds;
    b.fire = fire_look;
    return b;
  }();
  return kBehavior;
}

inline Library library() {
  static const Behavior* const kAll[] = {&count(), &add(),  &after(),       &heading(),
                                         &sum(),   &show(), &slow_square(), &look()};
  Library out;
  out.add(kAll);
  return out;
}

inline Source constant(std::string text) {
  return {Source::Kind::kConstant, std::move(text), {}};
}
inline Source name(std::string text) {
  return {Source::Kind::kName, std::move(text), {}};
}

inline Node node(std::string node_name, std::string behavior,
                 const std::vector<std::pair<std::string, Source>>& links = {}) {
  Node out;
  out.name = std::move(node_name);
  out.behavior = std::move(behavior);
  for (const auto& [input, source] : links) out.links.push_back({input, source, {}});
  return out;
}

/// A program and one robot's frame, stepped together.
struct Runner {
  text::Diagnostics sink;  // first, because building the program fills it
  std::shared_ptr<const Program> program;
  Frame frame;
  percept::Percepts percepts;
  percept::Action action;

  explicit Runner(const Network& network) : program(build_program(network, library(), sink)) {
    if (program) frame = program->make_frame();
  }
  void step(AsyncRunner* async = nullptr) {
    action = {};
    program->step(frame.data(), percepts, action, 1, 1, async);
    percepts.time += percepts.cycle_duration;
  }
  double number(std::string_view path) const {
    const Port* port = program->find(path);
    return port == nullptr ? -1e99 : Program::number(frame.data(), *port).value_or(-2e99);
  }
};

}  // namespace mlab::flow::test
