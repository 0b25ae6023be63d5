#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mlab::console {

/// A machine that may carry robots of the run, as it was when it said something last. Texts are fit for
/// people.
struct WatchedMachine {
  enum class State : std::uint8_t {
    kThere,
    kSilent,  ///< nothing is heard of it
    kGone,    ///< it has left, or is not waited for any more
  };
  /// The way there and back, as measured from here.
  struct Link {
    double round_trip = 0.0;      ///< [s]
    double clock_offset = 0.0;    ///< of its wall clock; more than 0: ahead [s]
    double lost = 0.0;            ///< share of the questions that were not answered, 0..1
    bool is_clock_known = false;  ///< the offset is more than the measurement can be wrong by
  };
  std::string name;  ///< in the fleet
  std::string host;  ///< what the machine calls itself
  State state = State::kThere;
  double heard = 0.0;  ///< since it said something last [s]
  std::optional<Link> link;
  std::uint32_t robots = 0;  ///< that it carries, of all runs
  std::uint32_t runs = 0;    ///< whose robots they are
  double load = 0.0;         ///< processes that want to run there, mean of a minute
  std::uint32_t processors = 0;
  std::uint64_t free_memory = 0;  ///< that programs could have [bytes]
  double uptime = 0.0;            ///< since its agent began [s]
  std::string version;            ///< of missionlab
  bool is_stopped = false;        ///< the emergency stop holds there
  std::string not_kept;           ///< why it would forget that when started again; empty: it would not
  std::string offers;      ///< the executable whose robots it carries, and no others; empty: built from text
  std::string rival_host;  ///< another machine of the same name, which is left out; empty: there is none
  std::string vehicle;     ///< the kind of vehicle that it is; empty: it carries programs
};

/// Who is in the fleet of a run's robots, for people who look at its console. May be used by any thread.
class MachineWatch {
 public:
  MachineWatch() = default;
  MachineWatch(const MachineWatch&) = delete;
  MachineWatch& operator=(const MachineWatch&) = delete;
  virtual ~MachineWatch() = default;

  virtual std::string fleet() const = 0;
  /// What shows somebody where nobody is seen, a sentence for people.
  virtual std::string hint() const = 0;
  /// By name; also those that have gone. Comes back at once; links are measured as long as somebody asks.
  virtual std::vector<WatchedMachine> look() = 0;
};

}  // namespace mlab::console
