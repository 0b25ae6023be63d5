#pragma once

#include <deque>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mlab/binding/binding.h"
#include "mlab/recording/percepts_file.h"
#include "mlab/robot/wire/percepts_wire.h"

namespace mlab::recording {

/// A robot that acts otherwise than it did when its percepts were recorded.
struct Difference {
  base::RobotId robot;
  std::uint64_t cycle = 0;  ///< of the recording, from 1
  double time = 0.0;        ///< [s]
  std::string what;         ///< a sentence without its subject
};

/// Bodies out of a file of percepts: robots sense what was recorded, and go where they went then, whatever
/// they do now. What they do is compared with what they did. A robot that the file does not know gets no
/// body; one that has no percepts any more is not well.
class RecordedBinding final : public binding::Binding, private binding::WorldView {
 public:
  /// @param threads  that programs may run on
  RecordedBinding(std::unique_ptr<PerceptsReader> file, int threads);

  /// The first of each robot, in the order of time; valid as long as the binding, which grows it.
  const std::vector<Difference>& differences() const { return differences_; }
  /// How many actions were the same.
  std::uint64_t same_actions() const { return same_actions_; }

  std::expected<binding::Placement, std::string> embody(const binding::BodySetup& setup) override;
  void release(binding::BodyIndex body) override;
  void set_unit(binding::BodyIndex /*body*/, std::uint32_t /*unit*/) override {}
  binding::Capabilities capabilities(binding::BodyIndex body) const override;
  void health(std::vector<binding::Ailment>& out) override;
  void percepts(std::span<const binding::Sensing> robots, int worker) override;
  void carry_out(std::span<const percept::Action> actions, double dt) override;
  void poses(std::span<const binding::BodyIndex> bodies, std::span<geom::Pose> out) const override;
  const binding::RadioLinks* radio() override;
  double time() const override { return time_; }
  binding::Workers& workers() const override { return *workers_; }
  const binding::WorldView& view() const override { return *this; }
  std::vector<std::optional<geom::Pose>> places_for(std::span<const binding::BodySetup> setups) override;
  binding::MapChange change_map(const overlay::Overlay& before, const overlay::Overlay& after) override;
  std::vector<base::RobotId> change_obstacles(std::span<const binding::Disc> gone,
                                              std::span<const binding::Disc> come) override;

 private:
  struct Body {
    binding::BodyIndex number;
    wire::RecordedBody made;
    bool is_present = true;
    bool has_acted = false;                         // in this cycle
    const wire::RecordedRobot* recorded = nullptr;  // of this cycle; null: it did not act then
    robot_wire::DecodedPercepts percepts;
    std::string lack;  // of its percepts in this cycle
    geom::Pose pose;
    binding::BodyState state;
  };
  /// Who heard whom. What was not told then arrives.
  class Links final : public binding::RadioLinks {
   public:
    std::uint32_t net_of(binding::BodyIndex body) const override { return nets[body.value]; }
    bool arrives(binding::BodyIndex from, binding::BodyIndex to) const override;
    bool loses(binding::BodyIndex /*from*/) const override { return !lost.empty(); }

    std::vector<std::uint32_t> nets;                         ///< by number of the body
    std::set<std::pair<std::uint32_t, std::uint32_t>> lost;  ///< from, to
  };
  struct Robot {
    std::size_t starts = 0;  // bodies that it got
    Body* body = nullptr;    // in bodies_; null: it has none now
    bool is_told = false;    // its first difference
  };
  std::span<const binding::Disc> discs() const override { return discs_; }
  std::span<const binding::Wall> walls() const override { return walls_; }
  std::span<const binding::Object> objects() const override { return objects_; }
  binding::BodyState body(binding::BodyIndex body) const override { return bodies_[body.value].state; }
  percept::Percepts sense(binding::BodyIndex body, const percept::Needs& needs) const override;
  percept::Percepts sense_at(binding::BodyIndex body, const geom::Pose& pose,
                             const percept::Needs& needs) const override;

  const wire::RecordedBody* next_body(base::RobotId robot, std::size_t which) const;
  Body* find(std::uint32_t robot);
  void load();
  binding::MapChange take_change();
  void take_world(const wire::RecordedWorld& world);
  std::string difference_of(Body& body, const percept::Action& action, double dt) const;
  void compare(std::span<const percept::Action> actions, double dt);
  void take_states(const wire::RecordedCycle& cycle);

  std::unique_ptr<PerceptsReader> file_;
  std::unique_ptr<binding::Workers> workers_;
  std::deque<Body> bodies_;                          // by number
  std::unordered_map<std::uint32_t, Robot> robots_;  // by id
  std::vector<binding::Disc> discs_;
  std::vector<binding::Wall> walls_;
  std::vector<binding::Object> objects_;
  Links links_;
  const wire::RecordedCycle* cycle_ = nullptr;  // the coming one, where it is read already
  std::uint64_t cycles_done_ = 0;
  double time_ = 0.0;
  std::vector<Difference> differences_;
  std::uint64_t same_actions_ = 0;
};

}  // namespace mlab::recording
