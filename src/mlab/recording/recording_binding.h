#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "mlab/binding/binding.h"
#include "mlab/recording/percepts_file.h"

namespace mlab::recording {

/// Bodies of another binding; whatever they sense and do is written to a file.
class RecordingBinding final : public binding::Binding {
 public:
  /// @param file  its owner says that it is finished
  RecordingBinding(std::unique_ptr<binding::Binding> inner, std::shared_ptr<PerceptsWriter> file);

  std::expected<binding::Placement, std::string> embody(const binding::BodySetup& setup) override;
  void release(binding::BodyIndex body) override;
  void set_unit(binding::BodyIndex body, std::uint32_t unit) override { inner_->set_unit(body, unit); }
  binding::Capabilities capabilities(binding::BodyIndex body) const override {
    return inner_->capabilities(body);
  }
  void health(std::vector<binding::Ailment>& out) override { inner_->health(out); }
  void hear(std::vector<binding::Heard>& out) override { inner_->hear(out); }
  void take(const binding::Heard& heard) override { inner_->take(heard); }
  std::vector<std::string> vehicles() const override { return inner_->vehicles(); }
  std::optional<binding::VehicleState> vehicle(std::string_view name) const override {
    return inner_->vehicle(name);
  }
  void percepts(std::span<const binding::Sensing> robots, int worker) override;
  void carry_out(std::span<const percept::Action> actions, double dt) override;
  void poses(std::span<const binding::BodyIndex> bodies, std::span<geom::Pose> out) const override {
    inner_->poses(bodies, out);
  }
  const binding::RadioLinks* radio() override;
  double time() const override { return inner_->time(); }
  binding::Workers& workers() const override { return inner_->workers(); }
  const binding::WorldView& view() const override { return inner_->view(); }
  std::vector<std::optional<geom::Pose>> places_for(std::span<const binding::BodySetup> setups) override {
    return inner_->places_for(setups);
  }
  binding::MapChange change_map(const overlay::Overlay& before, const overlay::Overlay& after) override;
  std::vector<base::RobotId> change_obstacles(std::span<const binding::Disc> gone,
                                              std::span<const binding::Disc> come) override;

 private:
  struct Body {
    base::RobotId robot;
    bool is_present = true;
    bool has_acted = false;  // in this cycle
    wire::RecordedRobot told;
  };
  /// The links of another binding, with what is lost on them noted.
  class Links final : public binding::RadioLinks {
   public:
    std::uint32_t net_of(binding::BodyIndex body) const override { return inner->net_of(body); }
    bool arrives(binding::BodyIndex from, binding::BodyIndex to) const override;
    bool loses(binding::BodyIndex from) const override { return inner->loses(from); }

    const binding::RadioLinks* inner = nullptr;  ///< of this cycle; null: all that is told arrives
    mutable std::vector<std::pair<binding::BodyIndex, binding::BodyIndex>> lost;
  };
  void write_world(const binding::MapChange& change);
  void add_states(wire::RecordedCycle& cycle) const;
  void add_objects(wire::RecordedCycle& cycle);
  void add_radio(wire::RecordedCycle& cycle);

  std::unique_ptr<binding::Binding> inner_;
  std::shared_ptr<PerceptsWriter> file_;
  std::deque<Body> bodies_;               // by number
  std::vector<binding::Object> objects_;  // as the file has them
  Links links_;
};

}  // namespace mlab::recording
