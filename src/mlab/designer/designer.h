#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mlab/cell/permission.h"
#include "mlab/console/server/connection_id.h"
#include "mlab/console/trial.h"
#include "mlab/robot/host/limits.h"

namespace mlab::designer {

class DesignerCore;
class ToDesigner;

/// What a designer is started with.
struct DesignerSettings {
  std::string project_folder;  ///< nothing outside of it (but examples and library) is read or written
  std::string example_folder;  ///< configurations that come with mlab, read only; empty: none
  std::string open;            ///< file on the machine to open first; empty: none
  std::string version;         ///< of mlab
  std::string include_root;    ///< as robot::ProgramSources
  std::string state_folder;    ///< drafts, recent files; empty: nothing is kept
  /// As SessionSettings::tell_not_kept, on the designer's thread.
  std::function<void(const std::string& why)> tell_not_kept = {};
  /// Hands a mission to the session in which it is seen running; any thread may call the second argument.
  /// Empty: there is none.
  std::function<void(console::Trial trial, console::TrialDone done)> try_out;
  /// Shows that session's run. Empty: there is none.
  std::function<void(console::RunLook look)> look_at_run;
  /// Whether the C++ of procedures that a configuration uses may be compiled, and run.
  cell::Permission permission;
  robot_host::Limits limits;  ///< of its programs
};

/// Open configurations, and the people who draw them. Has a thread of its own, on which everything happens;
/// the public functions may be called from any thread and return at once.
class Designer {
 public:
  /// Hands a message to a connection. Called on the designer's thread; must not block. The bytes are a
  /// serialised FromDesigner.
  using Send = std::function<void(console::ConnectionId to, std::shared_ptr<const std::string> bytes)>;

  Designer(DesignerSettings settings, Send send);
  /// As `end`.
  ~Designer();
  Designer(const Designer&) = delete;
  Designer& operator=(const Designer&) = delete;

  /// As Session::end.
  std::vector<std::string> end();
  /// A message of a connection, in order of arrival. The first one has to be a Greeting.
  void receive(console::ConnectionId from, std::unique_ptr<ToDesigner> message);
  void closed(console::ConnectionId connection);

 private:
  std::unique_ptr<DesignerCore> core_;
};

}  // namespace mlab::designer
