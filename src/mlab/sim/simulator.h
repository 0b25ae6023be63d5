#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "mlab/binding/binding.h"
#include "mlab/binding/radio.h"
#include "mlab/binding/workers.h"
#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"
#include "mlab/sim/body.h"
#include "mlab/sim/sensing.h"
#include "mlab/sim/world.h"

namespace mlab::sim {

using binding::Workers;

/// A robot that fails: from then on its body stands.
struct Breakdown {
  base::RobotId robot;
  double after = 0.0;  ///< since it came into the world [s]
};

struct SimulatorSettings {
  std::uint64_t seed = 1;  ///< of the sensors' noise
  int threads = 1;         ///< results are the same for any number
  std::vector<Breakdown> breakdowns = {};
  bool measures_times = false;  ///< step_times() tells something; where robots are few it takes its time
};

/// Seconds of wall clock that step() has spent since the simulator was made.
struct StepTimes {
  double move = 0.0;     ///< kinematics, requests, sorting bodies into the grid
  double contact = 0.0;  ///< sweeping and sliding
};

/// The simulated world and the bodies of the robots in it. It knows no behavior: in each cycle the caller
/// asks sense() for every robot, lets the programs answer, and hands their actions to step().
///
/// Never, at any speed, do two bodies overlap or does a body overlap a disc or a wall, or get past one.
/// Roamers stop for nobody: a body may be run over, though it never drives into one. The same calls with the
/// same seed give the same result, bit for bit, for any number of threads.
class Simulator {
 public:
  explicit Simulator(World world, const SimulatorSettings& settings = {});
  ~Simulator();
  Simulator(const Simulator&) = delete;
  Simulator& operator=(const Simulator&) = delete;

  // ---- bodies

  /// Puts a body into the world, at the wanted place or at the nearest free one.
  /// @return  where it stands; nothing where no place is free within 10 km
  std::optional<Placement> add_body(const BodySetup& setup);
  /// Takes a body out of the world: nothing touches or sees it any more. What it carried is dropped.
  void remove_body(BodyIndex body);
  /// Bodies ever added; the span handed to step() is that long.
  std::size_t body_count() const;
  bool is_present(BodyIndex body) const;
  geom::Pose pose(BodyIndex body) const;
  base::RobotId robot(BodyIndex body) const;
  const BodySpec& spec(BodyIndex body) const;
  /// As driven in the last cycle: contact and limits included [m/s, world].
  geom::Offset velocity(BodyIndex body) const;
  /// At the end of the last cycle.
  const binding::Momentum& momentum(BodyIndex body) const;
  /// Where the camera looks, counter-clockwise from ahead [rad].
  double pan(BodyIndex body) const;
  /// Since it was added [m].
  double distance_driven(BodyIndex body) const;
  /// How often the body met something solid or another body. Meeting the same thing again within kSameContact
  /// after the last push against it is still the same contact; the edge of the mission area is none.
  std::uint32_t contacts(BodyIndex body) const;
  /// How often a roamer met the body, which did not drive into it: the body stood, was overtaken or was hit
  /// from the side. Counted as contacts are, and none of them.
  std::uint32_t run_over(BodyIndex body) const;
  /// The body met something, or was run over, within the last kSameContact.
  bool in_contact(BodyIndex body) const;
  /// What the body carries; 0: nothing.
  base::ObjectId carried(BodyIndex body) const;
  /// Changes the unit, as for BodySetup::unit.
  void set_unit(BodyIndex body, std::uint32_t unit);

  /// Puts a body somewhere, whatever is there: as Binding::place. From now on it moves only by this.
  void put_body(BodyIndex body, const geom::Pose& pose, geom::Offset velocity, double turn_rate);

  // ---- the cycle

  /// Fills the fields of `out` that sensing gives: pose, time, obstacles, robots, objects, camera,
  /// ranges, radio, map, range_limit, carried, carried_class. All others are left alone. Lists live in
  /// `buffer`. Threads may sense at the same time, each with buffers of its own. Sensing twice gives the
  /// same, noise included.
  void sense(BodyIndex body, const percept::Needs& needs, SenseBuffer& buffer, percept::Percepts& out) const;
  /// The same for some bodies, each with a buffer of its own.
  void sense(std::span<const binding::Sensing> bodies, std::span<SenseBuffer> buffers) const;

  /// What `sense` would give if the body stood elsewhere and knew its place exactly. Nothing has changed
  /// afterwards; meanwhile no other thread may use the simulator.
  void sense_at(BodyIndex body, const geom::Pose& pose, const percept::Needs& needs, SenseBuffer& buffer,
                percept::Percepts& out) const;

  /// Who hears whom as bodies stand now, until the next call. Null: all that is told arrives.
  const binding::RadioLinks* radio();

  /// One cycle: all bodies move by their actions, as their kinematics and whatever is in the way allow; then
  /// requests (pick up, drop, drop in basket, marks, localize) are carried out in the order of robot ids.
  /// @param actions  by BodyIndex, body_count() of them. Values that are not finite count as 0
  /// @param dt       cycle duration [s], > 0
  void step(std::span<const percept::Action> actions, double dt);

  double time() const;          ///< simulated [s]
  std::uint64_t cycle() const;  ///< steps done
  StepTimes step_times() const;
  Workers& workers()
      const;  ///< the simulator's threads; the caller may run its own loops on them between steps

  // ---- the world

  std::span<const Disc> discs() const;
  std::span<const MovingDisc> moving_discs() const;  ///< the roamers, where they are now
  std::span<const Wall> walls() const;
  std::span<const Object> objects() const;  ///< in the order of the world
  /// How many objects lie in a container.
  std::uint32_t basket_count(base::ObjectId container) const;
  /// Other discs than before, while running.
  /// @return the bodies that stood where there is one now, and where they were moved
  std::vector<Placement> set_obstacles(std::span<const Disc> discs);
  /// Other roamers than before. Who stands where one is now stays there, and is run over.
  void set_roamers(std::vector<Roamer> roamers);
  /// More discs; returns as set_obstacles does.
  std::vector<Placement> add_obstacles(std::span<const Disc> discs);
  /// Removes all discs for which `is_gone` is true. @return how many
  std::size_t remove_obstacles(const std::function<bool(const Disc&)>& is_gone);
  /// Other walls than before; returns as set_obstacles does.
  std::vector<Placement> set_walls(std::span<const Wall> walls);
  /// Other objects than before.
  ///
  /// @param objects  with unique ids; whether they are carried or lie in a basket doesn't count
  /// @param were     for each the id that it had up to now; 0 for a new one. Whatever happened to an object
  /// that stays
  ///                 (it is carried, lies in a basket that stays, was put down elsewhere) remains as it is.
  ///                 May be shorter than `objects`: the rest is new
  /// @param travels  of some of them; one that somebody took up before stays where that one put it
  void set_objects(std::span<const Object> objects, std::span<const base::ObjectId> were,
                   std::span<const Travel> travels = {});
  /// Other zones without radio than before.
  void set_silences(std::vector<Outline> silences);
  /// Another building than before; doors that stay keep their marks.
  void set_building(Building building);
  /// True where a disc of this radius would touch nothing solid and no body.
  bool is_free(geom::Point place, double radius) const;
  /// True where no wall crosses the line between the two points.
  bool in_sight(geom::Point a, geom::Point b) const;

  // ---- checkpoints

  class State;
  /// Everything that changes from cycle to cycle, copied. Cheap to hold: what doesn't change is shared.
  std::shared_ptr<const State> snapshot() const;
  /// That it takes up, about; without what doesn't change.
  static std::size_t bytes(const State& state);
  /// Back to a snapshot of this simulator, or on from one of another of the same seed; bodies and obstacles
  /// added or removed since are undone.
  void restore(const State& state);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace mlab::sim
