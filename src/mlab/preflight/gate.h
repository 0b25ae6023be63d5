#pragma once

#include <algorithm>
#include <atomic>
#include <expected>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/preflight/preflight.h"
#include "mlab/preflight/store.h"

namespace mlab::preflight {

/// Stands between a run and the vehicles of its mission that are not simulated: what they say passes to the
/// run, and what it wants to them, only where they were checked. A run gets a new one, which lets nobody
/// pass. May be asked by any thread.
class Permit {
 public:
  /// The run may start.
  bool is_given() const { return is_given_; }
  bool lets_pass(std::string_view vehicle) const {
    return is_given_ && std::ranges::find(vehicles_, vehicle) != vehicles_.end();
  }
  /// Once. One that was not there when the others were checked stays out, also when it comes later.
  void give(std::vector<std::string> vehicles) {
    vehicles_ = std::move(vehicles);
    is_given_ = true;
  }

 private:
  std::vector<std::string> vehicles_;  // before `is_given_`, never changed afterwards
  std::atomic<bool> is_given_ = false;
};

/// Whether a mission may start on its vehicles, and what there is to be signed before. By any thread.
class Gate {
 public:
  struct Parts {
    std::string fleet;
    std::string version;  ///< of missionlab
    /// What is known now of those of these members that are vehicles, or are not there; may take some
    /// seconds for one that was not looked at before.
    std::function<std::vector<VehicleFacts>(const std::vector<std::string>& names)> look;
    /// The same, as far as it is known by now: does not wait, and does not begin to listen. Empty: nothing
    /// is.
    std::function<std::vector<VehicleFacts>(const std::vector<std::string>& names)> glance = {};
    std::function<double()> wall_clock;  ///< as Signature::at
    Store store;
    std::string how;  ///< to make a checklist, for people: `mlab preflight a.mdl --fleet alpha --sign "NAME"`
    std::string unchecked;  ///< why none is needed, in somebody's words; empty: one is
  };
  explicit Gate(Parts parts) : parts_(std::move(parts)) {}

  /// Looks at the mission and its vehicles.
  Checklist look(const run::Crew& crew) const;

  /// Looks once more, signs, and keeps what was signed.
  /// @param signature  its time is not read: it is now
  /// @errors  a sentence: why_not_signed, or why it can't be kept
  std::expected<SignedChecklist, std::string> sign(const run::Crew& crew, Signature signature) const;

  /// What was signed for this mission and holds; looks once more.
  /// @errors  why there is none, as a sentence
  std::expected<SignedChecklist, std::string> held(const run::Crew& crew) const;

  /// To be asked before anything of the run moves. Where nothing is against it the newest run's vehicles are
  /// its own from now on.
  /// @return  why it may not start, and what is to be done; empty: it may
  std::string why_not_start(const run::Crew& crew);

  /// What is known now of those of these vehicles of which the newest run hears nothing: before it may start,
  /// or because they came too late. For people to look at; nothing of it may enter a run.
  std::vector<VehicleFacts> held_back(const std::vector<std::string>& names) const;
  /// The newest run may start.
  bool has_let_pass() const;

  /// As Parts::unchecked.
  const std::string& unchecked() const { return parts_.unchecked; }

  /// For the vehicles of a run that is being made.
  std::shared_ptr<Permit> new_permit();

  /// What `why_not_start` went by, for the log of the run and its recording.
  struct Passed {
    std::string said = {};       ///< a sentence; empty: nothing real moves, or the run was not let pass
    std::string checklist = {};  ///< that was signed, as JSON; empty: none was
    bool is_unchecked = false;
  };
  Passed passed() const;

 private:
  void let_pass(Permit& permit, std::vector<std::string> vehicles, Passed passed);

  const Parts parts_;
  mutable std::mutex mutex_;
  std::shared_ptr<Permit> permit_;  // of the newest run; null: it has no vehicles
  Passed passed_;
};

}  // namespace mlab::preflight
