#include <atomic>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/core.h>

#include "mlab/agents/agent_process.h"
#include "mlab/cli/clock.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/fleet_network.h"
#include "mlab/cli/interrupt.h"
#include "mlab/cli/output.h"
#include "mlab/cli/permission.h"
#include "mlab/cli/places.h"
#include "mlab/cli/version.h"

namespace mlab::cli {
namespace {

// A line of the agent's log, at once.
void say(const std::string& line) {
  write_output_now(fmt::format("{}  {}\n", print(wall_clock()), line));
}

// One for each name in each fleet on this machine.
std::string kept_file(const std::string& fleet, const std::string& name, const char* what) {
  const std::string folder = state_folder();
  return folder.empty() ? "" : fmt::format("{}/agents/{}@{}.{}", folder, fleet, name, what);
}

/// When an agent was there last, on the disk: an agent that did not end in order, because its machine had no
/// power say, tells of it when it is back.
class LastSeen {
 public:
  /// @param file  empty: it is not kept
  explicit LastSeen(std::string file) : file_(std::move(file)) {}

  void tell_gap() const {
    std::ifstream stream(file_);
    std::int64_t last = 0;
    if (file_.empty() || !(stream >> last)) return;
    MissionClock then = wall_clock();
    const double gap = then.epoch_seconds - static_cast<double>(last);
    then.epoch_seconds = static_cast<double>(last);
    say(fmt::format(
        "did not end in order: it was there last at {}{}. Runs of then have lost their robots here",
        print(then), gap > 0.0 ? fmt::format(", {:.0f} s ago", gap) : ""));
  }
  void note() {
    const double now = steady_seconds();
    if (file_.empty() || now < next_) return;
    next_ = now + kApart;
    std::error_code failure;
    std::filesystem::create_directories(std::filesystem::path(file_).parent_path(), failure);
    // Where that can't be written the agent does all the rest.
    static_cast<void>(write_file(file_, fmt::format("{:.0f}\n", wall_clock().epoch_seconds)));
  }
  void end() const {
    std::error_code failure;
    if (!file_.empty()) std::filesystem::remove(file_, failure);
  }

 private:
  static constexpr double kApart = 10.0;  // [s]
  std::string file_;
  double next_ = 0.0;
};

}  // namespace

int agent(const AgentOptions& options) {
  agents::AgentSettings settings;
  settings.network = network_of(options.network);
  settings.name = options.name.empty() ? agents::machine_name() : options.name;
  settings.sources = program_sources("", permission_to_carry(options));
  settings.sources.limits = options.limits;
  settings.stop_file = kept_file(settings.network.fleet, settings.name, "stop");
  settings.tell = say;
  settings.tell_ready = [&] {
    say(fmt::format("agent `{}` of fleet `{}`, {}: waits for runs", settings.name, settings.network.fleet,
                    options.network.interface_name.empty()
                        ? "which nothing outside of this machine can reach"
                        : fmt::format("reachable over {}", options.network.interface_name)));
    if (!options.network.interface_name.empty())
      fmt::print(stderr, "mlab agent: warning: whoever reaches this network can have robots computed here\n");
  };
  note_interrupts();
  std::stop_source stop;
  LastSeen last_seen(kept_file(settings.network.fleet, settings.name, "seen"));
  std::atomic<bool> is_ready = false;
  const auto tell_ready = settings.tell_ready;
  settings.tell_ready = [&] {
    tell_ready();
    last_seen.tell_gap();
    is_ready = true;  // the name is this one's
  };
  const std::jthread watch([&](const std::stop_token& over) {
    while (!over.stop_requested() && !was_interrupted()) {
      if (is_ready) last_seen.note();
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    stop.request_stop();
  });
  if (const auto problem = agents::serve_as_agent(settings, stop.get_token())) {
    fmt::print(stderr, "mlab agent: {}\n", *problem);
    return kBadInput;
  }
  say("has left the fleet");
  last_seen.end();
  return kDone;
}

}  // namespace mlab::cli
