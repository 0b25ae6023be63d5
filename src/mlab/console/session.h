#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "mlab/cell/permission.h"
#include "mlab/console/machine_watch.h"
#include "mlab/console/server/connection_id.h"
#include "mlab/console/trial.h"
#include "mlab/history/history.h"
#include "mlab/metrics/exposition.h"
#include "mlab/preflight/gate.h"
#include "mlab/robot/host/limits.h"
#include "mlab/run/mission_run.h"
#include "mlab/tiles/map_tiles.h"

namespace mlab::console {

class SessionCore;
class ToServer;

/// Where its runs are recorded.
struct RecordSettings {
  bool is_on = false;
  std::string folder;  ///< the shelf of the newest runs
  std::string file;    ///< of the first run, in place of one on the shelf; empty: on the shelf, too
};

/// A run that was recorded, to be looked at in place of one of the session's own.
struct OpenRecording {
  std::string name;                           ///< for people
  std::shared_ptr<history::History> history;  ///< null: there is none
  std::string path = {};                      ///< of the file; empty: bookmarks are not kept
};

/// What a session is started with.
struct SessionSettings {
  cell::Permission permission;               ///< whether code that files bring may be compiled, and run
  robot_host::Limits limits;                 ///< of its programs
  bool in_own_processes = false;             ///< its robots, each
  std::string project_folder;                ///< nothing outside of it (but the examples) is read or written
  std::string example_folder;                ///< missions that come with mlab, read only; empty: none
  std::vector<std::string> overlay_folders;  ///< as mdl::LoadOptions
  std::string mission;                       ///< path of the mission to open first; empty: none
  std::string version;                       ///< of mlab
  std::string include_root;                  ///< as robot::ProgramSources
  std::string state_folder;                  ///< drafts, recent files; empty: nothing is kept
  /// Called, on the session's thread, whenever this changes: why what is not saved would be lost with this
  /// process. Empty: it would not.
  std::function<void(const std::string& why)> tell_not_kept = {};
  double speed = 10.0;                                ///< simulated seconds per second; 0: as fast as it goes
  std::shared_ptr<const tiles::MapTiles> tiles = {};  ///< what the map lies on; null: nothing
  run::RunSettings run;
  std::shared_ptr<preflight::Gate> gate = {};   ///< before vehicles that a run may have; null: it has none
  std::shared_ptr<MachineWatch> machines = {};  ///< who may carry its robots; null: no fleet does
  RecordSettings record = {};
  OpenRecording recording = {};     ///< then no mission is opened
  OpenRecording against = {};       ///< that the recording is compared with
  std::string journal_folder = {};  ///< where journals of its runs are kept; empty: nowhere
  std::string resume = {};  ///< the journal of a run to go on with, in place of `mission`; empty: none
};

/// One mission with its documents, its run, and the people who look at it. Has a thread of its own, on which
/// everything happens; the public functions may be called from any thread and return at once.
class Session {
 public:
  /// Hands a message to a connection. Called on the session's thread; must not block. The bytes are a
  /// serialised ToBrowser.
  using Send = std::function<void(ConnectionId to, std::shared_ptr<const std::string> bytes)>;

  Session(SessionSettings settings, Send send);
  /// As `end`.
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Ends the run and the thread. What is not saved is on the disk then, as drafts; what is asked later is
  /// not answered.
  /// @return  what could not be kept, and why: ``a.mdl`: No space left on device`
  std::vector<std::string> end();
  /// A message of a connection, in order of arrival. The first one has to be a Hello.
  void receive(ConnectionId from, std::unique_ptr<ToServer> message);
  void closed(ConnectionId connection);
  /// All robots stand from the next cycle on, whatever else is being done.
  void emergency_stop();
  /// Opens a mission that has no file; whoever is the operator, since nobody steers it yet.
  void try_out(Trial trial, TrialDone done);
  /// Shows the run to somebody who only reads it.
  void look_at_run(RunLook look);

  /// The bytes of the background picture of this revision of the scene, and their content type; empty where
  /// there is none.
  struct Picture {
    std::string content_type;
    std::shared_ptr<const std::string> bytes;
  };
  Picture picture(std::uint64_t revision) const;
  /// A square of the map of the Earth, as `tiles::MapTiles::find`. From any thread.
  Picture tile(std::uint32_t zoom, std::uint32_t column, std::uint32_t row) const;

  /// The report of the run as it stands (docs/report.md).
  std::string report() const;
  /// What a monitoring system is told (docs/metrics.md). Waits for nothing.
  void tell_metrics(metrics::Exposition& out) const;
  /// The mission has ended, at least once.
  bool has_ended() const;

 private:
  std::unique_ptr<SessionCore> core_;
};

}  // namespace mlab::console
