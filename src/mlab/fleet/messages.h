#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "mlab/fleet/contracts.h"
#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"

namespace mlab::fleet {

struct FleetRobot;

/// What the robots of a run tell each other without anybody's help: notifications, places, claims,
/// contracts.
///
/// Whatever robots ask for in a cycle is resolved together after it, in the order of their ids, so all of
/// them see the same in the next one, however many threads ran them.
///
/// - A notification waits in the inbox of each robot that it reached until that robot takes it.
/// - A robot's last shared place is seen by everybody until it shares another one.
/// - A claim holds for one cycle and has to be asked for in every one. Who held it keeps it; of those that
///   want it anew, the one with the least cost gets it, and of equals the one with the lowest id.
/// - Tasks are announced to a team, bid for and awarded: see `Contracts`.
class Messages {
 public:
  /// Resolves the requests in the robots' actions of this cycle.
  /// @param robots  by id, ascending; their inboxes are changed
  /// @param time    of the cycle [s]
  void resolve(std::vector<FleetRobot>& robots, double time);

  /// By the robot that told it, ascending.
  std::span<const percept::SharedPlace> places() const { return places_; }
  /// Of that team, by object, ascending.
  std::span<const percept::Claim> claims(std::uint32_t team) const;

  /// Of that team, by task, then object, ascending.
  std::span<const percept::Contract> contracts(std::uint32_t team) const { return contracts_.of(team); }

  /// That they take up beside this.
  std::size_t bytes() const {
    return places_.size() * sizeof places_[0] +
           claims_.size() * (sizeof claims_[0] + sizeof claim_teams_[0]) + contracts_.bytes();
  }

 private:
  struct Letter {
    std::uint32_t team;
    std::uint64_t notification;
    friend auto operator<=>(const Letter&, const Letter&) = default;
  };
  struct Wish {
    std::uint32_t team;
    percept::Claim claim;
    bool is_new;
    double cost;
  };

  void read(FleetRobot& robot, double time);
  void share(base::RobotId from, const percept::Request& request, double time);
  void deliver(std::vector<FleetRobot>& robots);
  void settle_claims();

  std::vector<std::uint64_t> to_all_;
  std::vector<Letter> to_teams_;
  std::vector<Wish> wishes_;
  std::vector<percept::SharedPlace> places_;
  std::vector<percept::Claim> claims_;      // by team, then object
  std::vector<std::uint32_t> claim_teams_;  // of claims_
  Contracts contracts_;
};

}  // namespace mlab::fleet
