#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mlab/console/documents/documents.h"
#include "mlab/console/published/machines_encoder.h"
#include "mlab/console/run/event_log.h"
#include "mlab/console/session/bookmark_orders.h"
#include "mlab/console/session/chronicle.h"
#include "mlab/console/session/frames.h"
#include "mlab/console/session/look_backs.h"
#include "mlab/console/session/people.h"
#include "mlab/console/session/preflight_orders.h"
#include "mlab/console/session/run_control.h"
#include "mlab/console/session/run_maker.h"

namespace mlab::console {

/// What people are told without asking: everything when they come, and from then on what has changed. Nobody
/// has to say that something has: each topic is asked for its revision, or its message is compared with the
/// last one.
class Publisher {
 public:
  struct Parts {
    People& people;
    const OpenDocuments& documents;
    RunControl& run;
    const RunMaker& maker;
    Frames& frames;
    const EventLog& log;
    LookBacks& look_backs;
    Chronicle& chronicle;
    const BookmarkOrders& bookmarks;
    const PreflightOrders& preflight;
    MachineBoard& machines;
  };
  explicit Publisher(const Parts& parts);

  /// Tells one who has just come.
  void greet(ConnectionId to);
  /// Tells everybody what has changed.
  void publish();
  /// When there will be something to tell that is held back until then [s].
  double next() const;

 private:
  struct Topic {
    std::function<void(ToBrowser&)> tell;
    std::function<std::uint64_t()> revision;  ///< empty: the message is made, and compared
    bool is_of_run = false;                   ///< who looks at another moment is not told
    std::optional<std::uint64_t> told = std::nullopt;
    std::string told_bytes = {};
  };

  std::vector<Topic> topics();
  void publish(Topic& topic);
  void tell(ConnectionId to, bool of_run_only);
  /// Changes when the status is to be told to everybody: soon after something happened.
  std::uint64_t news_revision();
  /// Tells the status now and then while time passes: to a slow browser once it has drawn what it was told,
  /// so that nothing piles up before it.
  void publish_time();
  void begin_status(double wall);
  /// Obstacles may come and go by themselves.
  void look_at_world();
  std::uint64_t scene_revision() const;
  void tell_scene(ToBrowser& out) const;
  void tell_status(ToBrowser& out) const;

  People& people_;
  const OpenDocuments& documents_;
  RunControl& run_;
  const RunMaker& maker_;
  Frames& frames_;
  const EventLog& log_;
  LookBacks& look_backs_;
  Chronicle& chronicle_;
  const BookmarkOrders& bookmarks_;
  const PreflightOrders& preflight_;
  MachineBoard& machines_;

  std::uint64_t world_key_ = 0;      // of the obstacles that the scene has
  std::uint64_t world_changes_ = 0;  // how often obstacles came or went that no document has
  std::uint64_t told_state_ = 0;     // RunControl::state_revision of the last status
  std::uint64_t status_number_ = 0;  // Channel::status_seen
  double last_status_ = -1e9;
  std::vector<Topic> topics_;
};

}  // namespace mlab::console
