#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "mlab/geom/pose.h"
#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"
#include "mlab/percept/shared_route.h"

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
  /// Null: nobody has announced it.
  const percept::Contract* contract(std::size_t errand) const { return contracts_[errand]; }
  /// Which part the contract is about.
  std::optional<std::size_t> errand_of(const percept::Contract& contract) const;
  /// Whether that robot has one that is not done.
  bool has_one(base::RobotId robot) const;
  /// Whether a piece is the last one of its share that nobody has, and somebody else is on the one before: he
  /// goes straight on with it, before who would come from elsewhere.
  bool is_left_to_another(std::size_t errand, base::RobotId robot) const;
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
};

/// Where a robot is on its way round the places of a PATROL. It tells that with its place: in the number of
/// the object that a SharedPlace is about.
struct TourPlace {
  std::size_t leg = 0;  ///< it heads for that place of the route
  bool has_gone_round = false;
};
base::ObjectId tour_code(const percept::Order& order, TourPlace place);
/// Nothing: it speaks of something else.
std::optional<TourPlace> tour_place(const percept::Order& order, const percept::SharedPlace& shared);

/// The leg of the tour that is nearest to a place.
std::size_t nearest_leg(std::span<const geom::Point> tour, geom::Point p);

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

 private:
  double least_ = 0.0;  // that was left [m]
  double nearer_at_ = 0.0;
};

/// Which part a robot is on. A value of a frame.
struct ErrandState {
  std::int32_t current = -1;  ///< -1: none
  std::uint32_t leg = 0;      ///< of that part's way
  double along = 0.0;         ///< the leg, so far it has tried to come back to it [m]
  bool comes_back = false;    ///< it heads for that place, not for the corner
  ErrandSet given_back;       ///< it does not bid for them again
};
/// Where a robot is to go next that shares a VISIT or a SEARCH. Announces the parts that nobody has
/// announced, its own slice first, so that a unit announces all of them soon, and those that nobody wanted,
/// where this robot would take them. Bids for the part on offer that costs it least: of places by what they
/// add to its way, of pieces by how far away they begin, those of others' shares last.
geom::Point next_errand(const percept::Percepts& percepts, LegWatch::Verdict verdict, ErrandState& state,
                        LegWatch& watch, percept::Action& action);

/// How far a robot is on its way round. A value of a frame.
struct TourState {
  TourPlace at;
  std::uint32_t passed = 0;  ///< places so far
};
/// Where a robot is to go next that shares a PATROL. Tells the others where it is.
geom::Point next_tour_place(const percept::Percepts& percepts, LegWatch::Verdict verdict, TourState& state,
                            LegWatch& watch, percept::Action& action);

/// How fast a robot goes round so that all that do spread evenly: 1, or less where it is nearer to the next
/// one than its share of the round. Who has told nothing for `patience` [s] does not count.
double patrol_pace(const percept::Percepts& percepts, double patience, double slowest);

}  // namespace mlab::schema
