#pragma once

#include <expected>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>

#include "mlab/agents/agent_log.h"
#include "mlab/dds/network.h"
#include "mlab/dds/participant.h"
#include "mlab/presence.pb.h"
#include "mlab/robot/program/robot_program.h"

namespace mlab::agents {

/// What this machine calls itself; empty: nothing.
std::string machine_name();

/// What has the network of an agent's process at its disposal, beside it. On a thread of its own, if it needs
/// one; ends with the object.
class Companion {
 public:
  Companion() = default;
  Companion(const Companion&) = delete;
  Companion& operator=(const Companion&) = delete;
  virtual ~Companion() = default;
  /// Robots that it has a run drive at present.
  virtual std::size_t robot_count() const = 0;
};

/// A vehicle whose process takes part as an agent does: it has a name, is seen, and obeys the emergency stop.
/// It carries no programs.
struct OfferedVehicle {
  wire::OfferedVehicle said;
  /// @param is_stopped  an emergency stop holds; by any thread
  /// @errors  a sentence
  std::function<std::expected<std::unique_ptr<Companion>, std::string>(dds::Participant& participant,
                                                                       std::function<bool()> is_stopped)>
      begin;
};

struct AgentSettings {
  dds::Network network;
  std::string name;  ///< in the fleet: is_agent_name
  /// What of code that runs bring may be compiled and run here, and by what means. `version` is this agent's.
  robot::ProgramSources sources;
  /// Path of the executable whose robots it carries, and no others; empty: those that are built from text.
  std::string offered = {};
  std::optional<OfferedVehicle> vehicle = {};  ///< nothing: it is no vehicle's, but carries programs
  /// File that an emergency stop is kept in, so that the agent still stands when it is started again; empty:
  /// it is not kept. Those of the machine's other agents lie beside it (siblings.h).
  std::string stop_file = {};
  std::shared_ptr<AgentLog> log;         ///< gets what a person at this machine is to know; not null
  std::function<void()> tell_stop = {};  ///< called when the emergency stop was pulled or released
  /// Asked by any thread: what this moves is to stand, since its process is about to be ended by force;
  /// empty: never.
  std::function<bool()> must_stand = {};
  std::function<void()> tell_ready = {};  ///< called once it has joined; empty: nobody wants to know
};

/// Joins the fleet and carries robots for its runs, until `stop` is requested; then all robots here end. A
/// run whose process goes away, or is silent for so long that it is given up, loses its robots here.
/// @errors  a sentence: the network can't be used; the name is taken; the executable is no robot program
std::optional<std::string> serve_as_agent(const AgentSettings& settings, const std::stop_token& stop);

}  // namespace mlab::agents
