#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"

namespace mlab::fleet {

struct FleetRobot;

/// The tasks that the robots of each team contract for.
///
/// Whoever announces a task is its manager. Robots bid for it, each with what it would cost them; a bid holds
/// for its cycle. The first bids after the announcement's wait decide: in each cycle each team gives one
/// task, of all those on offer, to the robot whose bid is the least; of equals to the lowest id. Robots that
/// bid again in the next cycle, with what one more task adds to those that they have, hold a sequential
/// single-item auction. Who was awarded a task and has not begun with it may bid for it himself, with what it
/// costs him: then it goes to whoever bids less. A task for which nobody bids when its wait is over has
/// failed, unless the team still bids for others.
///
/// Who has a task tells in each cycle that he still works on it. When he was silent for longer than the
/// announcement's patience (his program failed, his machine is lost, he does something else) the task is on
/// offer again.
///
/// @source  Smith 1980, "The Contract Net Protocol", IEEE Transactions on Computers C-29(12); Lagoudakis et
/// al. 2005,
///          "Auction-Based Multi-Robot Routing", Robotics: Science and Systems
class Contracts {
 public:
  /// Of a team, whatever their state. What is announced beyond that takes the place of the oldest that is
  /// done or has failed; where all are wanted it is not heard.
  static constexpr std::size_t kMostOfATeam = 512;

  /// Resolves the requests in the robots' actions of this cycle: announcements, then what contractors tell,
  /// in the order of the robots' ids; then awards.
  /// @param robots  by id, ascending
  /// @param time    of the cycle [s]
  void resolve(std::span<const FleetRobot> robots, double time);

  /// Of that team, by task, then object, ascending.
  std::span<const percept::Contract> of(std::uint32_t team) const;

  /// That they take up beside this.
  std::size_t bytes() const { return contracts_.size() * (sizeof contracts_[0] + sizeof terms_[0]); }

 private:
  struct Terms {
    std::uint32_t team;
    double wait;      // [s]
    double patience;  // [s]
    double deadline;  // when bids are compared [s]
    double heard;     // when its contractor was heard of last [s]
  };
  struct Bid {
    std::uint32_t team;
    std::size_t contract;  // index
    double cost;
    base::RobotId robot;
  };

  std::size_t place_of(std::uint32_t team, const percept::Request& request) const;
  bool is_at(std::size_t place, std::uint32_t team, const percept::Request& request) const;
  void announce(const FleetRobot& robot, const percept::Request& request, double time);
  bool forget_oldest(std::uint32_t team);
  void hear(const FleetRobot& robot, const percept::Request& request, double time);
  void keep(const FleetRobot& robot, double time);
  void bid(const FleetRobot& robot, const percept::Request& request);
  void offer(std::size_t contract, double time);
  void drop_bids_in_vain();
  void award(double time);
  void give_up(double time);

  // By team, then task, then object.
  std::vector<percept::Contract> contracts_;
  std::vector<Terms> terms_;   // of contracts_
  std::vector<Bid> bids_;      // of this cycle
  std::vector<Bid> own_bids_;  // of who has the task already
};

}  // namespace mlab::fleet
