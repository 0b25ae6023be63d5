#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/binding/vehicle_state.h"
#include "mlab/geom/pose.h"
#include "mlab/run/crew.h"
#include "mlab/vehicle/check.h"
#include "mlab/vehicle/device.h"

/// What is looked at before a mission moves vehicles: a checklist as data. Nothing here reads a clock, a file
/// or the network.

namespace mlab::preflight {

using vehicle::CheckResult;

// ---- what is known

/// The way to a vehicle's process and back, as measured.
struct Link {
  double round_trip = 0.0;    ///< [s]
  double lost = 0.0;          ///< share of the last questions without an answer, 0 .. 1
  double clock_offset = 0.0;  ///< of its wall clock; more than 0: ahead [s]
};

/// What is known of a vehicle that a mission names, at a moment. What is not known is not there.
struct VehicleFacts {
  std::string name = {};           ///< in the fleet
  bool is_there = false;           ///< else nothing below is so now
  std::string why_not_there = {};  ///< as a sentence without its subject: `has not joined the fleet`
  std::string kind = {};           ///< for people: `MAVLink rover at udp:14550`
  std::string session = {};        ///< of its process: another one each time that it is started
  std::string version = {};        ///< of missionlab there
  std::string machine = {};        ///< that its process runs on
  bool is_simulated = false;       ///< it says that nothing real moves
  std::optional<vehicle::Limits> limits = {};
  std::string limits_refusal = {};  ///< what of its limits can't be, as a sentence; empty: they can be
  std::optional<Link> link = {};
  std::optional<vehicle::Report> report = {};  ///< the newest
  double report_age = 0.0;                     ///< since that arrived [s]
  vehicle::Clock::time_point arrived = {};     ///< when it did, on the clock of the times in it
  bool is_driven = false;                      ///< by a run
  bool is_stopped = false;                     ///< an emergency stop holds there
  std::optional<std::vector<vehicle::Check>> checks =
      {};  ///< what it says of itself; nothing: it has not said
};

/// The same as the console tells it of vehicles; what another run has, or nobody. Nothing: it has not said.
std::optional<binding::VehicleState> state_of(const VehicleFacts& facts);

// ---- the checklist

/// Something that was looked at by itself.
struct Item {
  std::string id;       ///< the same in each checklist: `veh-1/link`, `mission/failsafes`
  std::string vehicle;  ///< whose it is; empty: the mission's
  std::string name;     ///< for people: `link`
  CheckResult result = CheckResult::kUnknown;
  std::string is;        ///< what is, as a sentence: `2.1 ms there and back, nothing is lost`
  std::string expected;  ///< empty: nothing in particular

  friend bool operator==(const Item&, const Item&) = default;
};

/// Something that only a person at the vehicles can confirm.
struct ManualItem {
  std::string id;    ///< `area-clear`
  std::string text;  ///< what is confirmed, as a sentence

  friend bool operator==(const ManualItem&, const ManualItem&) = default;
};

/// A vehicle of a checklist.
struct CheckedVehicle {
  std::string name;
  std::string kind;
  std::string session;  ///< of its process; empty: it is not there
  std::string version;
  bool is_simulated = false;
  std::vector<std::uint32_t> robots;  ///< of the mission, whose body it is

  friend bool operator==(const CheckedVehicle&, const CheckedVehicle&) = default;
};

struct Checklist {
  std::string mission;  ///< its name
  std::string fleet;
  std::string digest;  ///< of all texts that the mission is made from: 16 hexadecimal digits
  std::vector<CheckedVehicle> vehicles;  ///< by name
  /// Those of the mission first, then vehicle by vehicle; of each what has failed first, then warnings, then
  /// what nobody knows.
  std::vector<Item> items;
  std::vector<ManualItem> manual;

  /// Nothing real moves, so nobody has to sign.
  bool is_needed() const;
  /// Of all items; kPass where nothing is wrong and all is known.
  CheckResult worst() const;
  friend bool operator==(const Checklist&, const Checklist&) = default;
};

/// Names of the vehicles that robots of a mission have as bodies, or would if they were there: the hosts
/// of their types, each once, in order.
std::vector<std::string> hosts_of(const mission::Mission& mission);

/// Of all that is read for the mission: its text, overlays, configurations, and what was set in their place.
std::string digest_of(const run::Crew& crew);

/// @param vehicles  what is known of those of the mission's hosts that are vehicles
/// @param version   of missionlab here
Checklist assemble(const run::Crew& crew, const std::string& fleet, std::span<const VehicleFacts> vehicles,
                   const std::string& version);

/// The items that persons confirm, whatever the mission.
const std::vector<ManualItem>& manual_items();

// ---- signing

/// So long after it was signed a checklist holds [s].
inline constexpr double kHoldsFor = 3600.0;

/// Somebody starts the mission though an item has failed.
struct Acceptance {
  std::string item;     ///< Item::id
  std::string because;  ///< why, in his words

  friend bool operator==(const Acceptance&, const Acceptance&) = default;
};

struct Signature {
  std::string by;                      ///< his name
  double at = 0.0;                     ///< wall clock, seconds since 1970-01-01 00:00 UTC
  std::vector<std::string> confirmed;  ///< ManualItem::id, all of them
  std::vector<Acceptance> accepted;    ///< for each item that has failed

  friend bool operator==(const Signature&, const Signature&) = default;
};

struct SignedChecklist {
  Checklist checklist;
  Signature signature;

  friend bool operator==(const SignedChecklist&, const SignedChecklist&) = default;
};

/// Why a checklist can't be signed like this: an item that is not confirmed, one that has failed and is not
/// accepted, a reason or a name that is missing. A sentence; empty: it can.
std::string why_not_signed(const Checklist& checklist, const Signature& signature);

/// Why a signed checklist does not hold for what is now: it is too old, of other texts, of other vehicles or
/// other processes of theirs, or something has failed since. A sentence; empty: it holds.
/// @param now      assembled now
/// @param at       wall clock, as Signature::at
std::string why_it_does_not_hold(const SignedChecklist& checklist, const Checklist& now, double at);

// ---- for people and files

std::string_view word_of(CheckResult result);  ///< `pass`, `warn`, `FAIL`, `unknown`

/// To be read in 80 columns.
std::string text_of(const Checklist& checklist);

/// docs/preflight.md says what is where.
std::string json_of(const Checklist& checklist);
std::string json_of(const SignedChecklist& checklist);
/// @return nothing where it is not whole, or is something else
std::optional<SignedChecklist> read_signed(std::string_view json);

}  // namespace mlab::preflight
