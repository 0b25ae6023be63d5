#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "mlab/sim/bodies.h"
#include "mlab/sim/contact.h"
#include "mlab/sim/objects.h"
#include "mlab/sim/placement.h"
#include "mlab/sim/point_grid.h"
#include "mlab/sim/radio.h"
#include "mlab/sim/roaming.h"
#include "mlab/sim/sensors.h"
#include "mlab/sim/simulator.h"
#include "mlab/sim/site.h"
#include "mlab/sim/statics.h"

/// For sources of this module only.
namespace mlab::sim {

/// What a snapshot holds.
class Simulator::State {
 public:
  Bodies bodies;
  Objects objects;
  Site site;
  std::shared_ptr<const Statics> statics;
  std::shared_ptr<const std::vector<Roamer>> roamers;
  std::shared_ptr<const std::vector<Outline>> silences;
  Box area;                 ///< where the centres of held bodies may be
  std::vector<Kind> kinds;  ///< of bodies
  double time = 0.0;
  std::uint64_t cycle = 0;
};

struct Simulator::Parts {
  Parts(World world, const SimulatorSettings& chosen)
      : settings(chosen),
        workers(chosen.threads),
        state{{},
              Objects(std::move(world.objects), world.travels),
              Site(std::move(world.building)),
              std::make_shared<const Statics>(std::move(world.discs), std::move(world.walls)),
              std::make_shared<const std::vector<Roamer>>(std::move(world.roamers)),
              std::make_shared<const std::vector<Outline>>(std::move(world.silences)),
              {world.area_low.x + kAreaMargin, world.area_low.y + kAreaMargin,
               world.area_high.x - kAreaMargin, world.area_high.y - kAreaMargin},
              {}} {
    place_roamers();
  }

  /// Where roamers are now.
  void place_roamers() {
    roaming.place(*state.roamers, state.time);
    placer.keep_free_of(roaming.discs());
  }
  /// Sorts bodies and objects anew where they moved since. Whichever thread comes first does it.
  void refresh();
  /// Notes how far somebody asks for robots [m].
  void note_reach(float asked_now) {
    float before = asked.load(std::memory_order_relaxed);
    while (before < asked_now && !asked.compare_exchange_weak(before, asked_now, std::memory_order_relaxed)) {
    }
  }
  Sensors::Scene scene() {
    return {state.bodies,    grid,          *state.statics, state.objects,
            state.kinds,     settings.seed, state.cycle,    roaming.discs(),
            *state.silences, clear,         apart};
  }
  std::uint32_t kind_of(const BodySpec& spec);
  void sense(const Sensors::Scene& scene, const binding::Sensing& wanted, SenseBuffer& buffer);
  void want(const percept::Action& action, std::uint32_t body, double dt);
  bool counts_wheels(std::uint32_t body) const {
    return state.kinds[state.bodies.kind[body]].spec.odometry_noise > 0.0;
  }
  void carry_out(const percept::Action& action, std::uint32_t body);
  void localize(const percept::Request& request, std::uint32_t body);
  void count_wheels();
  std::vector<Placement> replace_statics(std::vector<Disc> discs, std::vector<Wall> walls);

  SimulatorSettings settings;
  Workers workers;
  State state;
  std::vector<std::uint32_t> by_robot;  ///< body indices in the order of robot ids
  bool has_odometry = false;            ///< some kind counts its wheels
  std::vector<geom::Pose> departure;    ///< of all bodies, before they move; where has_odometry
  Roaming roaming;
  Radio radio;
  PointGrid grid;
  std::vector<PointGrid::Item> items;
  std::atomic<float> asked{0.0F};  ///< the farthest that robots were looked for since the grid was built [m]
  float reach = 0.0F;              ///< the same over some cycles, for the size of its cells
  std::atomic<bool> is_stale{true};
  std::mutex refreshing;
  std::vector<ClearPlace> clear;  ///< by body: where its eyes see nothing that stands
  std::vector<Apart> apart;       ///< by body: how far others are, as its eyes saw
  Placer placer;
  bool is_placer_stale = true;
  ContactSolver contact;
  StepTimes times;
};

}  // namespace mlab::sim
