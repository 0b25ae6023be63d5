#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "mlab/console/documents/documents.h"
#include "mlab/console/run/event_log.h"
#include "mlab/console/session/request.h"
#include "mlab/console/session/run_control.h"
#include "mlab/history/history.h"

namespace mlab::console {

/// Parameters of robots that people set while they look at a run: in this run, and in every later one of the
/// mission.
class RobotParameters {
 public:
  RobotParameters(RunControl& run, OpenDocuments& documents, EventLog& log)
      : run_(run), documents_(documents), log_(log) {}

  /// An edit that can be undone.
  Answered set(const Sender& sender, const SetParameter& set);
  /// The run is another one of the same mission.
  void apply_all();
  /// What people had set in a run that is gone on with.
  void recall(const std::vector<history::InputEntry>& inputs);
  /// Another mission is open.
  void clear() { values_.clear(); }

 private:
  using Robots = std::vector<std::uint32_t>;
  /// Each robot's parameter as text. @errors  a sentence
  Answered read(const Robots& robots, const std::string& port, std::vector<std::string>& values) const;
  /// @errors  nothing has changed then
  Answered apply(const Robots& robots, const std::string& port, const std::vector<std::string>& values);

  RunControl& run_;
  OpenDocuments& documents_;
  EventLog& log_;
  std::map<std::uint32_t, std::map<std::string, std::string>> values_;  // by robot and port
};

}  // namespace mlab::console
