#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "link.h"
#include "victim.h"

namespace mlab::network {

/// What is done to a process, when.
struct Strike {
  Duration at{0};           ///< since the beginning
  std::size_t victim = 0;   ///< which of those that there are
  bool is_stop = false;     ///< SIGSTOP, and SIGCONT after a while; else SIGKILL
  Duration stopped_for{0};  ///< the while
};

struct KillerSetup {
  std::uint64_t seed = 1;
  Duration span = std::chrono::seconds(1);  ///< within which all strikes begin
  std::size_t strikes = 1;
  bool kills = true;
  bool stops = true;
  Duration shortest_stop = std::chrono::milliseconds(100);
  Duration longest_stop = std::chrono::seconds(1);
};

/// In the order of their moments. The same for the same setup and number of victims; moments even over the
/// span, victims and kinds as likely as each other.
std::vector<Strike> planned_strikes(const KillerSetup& setup, std::size_t victims);

/// Strikes processes at moments of a seed while the test goes on, in a thread of its own; says its seed, and
/// of each strike what it did, on standard output. When it goes before its time it strikes no more, and
/// whoever is stopped goes on.
class Killer {
 public:
  Killer(const KillerSetup& setup, std::vector<Victim> victims);
  ~Killer();
  Killer(const Killer&) = delete;
  Killer& operator=(const Killer&) = delete;

  /// Waits until all has been done, and all that were stopped go on.
  void wait();
  /// What has been done so far, in words.
  std::vector<std::string> done() const;

 private:
  void work();
  /// @return  false: there is no time for more
  bool sleep_until(Time moment);
  void say(const std::string& text);

  const KillerSetup setup_;
  const std::vector<Victim> victims_;
  const std::vector<Strike> strikes_;
  const Time begin_;
  mutable std::mutex mutex_;  ///< of what follows
  std::condition_variable changed_;
  bool is_over_ = false;
  std::vector<std::string> done_;
  std::thread thread_;
};

}  // namespace mlab::network
