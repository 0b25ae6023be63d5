#pragma once

#include <array>
#include <vector>

#include "mlab/binding/binding.h"
#include "mlab/sim/simulator.h"

namespace mlab::sim {

/// The simulator's bodies, in the world of a mission's map.
class SimulatedBinding final : public binding::Binding, private binding::WorldView {
 public:
  explicit SimulatedBinding(World world, SimulatorSettings settings = {});

  std::expected<Placement, std::string> embody(const BodySetup& setup) override;
  void release(BodyIndex body) override { simulator_.remove_body(body); }
  void set_unit(BodyIndex body, std::uint32_t unit) override { simulator_.set_unit(body, unit); }
  binding::Capabilities capabilities(BodyIndex body) const override {
    return binding::capabilities_of(simulator_.spec(body));
  }
  /// Bodies that are made up are well, but for those that the settings let break down.
  void health(std::vector<binding::Ailment>& out) override;

  void percepts(std::span<const binding::Sensing> robots, int worker) override;
  void carry_out(std::span<const percept::Action> actions, double dt) override;
  void poses(std::span<const BodyIndex> bodies, std::span<geom::Pose> out) const override;
  const binding::RadioLinks* radio() override { return simulator_.radio(); }
  double time() const override { return simulator_.time(); }
  Workers& workers() const override { return simulator_.workers(); }
  const binding::WorldView& view() const override { return *this; }

  bool place(BodyIndex body, const geom::Pose& pose, geom::Offset velocity, double turn_rate) override {
    simulator_.put_body(body, pose, velocity, turn_rate);
    return true;
  }

  std::expected<std::shared_ptr<const Kept>, std::string> save() const override;
  bool restore(const Kept& kept) override;

  std::vector<std::optional<geom::Pose>> places_for(std::span<const BodySetup> setups) override;
  binding::MapChange change_map(const overlay::Overlay& before, const overlay::Overlay& after) override;
  std::vector<base::RobotId> change_obstacles(std::span<const Disc> gone,
                                              std::span<const Disc> come) override;

 private:
  std::span<const Disc> discs() const override { return simulator_.discs(); }
  std::span<const MovingDisc> moving_discs() const override { return simulator_.moving_discs(); }
  std::span<const Wall> walls() const override { return simulator_.walls(); }
  std::span<const Object> objects() const override { return simulator_.objects(); }
  binding::BodyState body(BodyIndex body) const override;
  percept::Percepts sense(BodyIndex body, const percept::Needs& needs) const override;
  percept::Percepts sense_at(BodyIndex body, const geom::Pose& pose,
                             const percept::Needs& needs) const override;
  void note_breakdown(BodyIndex body, base::RobotId robot);
  std::vector<base::RobotId> robots_of(const std::vector<Placement>& moved) const;

  Simulator simulator_;
  std::vector<Breakdown> breakdowns_;
  std::vector<double> fails_at_;  // by body [s]; endless: never, or it has; empty where nobody fails
  std::vector<std::array<SenseBuffer, kMostAtOnce>> buffers_;  // by worker
  std::vector<percept::Action> actions_;                       // by body
  mutable SenseBuffer view_buffer_;
};

}  // namespace mlab::sim
