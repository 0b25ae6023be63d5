#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "mlab/presence.pb.h"

namespace mlab::agents {

/// The emergency stop of a fleet, as somebody knows it. Whoever changes it takes the next number, so that all
/// come to agree, in whatever order they hear of it, also where two do so at once.
struct StopState {
  std::uint64_t number = 0;  ///< 0: there has been none
  bool is_engaged = false;
  std::string by;          ///< who did that, for people
  std::uint64_t pull = 0;  ///< which pull of it this is, or which one was released

  /// It is in force where both are known.
  bool overrides(const StopState& other) const {
    if (number != other.number) return number > other.number;
    return is_engaged != other.is_engaged ? is_engaged : is_engaged && pull > other.pull;
  }
  bool is_same(const StopState& other) const {
    return number == other.number && is_engaged == other.is_engaged && pull == other.pull;
  }
};

/// The state that a person makes of the one before by pulling it, and by releasing it.
StopState pulled(const StopState& before, std::string by);
StopState released(const StopState& before, std::string by);

void encode(const StopState& state, wire::EmergencyStop& out);
/// Nothing where it is nonsense; text is fit for people.
std::optional<StopState> decode(const wire::EmergencyStop& message);
std::optional<StopState> decode(std::string_view message);

/// Where an agent keeps it, so that it outlives the agent.
class StopFile {
 public:
  /// @param path  empty: it is not kept
  explicit StopFile(std::string path) : path_(std::move(path)) {}
  /// What was kept last; one that can't be read counts as engaged, and by whom says why.
  StopState read() const;
  /// On the disk when this comes back. @errors  a sentence
  std::optional<std::string> write(const StopState& state) const;
  /// Where there is one.
  void remove() const;
  /// Why it will not outlive the agent, as far as that can be known before; nothing: it will.
  std::optional<std::string> why_not_kept() const;

 private:
  std::string path_;
};

}  // namespace mlab::agents
