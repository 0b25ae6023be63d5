#pragma once

#include <string>

#include "mlab/console/documents/documents.h"
#include "mlab/console/run/event_log.h"
#include "mlab/console/session/bookmark_orders.h"
#include "mlab/console/session/chronicle.h"
#include "mlab/console/session/people.h"
#include "mlab/console/session/request.h"
#include "mlab/console/session/run_control.h"
#include "mlab/console/session/run_maker.h"

namespace mlab::console {

/// Brings back what an earlier session has left: mission, log, who was who, and the run.
class Resumption {
 public:
  /// All of it outlives this.
  struct Parts {
    OpenDocuments& documents;
    RunControl& run;
    People& people;
    RunMaker& maker;
    Chronicle& chronicle;
    BookmarkOrders& bookmarks;
    EventLog& log;
  };
  explicit Resumption(const Parts& parts) : parts_(parts) {}

  /// @param path  of a journal
  /// @errors  a sentence; what was open is as it was
  Answered resume(const std::string& path);
  /// What a browser asks for.
  Answered continue_run(const Sender& sender, const ContinueRun& wanted);

 private:
  Answered open_mission(const journal::Kept& kept);
  void recall(const journal::Kept& kept);

  Parts parts_;
};

}  // namespace mlab::console
