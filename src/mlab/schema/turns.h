#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "mlab/base/id.h"
#include "mlab/base/up_to.h"
#include "mlab/flow/lists.h"
#include "mlab/geom/pose.h"
#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"
#include "mlab/schema/reciprocal.h"
#include "mlab/schema/step_aside.h"

namespace mlab::schema {

/// Who goes first where only one can: whoever has the lesser one. The lower number does; who is cornered by
/// another one goes just before that; who wants nothing comes last.
class Priority {
 public:
  Priority() = default;
  explicit Priority(base::RobotId robot) : value_(2 * robot.value + 1) {}
  /// Of who can't make way for one that has this.
  Priority of_cornered() const { return of_code(value_ & ~1U); }
  /// As a number below 2^24, which is less for who goes first.
  static Priority of_code(std::uint32_t code) {
    Priority out;
    out.value_ = code;
    return out;
  }
  std::uint32_t code() const { return value_; }

  bool is_cornered() const { return (value_ & 1U) == 0; }
  /// Whose it is; of who is cornered, whose way it can't make.
  base::RobotId robot() const { return {value_ / 2}; }
  friend auto operator<=>(const Priority&, const Priority&) = default;

 private:
  std::uint32_t value_ = (1U << 24) - 1;
};

/// What a robot that can't go on tells those around it: where it wants to go, straight on, and how urgent
/// that is. It may do so for another one, which it makes way for itself; where it has, it tells its own
/// place.
struct PassageWish {
  geom::Point to;  ///< [m, world]
  Priority priority;
};
/// Robots of other units hear it, too.
percept::Request tell_wish(const PassageWish& wish);
/// Nothing: such a priority there is not.
std::optional<PassageWish> wish_in(const percept::AskedPassage& asked);
/// What that robot told within the last seconds.
std::optional<PassageWish> wish_of(const percept::Percepts& percepts, base::RobotId robot);
/// Whether who tells it waits there for another one, and wants nothing for itself.
/// @param here  where it is [m, world]
bool is_waiting(const PassageWish& wish, geom::Point here);
/// Whether one of these robots, the nearest first, is near to this one and tells such a wish.
bool hears_wish(const percept::Percepts& percepts, const flow::ListView<percept::RobotReading>& robots);
/// What a body does that takes turns with others.
struct Turn {
  geom::Offset wanted;    ///< [m/s, world]
  bool is_taken = false;  ///< it makes way, or others do for it: it goes closer past them
};

/// Ends what robots wait for that wait for each other, in doors, corridors and crowds. Who can't go on for
/// those in front of him tells where he wants to go. Who stands there and wants nothing more, or something
/// else and comes after him, goes to the nearest place where he is in nobody's way, and asks those whom he
/// meets there to make way in turn, as if he were the first one; he waits there until that one has passed.
/// Who finds no such place is cornered: then the one that asked makes way for him.
///
/// Trivially copyable, so it can be the state of a procedure.
/// @source  Okumura, Machida, Defago, Tamura 2019, "Priority inheritance with backtracking for iterative
/// multi-agent path finding"
class TurnTaker {
 public:
  using RobotList = flow::ListView<percept::RobotReading>;

  /// Once in each cycle.
  /// @param wanted    [m/s, world]
  /// @param left      of the way that its order sends it [m]; who has come to 0 wants nothing more
  /// @param radius    of its body [m]
  /// @param gap       that bodies keep where there is room [m]
  /// @param speed     at which it steps aside [m/s]
  Turn take(const percept::Percepts& percepts, const RobotList& robots, geom::Offset wanted, double left,
            double radius, double gap, double speed, percept::Action& action);

 private:
  struct Heard {
    Lane lane;
    Priority priority;
    geom::Point from;
  };
  struct Situation;
  using Wishes = base::UpTo<Heard, 8>;

  Wishes hear(const Situation& now) const;
  static bool crosses(const Situation& now, const Heard& heard);
  static bool is_in_way(const Situation& now, const Heard& heard);
  bool needs_place(const Situation& now, const Wishes& wishes) const;
  void look_for_place(const Situation& now, const Wishes& wishes);
  bool gives_way(const Situation& now, const Wishes& wishes);
  Turn step_aside(const Situation& now, percept::Action& action);
  bool asks(const Situation& now);
  void tell(const Situation& now, geom::Offset along, double farthest, Priority priority,
            percept::Action& action);

  static constexpr std::size_t kMostCorners = 4;

  std::uint32_t sequence_ = 0;    // of its order
  bool has_arrived_ = false;      // since that began
  geom::Point at_;                // where it has been
  double since_ = 1e300;          // then [s]
  double asks_until_ = -1.0;      // [s]
  double told_ = -1e9;            // when it told its wish last [s]
  double gives_until_ = -1.0;     // way to others [s]
  double looked_ = -1e9;          // for a place to step aside to [s]
  double cornered_until_ = -1.0;  // [s]
  Priority cornered_;             // until then
  Priority for_;                  // whom it makes way for
  std::uint32_t next_ = 0;        // corner of its way aside
  std::uint32_t count_ = 0;
  std::array<geom::Point, kMostCorners> corners_{};
};

/// What a body that goes among others keeps from cycle to cycle. What each cycle reads stands first: where
/// robots are many, each line of a cache comes from afar.
struct Company {
  geom::Point before;  ///< where it was in the cycle before [m, world]
  TurnTaker turns;
  SeenRobots seen;
};

}  // namespace mlab::schema
