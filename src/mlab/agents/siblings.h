#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/agents/roster.h"
#include "mlab/agents/stop_state.h"
#include "mlab/dds/network.h"

/// Agents of one machine do not meet on its network, where fifty of them would be busy with nothing but each
/// other. What they have to tell each other, each learns from what the others keep on the disk beside it:
///
///     FLEET@NAME.stop  the emergency stop as it knows it (StopFile); none: it has nothing to tell
///     FLEET@NAME.seen  when it was there last, [s] since 1970, and its company (`company_of`); noted anew at
///                      least every kSeenEvery, and removed when it ends in order

namespace mlab::agents {

/// How often an agent notes that it is there.
inline constexpr std::chrono::seconds kSeenEvery(10);

/// Who can tell each other something this way: agents of one machine as the network sees it, on one
/// interface, and in a secured fleet of one authority. So nothing that strangers say in a fleet of the same
/// name that is not secured gets into one that is.
std::string company_of(const dds::Network& network);

/// Another agent of this machine.
struct Sibling {
  std::string name;
  bool is_there = false;    ///< false: it is stopped, or did not end in order
  Clock::time_point heard;  ///< when it was there last, to kSeenEvery
  StopState stop;           ///< as far as it keeps one
};

/// Those of one user, fleet and company. One thread at a time.
class Siblings {
 public:
  /// @param stop_file  of the agent that asks; empty, or of another name: it has none
  Siblings(const std::string& stop_file, std::string company);
  /// All of them, for who is none.
  /// @param folder  where they keep that; empty: there is nobody
  Siblings(std::filesystem::path folder, const std::string& fleet, std::string company);

  /// Looks at what has changed; to be called twice a second. By name; who has ended in order is left out.
  const std::vector<Sibling>& look();
  /// As they were at the last look.
  const std::vector<Sibling>& all() const { return all_; }

 private:
  /// By which a file is known to be as it was.
  struct Stamp {
    std::uint64_t file = 0;
    std::filesystem::file_time_type written;
    friend bool operator==(const Stamp&, const Stamp&) = default;
  };
  struct Known {
    std::string company;
    Stamp seen;
    Stamp stop;
    Sibling sibling;
  };

  static Stamp stamp_of(const std::filesystem::path& file);
  void look_into_folder();
  void look_who_is_there(Clock::time_point now);
  void look_at_company(const std::string& name, Known& known) const;
  void look_at_stop(const std::string& name, Known& known) const;
  std::filesystem::path file(const std::string& name, std::string_view what) const;

  std::filesystem::path folder_;  // empty: there is nobody
  std::string before_;            // in front of a sibling's name
  std::string own_;
  std::string company_;
  Stamp folder_was_;
  int looks_left_ = 0;  // into the folder, which may have changed again within the same tick of its clock
  Clock::time_point next_roll_call_;
  std::map<std::string, Known> known_;
  std::vector<Sibling> all_;
};

}  // namespace mlab::agents
