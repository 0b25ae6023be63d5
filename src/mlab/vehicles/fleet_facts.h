#pragma once

#include <chrono>
#include <condition_variable>
#include <expected>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "mlab/agents/echo.h"
#include "mlab/agents/roster.h"
#include "mlab/dds/reader.h"
#include "mlab/dds/waiter.h"
#include "mlab/preflight/preflight.h"

namespace mlab::vehicles {

/// What is known of vehicles of a fleet, as they say it and as the way to them is measured. Listens, on a
/// thread of its own, to those that were asked for within the last minute; nobody is told anything. May be
/// used by any thread.
class FleetFacts {
 public:
  explicit FleetFacts(std::shared_ptr<agents::Roster> roster);
  FleetFacts(const FleetFacts&) = delete;
  FleetFacts& operator=(const FleetFacts&) = delete;
  ~FleetFacts();

  /// Begins to listen to them, so that `look` need not wait.
  void expect(const std::vector<std::string>& names);

  /// Who is there and is no vehicle is left out; who is not there is told as such. Waits until each has been
  /// heard, for some seconds at most.
  std::vector<preflight::VehicleFacts> look(const std::vector<std::string>& names);

  /// The same of those vehicles that are there, as far as it is known by now.
  std::vector<preflight::VehicleFacts> glance(const std::vector<std::string>& names) const;

 private:
  /// One vehicle that is listened to.
  struct Watched {
    dds::Reader reports;
    dds::Reader checks;
    dds::Guid from = {};      // whose process said what follows
    std::string report = {};  // the newest, as bytes that anybody may have sent; empty: none has come
    vehicle::Clock::time_point arrived = {};
    std::optional<std::vector<vehicle::Check>> said = {};
    vehicle::Clock::time_point said_at = {};
    std::optional<agents::LinkQuality> link = {};
    int echoes = 0;  // that were asked for since
  };

  void listen(const std::stop_token& stop);
  void take_news();
  void take(const std::string& name, Watched& one);
  void measure(agents::EchoProbe& links);
  void want(const std::vector<std::string>& names);
  bool is_known(const std::string& name, vehicle::Clock::time_point now) const;
  preflight::VehicleFacts facts(const agents::Member& member, vehicle::Clock::time_point now) const;

  std::shared_ptr<agents::Roster> roster_;
  const vehicle::Clock::time_point joined_ = vehicle::Clock::now();
  dds::Waiter waiter_;
  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::map<std::string, Watched> watched_;  // by name
  vehicle::Clock::time_point asked_;        // last
  std::jthread thread_;
};

}  // namespace mlab::vehicles
