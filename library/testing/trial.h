#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "mlab/robot/program/configuration_file.h"
#include "mlab/sim/simulator.h"

namespace mlab::library_test {

/// A robot of a class, with one assemblage, in a small world, stepped against the simulator. Notifications
/// come back to the robot that sent them.
class Trial {
 public:
  /// @param movement  an expression of CDL; a mistake in it fails the test
  Trial(const std::string& movement, sim::World world, geom::Pose start,
        const std::string& robot_class = "Scout", const sim::RadioSpec& radio = {})
      : simulator_(std::move(world)) {
    const std::string text = "robot Tried is " + robot_class + " { movement = " + movement + "; }\n";
    const auto source = std::make_shared<const text::Source>("tried.cdl", text);
    text::Diagnostics sink;
    auto robot = robot::configure(source, "", "", {}, {}, sink);
    EXPECT_TRUE(robot && !sink.has_errors()) << text::render(sink);
    if (!robot) return;
    program_ = robot->built.program;
    frame_ = program_->make_frame();
    sim::BodySetup setup;
    setup.pose = start;
    setup.robot = {1};
    setup.spec.radius = 0.2;
    setup.spec.radio = radio;
    body_ = simulator_.add_body(setup)->body;
    actions_.resize(1);
  }

  /// Another robot, that drives straight on.
  sim::BodyIndex add(geom::Point place, double heading, double speed,
                     percept::ObjectClass seen_as = percept::ObjectClass::kFriendlyRobot) {
    sim::BodySetup setup;
    setup.pose = {place, heading};
    setup.robot = {static_cast<std::uint32_t>(actions_.size() + 1)};
    setup.spec.radius = 0.2;
    setup.seen_as = seen_as;
    const sim::BodyIndex index = simulator_.add_body(setup)->body;
    percept::Action ahead;
    ahead.velocity = {speed, 0.0, 0.0};
    ahead.drives = true;
    actions_.push_back(ahead);
    return index;
  }

  /// Runs until `is_done`, for at most so long [s]. @return whether it was done
  bool run(double seconds, const std::function<bool()>& is_done) {
    if (!program_) return false;
    for (double t = 0.0; t < seconds; t += 0.1) {
      step();
      if (is_done()) return true;
    }
    return false;
  }
  void run(double seconds) {
    run(seconds, [] { return false; });
  }

  geom::Point place() const { return simulator_.pose(body_).position; }
  geom::Point place(sim::BodyIndex other) const { return simulator_.pose(other).position; }
  double distance_to(geom::Point point) const { return geom::distance(place(), point); }
  bool has_heard(std::string_view name) const {
    return std::ranges::binary_search(heard_, base::hash_text(name));
  }
  /// The states that the robot's sequences are in, by their paths.
  std::vector<std::string> states() const { return program_->active_states(frame_.data()); }
  std::string alert() const { return alert_; }
  sim::Simulator& simulator() { return simulator_; }
  sim::BodyIndex body() const { return body_; }
  percept::Percepts& percepts() { return percepts_; }
  const percept::Action& action() const { return actions_[0]; }

 private:
  void step() {
    const percept::Needs needs = program_->needs(frame_.data());
    simulator_.sense(body_, needs, buffer_, percepts_);
    percepts_.notifications = inbox_;
    percepts_.unit.center = percepts_.pose.position;
    percept::Action action;
    program_->step(frame_.data(), percepts_, action, 1, 1);
    if (action.alert[0] != 0) alert_ = action.alert.data();
    for (std::uint8_t i = 0; i < action.request_count; ++i) deliver(action.requests[i]);
    actions_[0] = action;
    simulator_.step(actions_, 0.1);
  }
  void deliver(const percept::Request& request) {
    using Kind = percept::Request::Kind;
    if (request.kind == Kind::kTakeNotification) std::erase(inbox_, request.notification);
    if (request.kind != Kind::kNotify) return;
    for (auto* list : {&inbox_, &heard_}) {
      const auto at = std::ranges::lower_bound(*list, request.notification);
      if (at == list->end() || *at != request.notification) list->insert(at, request.notification);
    }
  }

  sim::Simulator simulator_;
  sim::BodyIndex body_;
  std::shared_ptr<const flow::Program> program_;
  flow::Frame frame_;
  sim::SenseBuffer buffer_;
  percept::Percepts percepts_;
  std::vector<percept::Action> actions_;
  std::vector<std::uint64_t> inbox_;
  std::vector<std::uint64_t> heard_;
  std::string alert_;
};

}  // namespace mlab::library_test
