#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/binding/binding.h"
#include "mlab/geography/projection.h"
#include "mlab/overlay/overlay.h"
#include "mlab/vehicle/device.h"
#include "mlab/vehicle/line.h"
#include "mlab/vehicle/local_map.h"

namespace mlab::vehicle {

/// A vehicle that a robot of a mission may have as its body.
struct Crewed {
  std::string name;  ///< in the fleet
  Limits limits;
  std::unique_ptr<Line> line;  ///< null: what it said is recorded, and nobody hears what it is told
  std::string kind = {};       ///< what it is, for people; empty: its name
  /// What of its limits can't be, as `limits_of` says it: no robot gets it, and its limits are not read.
  /// Empty: they can be.
  std::string refusal = {};
};

/// Bodies some of which are vehicles; the others are another binding's, which has a body for each vehicle,
/// too: it is put where the vehicle says that it is, so that all others perceive it there.
///
/// A vehicle senses with what it has: its pose, obstacles and ranges are what it says, robots those that are
/// known to be there; it has no camera, no hands and no feelers. One that does not say where it is gets no
/// robot; one that is silent, faulty or not ready for too long is not well.
///
/// What is taken of vehicles is all that decides what becomes of them here: no clock does but the run's. So
/// the same comes out when it is taken again.
class Bodies final : public binding::Binding, private binding::WorldView {
 public:
  /// @param session  names this run to vehicles, not 0
  /// @param map      how the world lies on the Earth: vehicles that know where on the Earth they are, and not
  ///                 where in the world, are where that is on the map
  Bodies(std::unique_ptr<binding::Binding> others, std::vector<Crewed> vehicles, std::uint64_t session,
         const std::optional<geography::Projection>& map = {});
  ~Bodies() override;

  std::expected<binding::Placement, std::string> embody(const binding::BodySetup& setup) override;
  void release(binding::BodyIndex body) override;
  void set_unit(binding::BodyIndex body, std::uint32_t unit) override { others_->set_unit(body, unit); }
  binding::Capabilities capabilities(binding::BodyIndex body) const override;
  void health(std::vector<binding::Ailment>& out) override;
  void hear(std::vector<binding::Heard>& out) override;
  void take(const binding::Heard& heard) override;
  std::vector<std::string> vehicles() const override;
  std::optional<binding::VehicleState> vehicle(std::string_view name) const override;
  void percepts(std::span<const binding::Sensing> robots, int worker) override;
  void carry_out(std::span<const percept::Action> actions, double dt) override;
  void poses(std::span<const binding::BodyIndex> bodies, std::span<geom::Pose> out) const override {
    others_->poses(bodies, out);
  }
  const binding::RadioLinks* radio() override { return others_->radio(); }
  double time() const override { return others_->time(); }
  binding::Workers& workers() const override { return others_->workers(); }
  const binding::WorldView& view() const override { return *this; }
  /// @errors  also where a vehicle is there, which stays where it is
  std::expected<std::shared_ptr<const Kept>, std::string> save() const override;
  bool restore(const Kept& kept) override;
  std::vector<std::optional<geom::Pose>> places_for(std::span<const binding::BodySetup> setups) override;
  binding::MapChange change_map(const overlay::Overlay& before, const overlay::Overlay& after) override {
    map_ = after.projection;
    return others_->change_map(before, after);
  }
  std::vector<base::RobotId> change_obstacles(std::span<const binding::Disc> gone,
                                              std::span<const binding::Disc> come) override {
    return others_->change_obstacles(gone, come);
  }

 private:
  /// What is known of a vehicle; a copy is a checkpoint.
  struct State {
    std::uint64_t number = 0;  // of the last report; 0: nothing was heard
    std::uint64_t held_by = 0;
    bool is_stopped = false;
    Report report;
    std::optional<Battery> battery;               // as it said last
    std::optional<Clock::time_point> first;       // when it was heard first, by the run's time as all here
    Clock::time_point heard;                      // last
    std::array<Clock::time_point, 64> told_at{};  // by number of the command
    std::uint64_t answered = 0;                   // the newest of them that was carried out
    std::optional<double> trip;                   // as binding::VehicleState::trip
    std::optional<Motion> motion;
    binding::BodyIndex body = binding::kNoBody;
    geom::Pose frame;  // of its odometry, in the world
    /// When it said last where on the Earth that frame is; nothing: it never has.
    std::optional<Clock::time_point> fixed_at;
    LocalMap map;
    std::vector<percept::RangeReading> ranges;
    double range_limit = 0.0;
    std::uint64_t told = 0;                          // commands
    std::uint32_t engagement = 0;                    // how often a robot got it as its body
    std::optional<Clock::time_point> unready_since;  // though it was to drive
    bool is_to_drive = false;
  };
  struct Vehicle {
    Crewed crewed;
    State now;
  };
  class KeptBodies;
  std::span<const binding::Disc> discs() const override { return others_->view().discs(); }
  std::span<const binding::MovingDisc> moving_discs() const override {
    return others_->view().moving_discs();
  }
  std::span<const binding::Wall> walls() const override { return others_->view().walls(); }
  std::span<const binding::Object> objects() const override { return others_->view().objects(); }
  binding::BodyState body(binding::BodyIndex body) const override;
  percept::Percepts sense(binding::BodyIndex body, const percept::Needs& needs) const override;
  percept::Percepts sense_at(binding::BodyIndex body, const geom::Pose& pose,
                             const percept::Needs& needs) const override;

  Vehicle* of(binding::BodyIndex body) const;
  Vehicle* of(std::string_view name) const;
  Clock::time_point now() const;
  void take(Vehicle& vehicle, Report report);
  void fix(State& state) const;
  void put(const State& state);
  static bool knows_its_place(const State& state) { return state.report.is_global || state.fixed_at; }
  static void note_trip(State& state, std::uint64_t command);
  binding::VehicleState::Driver driver_of(const State& state) const;
  static geom::Pose pose_of(const State& state);
  /// What it knows, or would know if it stood elsewhere, by what it has seen from where it was.
  /// @param at  in the frame of its odometry
  static void sense_around(State& state, const geom::Pose& at, const percept::Needs& needs,
                           percept::Percepts& out);
  static void sense_with(State& state, const percept::Needs& needs, percept::Percepts& out);
  void command(Vehicle& vehicle, const percept::Action& action, double dt) const;
  std::string ailment_of(Vehicle& vehicle) const;

  std::unique_ptr<binding::Binding> others_;
  std::vector<std::unique_ptr<Vehicle>> vehicles_;
  std::vector<Vehicle*> by_body_;  // null: a body of the others
  std::uint64_t session_;
  std::optional<geography::Projection> map_;
  std::vector<percept::Action> actions_;  // by body
};

/// The vehicles of a recorded run, as `Bodies::vehicles` tells of them; what they said comes by `take`. Of
/// bytes that are none nothing is made.
std::unique_ptr<binding::Binding> recorded_bodies(std::unique_ptr<binding::Binding> others,
                                                  const std::vector<std::string>& vehicles,
                                                  const std::optional<geography::Projection>& map = {});
std::set<std::string, std::less<>> recorded_names(const std::vector<std::string>& vehicles);

}  // namespace mlab::vehicle
