#include "mlab/cli/fleet_member.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <expected>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <stop_token>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/core.h>

#include "mlab/agents/ending_watchdog.h"
#include "mlab/agents/siblings.h"
#include "mlab/cli/clock.h"
#include "mlab/cli/fleet_network.h"
#include "mlab/cli/interrupt.h"
#include "mlab/cli/output.h"
#include "mlab/cli/places.h"
#include "mlab/keys/identity.h"

namespace mlab::cli {
namespace {

// A line of the agent's log, at once.
void print_line(const std::string& line) {
  write_output_now(fmt::format("{}  {}\n", print(wall_clock()), line));
}

/// Holds a name in a fleet for one agent of this user's on this machine, whatever networks others are on that
/// would have it, too, and whom it may never hear: all of them would keep their emergency stop in one file.
class NameHold {
 public:
  /// @param file  empty, or it can't be made: the name is nobody's
  explicit NameHold(const std::string& file) {
    if (file.empty()) return;
    std::error_code failure;
    std::filesystem::create_directories(std::filesystem::path(file).parent_path(), failure);
    descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0600);
    if (descriptor_ < 0) return;
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) {
      note_process();
    } else if (errno == EWOULDBLOCK) {
      is_taken_ = true;
      std::ifstream(file) >> holder_;
    }
  }
  NameHold(const NameHold&) = delete;
  NameHold& operator=(const NameHold&) = delete;
  ~NameHold() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

  bool is_taken() const { return is_taken_; }
  /// Process that has it; 0: it has not said so.
  long holder() const { return holder_; }

 private:
  // For people: where it can't be written the lock counts all the same.
  void note_process() const {
    const std::string text = fmt::format("{}\n", ::getpid());
    if (::ftruncate(descriptor_, 0) != 0) return;
    [[maybe_unused]] const ssize_t count = ::pwrite(descriptor_, text.data(), text.size(), 0);
  }

  int descriptor_ = -1;
  bool is_taken_ = false;
  long holder_ = 0;
};

/// When an agent was there last, on the disk: an agent that did not end in order, because its machine had no
/// power say, tells of it when it is back. Other agents of the machine see by it who is there (siblings.h).
class LastSeen {
 public:
  /// @param file  empty: it is not kept
  explicit LastSeen(std::string file) : file_(std::move(file)) {}

  /// Whom it tells something; while nobody notes.
  void set_company(std::string company) { company_ = std::move(company); }

  void tell_gap(agents::AgentLog& log) const {
    std::ifstream stream(file_);
    std::int64_t last = 0;
    if (file_.empty() || !(stream >> last)) return;
    MissionClock then = wall_clock();
    const double gap = then.epoch_seconds - static_cast<double>(last);
    then.epoch_seconds = static_cast<double>(last);
    log.add(
        fmt::format("did not end in order: it was there last at about {}{} (noted every {:.0f} s). Runs of "
                    "then have lost their robots here",
                    print(then), gap > 0.0 ? fmt::format(", {:.0f} s ago", gap) : "", kApart));
  }
  void note() {
    const double now = steady_seconds();
    if (file_.empty() || (now < next_ && !is_wanted_.exchange(false))) return;
    next_ = now + kApart;
    std::error_code failure;
    std::filesystem::create_directories(std::filesystem::path(file_).parent_path(), failure);
    // Where that can't be written the agent does all the rest.
    static_cast<void>(write_file(file_, fmt::format("{:.0f} {}\n", wall_clock().epoch_seconds, company_)));
  }
  /// At the next `note`, from any thread.
  void want_note() { is_wanted_ = true; }
  void end() const {
    std::error_code failure;
    if (!file_.empty()) std::filesystem::remove(file_, failure);
  }

 private:
  static constexpr double kApart = std::chrono::duration<double>(agents::kSeenEvery).count();  // [s]
  std::string file_;
  std::string company_;
  double next_ = 0.0;
  std::atomic<bool> is_wanted_ = false;
};

// How others reach it, and who they may be.
std::string reach_of(const NetworkOptions& network) {
  if (network.interface_name.empty()) return "which nothing outside of this machine can reach";
  return fmt::format("reachable over {}{}", network.interface_name,
                     network.is_secure ? " by those who have a key of the fleet" : "");
}

void tell_ready(const agents::AgentSettings& settings, const NetworkOptions& network,
                const MemberWords& words) {
  const std::string what =
      settings.offered.empty() ? "" : fmt::format(", which carries robots of {} only", settings.offered);
  settings.log->add(fmt::format("{} `{}` of {}fleet `{}`{}, {}: {}", words.kind, settings.name,
                                network.is_secure ? "the secured " : "", settings.network.fleet, what,
                                reach_of(network), words.does));
  if (const auto& identity = settings.network.security) {
    if (const std::string words_of_end = keys::running_out(identity->end); !words_of_end.empty())
      settings.log->add(
          fmt::format("warning: the identity by which it belongs to the fleet {}", words_of_end));
  }
  if (!network.interface_name.empty() && !network.is_secure)
    fmt::print(stderr, "{}: warning: whoever reaches this network {}\n", words.command, words.warning);
}

/// Ends what an agent does when it is interrupted, when its own identity runs out, or when somebody was
/// withdrawn from its fleet: who has joined knows only of those who were withdrawn before.
class Watch {
 public:
  /// @param end  of its identity, by `steady_seconds`
  Watch(LastSeen& last_seen, keys::WithdrawalWatch& withdrawals, double end)
      : last_seen_(last_seen),
        withdrawals_(withdrawals),
        end_(end),
        thread_([this](const std::stop_token& over) {
          while (!over.stop_requested() && !is_over())
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
          stop_.request_stop();
        }) {}

  std::stop_token token() const { return stop_.get_token(); }
  /// The name is this agent's.
  void joined() { is_ready_ = true; }

 private:
  static constexpr double kApart = 1.0;  // [s]

  bool is_over() {
    if (is_ready_) last_seen_.note();
    const double now = steady_seconds();
    if (was_interrupted() || now < next_) return was_interrupted();
    next_ = now + kApart;
    return withdrawals_.has_changed() || now >= end_;
  }

  LastSeen& last_seen_;
  keys::WithdrawalWatch& withdrawals_;
  double end_;
  std::stop_source stop_;
  std::atomic<bool> is_ready_ = false;
  double next_ = 0.0;
  std::jthread thread_;
};

/// By `steady_seconds`: that of the participant, which reckons so, too.
double end_of_identity(const dds::Network& network) {
  if (!network.security) return std::numeric_limits<double>::infinity();
  return steady_seconds() + static_cast<double>(dds::time_left(*network.security).count());
}

/// As `network_of`, once this machine's clock is so far that the identity counts: it may be set only some
/// seconds after the machine was switched on.
std::expected<dds::Network, std::string> network_with_time(const NetworkOptions& options,
                                                           const MemberWords& words, agents::AgentLog& log) {
  for (bool is_said = false;; is_said = true) {
    auto out = network_of(options);
    if (out || was_interrupted() || !keys::counts_only_later(identity_folder(options))) return out;
    if (!is_said) fmt::print(stderr, "{}: {}\n", words.command, out.error());
    if (!is_said) log.add("waits until this machine's clock is set");
    std::this_thread::sleep_for(std::chrono::milliseconds(250));
  }
}

int serve(agents::AgentSettings settings, const NetworkOptions& options, const MemberWords& words) {
  LastSeen last_seen(kept_file(fleet_of(options.fleet), settings.name, "seen"));
  keys::WithdrawalWatch withdrawals(identity_folder(options));
  settings.tell_stop = [&] { last_seen.want_note(); };
  for (bool is_first = true; !was_interrupted(); is_first = false) {
    const auto network = network_with_time(options, words, *settings.log);
    if (!network && was_interrupted()) return kDone;
    if (!network) {
      fmt::print(stderr, "{}: {}\n", words.command, network.error());
      // Withdrawn, or run out: it leaves on purpose, and nobody is to miss it.
      if (!is_first) {
        settings.log->add(network.error());
        last_seen.end();
      }
      return kBadInput;
    }
    // What could not be read by the clock of before is no news.
    if (is_first) withdrawals = keys::WithdrawalWatch(identity_folder(options));
    if (!is_first) settings.log->add("somebody was withdrawn from the fleet: joins it anew");
    settings.network = *network;
    last_seen.set_company(agents::company_of(*network));
    Watch watch(last_seen, withdrawals, end_of_identity(*network));
    // Who runs it starts one again that has failed.
    const agents::EndingWatchdog watchdog(words.command, [over = watch.token()] {
      const std::optional<int> status = was_interrupted() ? kDone : kFailed;
      return was_interrupted() || over.stop_requested() ? status : std::nullopt;
    });
    settings.must_stand = [&] { return watchdog.is_late(); };
    settings.tell_ready = [&] {
      tell_ready(settings, options, words);
      if (is_first) last_seen.tell_gap(*settings.log);
      watch.joined();
    };
    if (const auto problem = agents::serve_as_agent(settings, watch.token())) {
      fmt::print(stderr, "{}: {}\n", words.command, *problem);
      return kBadInput;
    }
  }
  settings.log->add("has left the fleet");
  last_seen.end();
  return kDone;
}

}  // namespace

agents::AgentSettings member_settings(const NetworkOptions& network, const std::string& name) {
  agents::AgentSettings out;
  out.name = name.empty() ? agents::machine_name() : name;
  out.stop_file = kept_file(fleet_of(network.fleet), out.name, "stop");
  out.log = std::make_shared<agents::AgentLog>(print_line);
  return out;
}

int take_part(agents::AgentSettings settings, const NetworkOptions& options, const MemberWords& words) {
  note_interrupts();
  const NameHold name(kept_file(fleet_of(options.fleet), settings.name, "lock"));
  if (!name.is_taken()) return serve(std::move(settings), options, words);
  fmt::print(stderr,
             "{}: `{}` of the fleet `{}` runs on this machine already{}: end it, or choose another --name\n",
             words.command, settings.name, fleet_of(options.fleet),
             name.holder() > 0 ? fmt::format(" (process {})", name.holder()) : "");
  return kBadInput;
}

}  // namespace mlab::cli
