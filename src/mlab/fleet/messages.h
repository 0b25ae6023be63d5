#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "mlab/binding/radio.h"
#include "mlab/fleet/contracts.h"
#include "mlab/percept/action.h"
#include "mlab/percept/percepts.h"

namespace mlab::fleet {

struct FleetRobot;

/// Into an inbox, where notifications stand in ascending order, each once.
void put_notification(std::vector<std::uint64_t>& inbox, std::uint64_t notification);

/// What the robots of a run tell each other without anybody's help: notifications, places, claims,
/// contracts.
///
/// Whatever robots ask for in a cycle is resolved together after it, in the order of their ids, so all of
/// them see the same in the next one, however many threads ran them.
///
/// - A notification waits in the inbox of each robot that it reached until that robot takes it.
/// - A robot's last shared place is seen by everybody until it shares another one; so is the passage that it
///   asked for last.
/// - A claim holds for one cycle and has to be asked for in every one. Who held it keeps it; of those that
///   want it anew, the one with the least cost gets it, and of equals the one with the lowest id.
/// - Tasks are announced to a team, bid for and awarded: see `Contracts`.
///
/// Where radios reach only so far, notifications, places and passages come to those who are linked with their
/// teller in that cycle, also over others, unless they are lost on the way; a robot keeps the places that it
/// heard last. Claims and tasks are settled by all of a team, wherever they are.
class Messages {
 public:
  /// Resolves the requests in the robots' actions of this cycle.
  /// @param robots  by id, ascending; their inboxes are changed
  /// @param time    of the cycle [s]
  /// @param radio   who hears whom in it; asked only where something is told. Null: everybody everybody
  void resolve(
      std::vector<FleetRobot>& robots, double time,
      const std::function<const binding::RadioLinks*()>& radio = [] { return nullptr; });

  /// That a robot has heard of, by the robot that told it, ascending.
  std::span<const percept::SharedPlace> places(const FleetRobot& robot) const;
  /// Likewise.
  std::span<const percept::AskedPassage> passages(const FleetRobot& robot) const;
  /// All that it has been told by others.
  void add_told(const FleetRobot& robot, percept::Percepts& out) const;
  /// Of that team, by object, ascending.
  std::span<const percept::Claim> claims(std::uint32_t team) const;

  /// Of that team, by task, then object, ascending.
  std::span<const percept::Contract> contracts(std::uint32_t team) const { return contracts_.of(team); }

  /// That they take up beside this.
  std::size_t bytes() const {
    return places_.size() * sizeof places_[0] + passages_.size() * sizeof passages_[0] +
           claims_.size() * (sizeof claims_[0] + sizeof claim_teams_[0]) + contracts_.bytes();
  }

 private:
  struct Letter {
    std::uint32_t team;
    std::uint64_t notification;
    friend auto operator<=>(const Letter&, const Letter&) = default;
  };
  /// To those of a net.
  struct Broadcast {
    std::uint32_t net;
    bool is_to_all;
    std::uint32_t team;  ///< where it is not to all
    std::uint64_t notification;
    friend auto operator<=>(const Broadcast&, const Broadcast&) = default;
  };
  /// What somebody tells whose radio may not bring it to everybody.
  struct Told {
    std::size_t teller;  ///< place among the robots
    percept::Request request;
  };
  struct Wish {
    std::uint32_t team;
    percept::Claim claim;
    bool is_new;
    double cost;
  };

  void read(FleetRobot& robot);
  void tell(std::vector<FleetRobot>& robots, double time);
  void tell(std::vector<FleetRobot>& robots, double time, const binding::RadioLinks& radio);
  void deliver(std::vector<FleetRobot>& robots);
  void limit(std::vector<FleetRobot>& robots, bool is_limited);
  void settle_claims();

  std::vector<std::uint64_t> to_all_;
  std::vector<Letter> to_teams_;
  std::vector<Told> told_;
  std::vector<Broadcast> broadcasts_;
  std::vector<std::uint32_t> nets_;  // of robots, by place
  bool is_limited_ = false;  // not everybody hears everybody: each robot knows places and passages of its own
  std::vector<Wish> wishes_;
  std::vector<percept::SharedPlace> places_;
  std::vector<percept::AskedPassage> passages_;
  std::vector<percept::Claim> claims_;      // by team, then object
  std::vector<std::uint32_t> claim_teams_;  // of claims_
  Contracts contracts_;
};

}  // namespace mlab::fleet
