#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "mlab/geom/pose.h"
#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"
#include "mlab/percept/shared_route.h"
#include "mlab/schema/swept.h"

namespace mlab::schema {

/// Parts beyond these are nobody's.
inline constexpr std::size_t kMostErrands = percept::kMostParts;

/// The parts of a robot's order that its unit shares, as it knows of them in this cycle: places to visit, or
/// pieces of a way to search. Its unit contracts for them under a name of the order's own; the number of a
/// part, from 1, is the contract's object.
class Errands {
 public:
  explicit Errands(const percept::Percepts& percepts);

  std::size_t count() const { return count_; }
  std::size_t done() const { return done_; }
  /// The name of the tasks, as base::hash_text gives one.
  std::uint64_t task() const { return task_; }
  /// That part: one place, or several that are gone along.
  std::span<const geom::Point> way(std::size_t errand) const;
  /// Where that part, of those that there are, begins [m, world].
  geom::Point place(std::size_t errand) const;
  /// Null: nobody has announced it.
  const percept::Contract* contract(std::size_t errand) const { return contracts_[errand]; }
  /// Which part the contract is about.
  std::optional<std::size_t> errand_of(const percept::Contract& contract) const;
  /// Whether that robot has one that is not done.
  bool has_one(base::RobotId robot) const;
  /// Whether those that are left were given back by all who could have them: for some seconds nobody has had
  /// one, or wanted one. Where there is none at all, nobody can.
  bool are_given_up(double time) const;
  /// The piece of a share that somebody else than its robot has; nothing: nobody has one. From 0.
  std::optional<std::size_t> piece_of_another(std::size_t share, base::RobotId robot) const;
  /// Whether another robot than this has, or had, one of the pieces of the share that this one belongs to.
  bool is_share_of_another(std::size_t errand, base::RobotId robot) const;

 private:
  const percept::Order& order_;
  std::uint64_t task_ = 0;
  std::array<const percept::Contract*, kMostErrands> contracts_{};
  std::size_t count_ = 0;
  std::size_t done_ = 0;
};

/// A set of parts. A value of a frame.
struct ErrandSet {
  std::array<std::uint64_t, kMostErrands / 64> bits{};

  bool has(std::size_t errand) const { return (bits[errand / 64] >> (errand % 64) & 1U) != 0; }
  void add(std::size_t errand) { bits[errand / 64] |= std::uint64_t{1} << (errand % 64); }
  /// The first one, which is not in it any more then; nothing: it is empty.
  std::optional<std::size_t> take_first();
};

/// Added to what is left of a way that leads no farther [m].
inline constexpr double kClosedEnd = 1e6;

/// How a robot comes on with what it is heading for. A value of a frame.
class LegWatch {
 public:
  enum class Verdict : std::uint8_t { kUnderWay, kThere, kInVain };

  /// From this cycle on it heads for something else.
  void head_for_next(double time);
  /// @param left       of the way to what it headed for in the cycle before [m]; from kClosedEnd on the way
  ///                   ends before it
  /// @param tolerance  so near it is there [m]
  /// @param patience   it is in vain after so long without coming nearer [s]
  Verdict look(double left, double tolerance, double patience, double time);
  /// Whether the way to what it headed for ended before it when that was last looked at.
  bool is_closed() const { return is_closed_; }

 private:
  double least_ = 0.0;  // that was left [m]
  double last_ = 0.0;   // left in the cycle before [m]
  double nearer_at_ = 0.0;
  bool is_closed_ = false;
};

/// Which part a robot is on. A value of a frame.
struct ErrandState {
  std::int32_t current = -1;  ///< -1: none
  std::uint32_t leg = 0;      ///< of that part's way
  double along = 0.0;         ///< the leg, so far it has tried to come back to it [m]
  bool comes_back = false;    ///< it heads for that place, not for the corner
  bool was_there = false;     ///< at some place of that part
  bool looks_back = false;    ///< it heads for a place that it has left unseen
  geom::Point back_to;        ///< that one [m, world]
  Swept swept;                ///< of a piece of a search
  ErrandSet given_back;       ///< it does not bid for them again
};
/// Where a robot is to go next that shares a VISIT or a SEARCH. Announces the parts that nobody has
/// announced, its own slice first, so that a unit announces all of them soon, and those that nobody wanted,
/// where this robot would take them. Bids for the part on offer that costs it least: of places by what they
/// add to its way, of pieces, a share's next one, by how far away they begin, those of others' shares last
/// and only where that is a help; for one that is not on offer just now it waits. Of a part it leaves out
/// what it can't come to; where that is all of it gives the part back and, if no closed way tells why, says
/// so.
geom::Point next_errand(const percept::Percepts& percepts, LegWatch::Verdict verdict, ErrandState& state,
                        LegWatch& watch, percept::Action& action);

/// Whether there is nothing to see of a piece of a SEARCH, since things stand on all of it, while there is of
/// others.
bool is_nothing_to_see(const percept::Percepts& percepts, const Errands& errands, std::size_t errand);
/// Tells the operator that a robot has come to nothing of a part, and why.
/// @param does  `gives back`, `leaves out`
void tell_of_lost(const percept::Percepts& percepts, const Errands& errands, std::size_t errand,
                  std::string_view does, percept::Action& action);

/// What the robot has found that looks at the places of a VISIT or a PATROL for its unit. A value of a frame.
struct Outlook {
  std::size_t looked_at = 0;  ///< so many places
  ErrandSet closed;           ///< no way leads to those, and nobody has been told
  bool leads_out = false;     ///< a way leads to one, or else away from where the robot is
  bool is_shut_in = false;
  bool has_told_unit = false;  ///< that it is shut in
};
/// How many robots have told of this order that they are shut in.
std::size_t shut_in_robots(const percept::Percepts& percepts);
/// Where the ways of a robot begin: where it is, or beside the area that it keeps out of and stands in [m,
/// world].
/// @param radius  of its body [m]
geom::Point way_begin(const percept::Percepts& percepts, double radius);
/// Looks at the next place. That no way leads to places is told of others than the robot itself only when it
/// is known that the robot isn't shut in.
/// @return  the place of the route that may be told of
std::optional<std::size_t> look_at_next(const percept::Percepts& percepts, double radius, double margin,
                                        Outlook& outlook);
/// Tells the operator, once, and the unit that a robot is shut in. @return  whether it told the operator
bool tell_of_shut_in(const percept::Percepts& percepts, double radius, double margin, Outlook& outlook,
                     percept::Action& action);

}  // namespace mlab::schema
