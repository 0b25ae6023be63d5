#pragma once

#include <cstdint>
#include <expected>
#include <memory>
#include <string>

#include "mlab/console/inbox.h"
#include "mlab/console/session.h"
#include "mlab/console/session/people.h"
#include "mlab/console/session/request.h"
#include "mlab/console/session/run_control.h"
#include "mlab/console/workshop.h"
#include "mlab/preflight/gate.h"

namespace mlab::console {

/// What is looked at and signed before the run moves vehicles. Looking at vehicles may take seconds, so that
/// is done on a thread of its own. Belongs to the session's thread.
class PreflightOrders {
 public:
  /// What it works with; all of it outlives it.
  struct Parts {
    const SessionSettings& settings;
    RunControl& run;
    People& people;
    Inbox& inbox;
  };
  explicit PreflightOrders(const Parts& parts);
  ~PreflightOrders() { end(); }
  PreflightOrders(const PreflightOrders&) = delete;
  PreflightOrders& operator=(const PreflightOrders&) = delete;
  /// Nothing is looked at any more.
  void end() { workshop_.reset(); }

  /// Looks at the vehicles of another mission, and again now and then until its run may start. To be called
  /// in each round of the session.
  void follow();

  Answered check(const CheckVehicles& asked);
  /// Answered later.
  Answered sign(const Sender& sender, const SignPreflight& wanted, const Reply& reply);

  void encode(Preflight& out) const;
  /// Grows where that has changed.
  std::uint64_t revision() const { return revision_; }

 private:
  using CrewPtr = std::shared_ptr<const run::Crew>;
  using Held = std::expected<preflight::SignedChecklist, std::string>;

  CrewPtr crew() const;
  bool has_started() const;
  void look(const CrewPtr& crew);
  void take(std::uint64_t number, const CrewPtr& crew, preflight::Checklist checklist, Held held);

  const Parts parts_;
  std::uint64_t known_run_ = 0;
  std::uint64_t known_plan_ = 0;
  std::uint64_t number_ = 0;  // of the newest look; what older ones bring is thrown away
  bool is_looking_ = false;
  double looked_ = 0.0;     // when the last one ended, as wall_time() [s]
  double looked_at_ = 0.0;  // the same for people, as Preflight::looked_at; 0: not since the mission is open
  std::unique_ptr<preflight::Checklist> checklist_;  // null: nothing is known of its vehicles yet
  Held held_ = std::unexpected(std::string());
  std::uint64_t revision_ = 1;
  std::unique_ptr<Workshop> workshop_;  // ends before everything that its jobs report to
};

}  // namespace mlab::console
