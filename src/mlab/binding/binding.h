#pragma once

#include <cstddef>
#include <cstdint>
#include <expected>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/base/id.h"
#include "mlab/binding/body.h"
#include "mlab/binding/radio.h"
#include "mlab/binding/vehicle_state.h"
#include "mlab/binding/workers.h"
#include "mlab/binding/world_view.h"
#include "mlab/geom/pose.h"
#include "mlab/overlay/overlay.h"
#include "mlab/percept/action.h"
#include "mlab/percept/needs.h"
#include "mlab/percept/percepts.h"

namespace mlab::binding {

/// One robot's senses in a cycle.
struct Sensing {
  BodyIndex body;
  const percept::Needs* needs = nullptr;  ///< the rest may stay empty
  percept::Percepts* out = nullptr;  ///< as it was made; what sensing gives is filled in, all else left alone
};

/// A body that can't be counted on.
struct Ailment {
  BodyIndex body;
  std::string what;  ///< a sentence without its subject: `has no percepts any more`
};

/// Something that came from a body that is not simulated.
struct Heard {
  std::string vehicle;  ///< its name
  std::string said;     ///< bytes that anybody may have sent
};

/// What became of bodies when the map was changed under them.
struct MapChange {
  std::vector<base::RobotId> moved_by_obstacles;  ///< that stood where there is one now
  std::vector<base::RobotId> moved_by_walls;
  bool has_other_objects = false;  ///< their ids may mean others than before
};

/// Bodies of robots: senses come from there, actions go there. The simulator's is one, a recording's another.
/// Who runs robots over it knows nothing of what is behind.
///
/// Per cycle: `health`; `percepts` for all robots that act, in batches, on any of the workers' threads;
/// `carry_out`. All else is called by one thread. Once lists have grown, the simulator's takes no heap.
class Binding {
 public:
  /// So many robots in one batch, at most.
  static constexpr std::size_t kMostAtOnce = 32;

  Binding() = default;
  Binding(const Binding&) = delete;
  Binding& operator=(const Binding&) = delete;
  virtual ~Binding() = default;

  // ---- bodies

  /// Gives a robot its body.
  /// @return  where it stands
  /// @errors  why it gets none, as a sentence: `there is no free place near`
  virtual std::expected<Placement, std::string> embody(const BodySetup& setup) = 0;
  /// The robot has that body no more; its number stays taken.
  virtual void release(BodyIndex body) = 0;
  /// Bodies of the same unit see each other as mates; 0: of no unit.
  virtual void set_unit(BodyIndex body, std::uint32_t unit) = 0;
  /// What the body really has and can do, whatever the mission says.
  virtual Capabilities capabilities(BodyIndex body) const = 0;
  /// Adds the bodies that can't take part in the coming cycle; none: all is well.
  virtual void health(std::vector<Ailment>& out) = 0;

  // ---- what comes from bodies that are not simulated

  /// Adds what has come since the last call. Nothing changes here before it is taken: so that it can be kept,
  /// and taken again at the same moment of a run that is computed anew.
  virtual void hear(std::vector<Heard>& /*out*/) {}
  virtual void take(const Heard& /*heard*/) {}
  /// What has to be known, beside what is heard, to make such bodies again, as bytes; empty: there are none.
  virtual std::vector<std::string> vehicles() const { return {}; }
  /// What is known of the vehicle of that name, whether it is a robot's body by now or not.
  virtual std::optional<VehicleState> vehicle(std::string_view /*name*/) const { return std::nullopt; }

  // ---- the cycle

  /// Senses for a batch of bodies. Threads may do so at the same time, each as a worker of its own; sensing
  /// twice gives the same. Lists in percepts are valid until the worker's next batch.
  /// @param worker  below workers().count()
  virtual void percepts(std::span<const Sensing> robots, int worker) = 0;
  /// Bodies do what they can of this, and time goes by.
  /// @param actions  by number of the body; who is released or beyond stands still
  /// @param dt       cycle duration [s], > 0
  virtual void carry_out(std::span<const percept::Action> actions, double dt) = 0;
  /// Where bodies are, as well as it is known. Leaves out whose body is kNoBody.
  virtual void poses(std::span<const BodyIndex> bodies, std::span<geom::Pose> out) const = 0;
  /// Who hears whom as bodies stand now, until they move. Null: all that is told arrives.
  virtual const RadioLinks* radio() = 0;
  /// Since the start of the run [s].
  virtual double time() const = 0;
  /// The threads that a cycle may be shared out to; the caller may run loops of its own on them between two
  /// calls.
  virtual Workers& workers() const = 0;

  virtual const WorldView& view() const = 0;

  // ---- checkpoints

  /// Bodies and world between two cycles. Never changed, so it may be shared.
  class Kept {
   public:
    Kept() = default;
    Kept(const Kept&) = delete;
    Kept& operator=(const Kept&) = delete;
    virtual ~Kept() = default;
    /// That it takes up, about; without what it shares with others.
    virtual std::size_t bytes() const = 0;
  };
  /// @errors  why there is no way back to here, as a sentence
  virtual std::expected<std::shared_ptr<const Kept>, std::string> save() const {
    return std::unexpected("bodies that are not simulated can't be put back to where they were");
  }
  /// Goes on from there.
  /// @param kept  of this binding, or of another one of this kind and seed
  /// @return  false: it is of another kind, and nothing has changed
  virtual bool restore(const Kept& /*kept*/) { return false; }

  /// Puts a body where somebody else has found it: one that stands for something real, and from now on moves
  /// only by this. It may overlap others then, which keep off it.
  /// @param velocity  over the ground [m/s, world]
  /// @return  false: bodies here are where they are
  virtual bool place(BodyIndex /*body*/, const geom::Pose& /*pose*/, geom::Offset /*velocity*/,
                     double /*turn_rate*/) {
    return false;
  }

  // ---- what is made up can be changed; a world that is there as it is stays so

  /// Where bodies would come to stand if they were given one after the other, and what nothing is free for.
  /// Nothing is changed.
  virtual std::vector<std::optional<geom::Pose>> places_for(std::span<const BodySetup> setups) = 0;
  /// The mission has another map than before.
  virtual MapChange change_map(const overlay::Overlay& /*before*/, const overlay::Overlay& /*after*/) {
    return {};
  }
  /// Obstacles vanish and appear. @return  robots that stood where there is one now, and were moved
  virtual std::vector<base::RobotId> change_obstacles(std::span<const Disc> /*gone*/,
                                                      std::span<const Disc> /*come*/) {
    return {};
  }
};

}  // namespace mlab::binding
