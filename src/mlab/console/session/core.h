#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "mlab/console/documents/documents.h"
#include "mlab/console/inbox.h"
#include "mlab/console/published/machines_encoder.h"
#include "mlab/console/run/event_log.h"
#include "mlab/console/session.h"
#include "mlab/console/session/bookmark_orders.h"
#include "mlab/console/session/chronicle.h"
#include "mlab/console/session/document_orders.h"
#include "mlab/console/session/failsafe_trials.h"
#include "mlab/console/session/frames.h"
#include "mlab/console/session/look_backs.h"
#include "mlab/console/session/map_picture.h"
#include "mlab/console/session/measuring.h"
#include "mlab/console/session/name_orders.h"
#include "mlab/console/session/other_futures.h"
#include "mlab/console/session/people.h"
#include "mlab/console/session/preflight_orders.h"
#include "mlab/console/session/publisher.h"
#include "mlab/console/session/resumption.h"
#include "mlab/console/session/robot_parameters.h"
#include "mlab/console/session/run_control.h"
#include "mlab/console/session/run_maker.h"
#include "mlab/console/session/run_orders.h"
#include "mlab/documents/project_folder.h"

namespace mlab::console {

/// The session's thread, and what stands on it. A member knows only those that stand above it; where one has
/// to call down, the core hands it a function.
class SessionCore {
 public:
  SessionCore(SessionSettings settings, Session::Send send);
  ~SessionCore();
  SessionCore(const SessionCore&) = delete;
  SessionCore& operator=(const SessionCore&) = delete;

  // ---- from any thread, as Session

  void receive(ConnectionId from, std::unique_ptr<ToServer> message);
  void closed(ConnectionId connection);
  void emergency_stop();
  void try_out(Trial trial, TrialDone done);
  void look_at_run(RunLook look);
  Session::Picture picture(std::uint64_t revision) const { return picture_.find(revision); }
  Session::Picture tile(std::uint32_t zoom, std::uint32_t column, std::uint32_t row) const;
  std::string report();
  void tell_metrics(metrics::Exposition& out) const { measuring_.tell(out); }
  std::vector<std::string> end();
  bool has_ended() const { return has_ended_; }

 private:
  friend struct Order;  // which of these takes a message

  void work();
  void open_first_mission();
  void take(ConnectionId from, const ToServer& message);
  Answered hello(ConnectionId from, const ToServer& message);
  void keep_what_is_acknowledged(const ToServer& message, Reply& reply);
  void do_tasks(const std::vector<Inbox::Task>& tasks);
  /// Within a cycle, while a robot's own process computes. @return  true: the cycle is not to be waited for
  bool attend_during_cycle();
  /// When the loop has to look around again [s].
  double next_wake();
  mdl::LoadOptions load_options() const;

  // What takes more than one of those below.
  Answered control(const Sender& sender, const Control& control);
  /// Why an order of somebody who may give orders can't be taken.
  Answered why_no_order(ConnectionId from, const ToServer& message) const;
  Answered take_operator(const Sender& sender);
  Answered pass_operator(const Sender& sender, const PassOperator& pass);

  const SessionSettings settings_;
  const double began_;
  const std::string started_at_;
  std::atomic<bool> ends_ = false;
  std::atomic<bool> has_ended_ = false;
  double published_during_cycle_ = 0.0;

  Inbox inbox_;
  EventLog log_;
  documents::ProjectFolder project_;
  OpenDocuments documents_;
  MapPicture picture_;
  People people_;
  RunControl run_;
  PreflightOrders preflight_orders_;
  RobotParameters parameters_;
  history::KeptBookmarks bookmarks_;  // of the run, or of the recording that was opened
  BookmarkOrders bookmark_orders_;
  Chronicle chronicle_;
  RunMaker maker_;
  Resumption resumption_;
  DocumentOrders document_orders_;
  NameOrders name_orders_;
  RunOrders run_orders_;
  FailsafeTrials failsafe_trials_;
  LookBacks look_backs_;
  OtherFutures other_futures_;
  Frames frames_;
  MachineBoard machines_;
  Publisher publisher_;
  Measuring measuring_;
  std::thread thread_;
};

}  // namespace mlab::console
