#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mlab/presence.pb.h"

namespace mlab::agents {

/// One pull of the emergency stop. Each has an identity of its own, which its release names.
struct Pull {
  std::uint64_t id = 0;      ///< at random; 0: older agents call so what they could not read
  std::uint64_t number = 0;  ///< later ones have higher ones; of a pull that was released: of its release
  std::string by;            ///< who pulled it, or released it, for people
};

/// More pulls are not kept: those with the highest numbers are. One whose release is forgotten would stop the
/// fleet again, if there is still somebody who has not heard of that.
inline constexpr std::size_t kMostPulls = 32;

/// What somebody who hears of a state learns by it.
enum class Learnt : std::uint8_t {
  kNothing,
  kSomething,  ///< that a pull was released, at least
  kStop,       ///< a pull that stands
};

/// The emergency stop of a fleet, as somebody knows it: it is engaged where any pull stands that nobody has
/// released. All come to know the same, in whatever order they hear of it. A release ends what whoever
/// released it knew of, and nothing else, whenever it is heard.
struct StopState {
  /// Above those of all changes that are known. Older agents know no sets of pulls, and believe the state
  /// with the highest number. 0: there has been none.
  std::uint64_t number = 0;
  std::vector<Pull> standing;  ///< by number; none of them is in `released`
  std::vector<Pull> released;  ///< by number

  bool is_engaged() const { return !standing.empty(); }
  /// Who did what was done last, for people.
  std::string by() const;
  /// Takes over what somebody else knows.
  Learnt learn(const StopState& heard);
};

/// The state that a person makes of the one before by pulling it, also where it is engaged already, and by
/// releasing all pulls that are known.
StopState pulled(StopState before, std::string by);
StopState released(StopState before, const std::string& by);

void encode(const StopState& state, wire::EmergencyStop& out);
/// Nothing where it is nonsense; text is fit for people.
std::optional<StopState> decode(const wire::EmergencyStop& message);
std::optional<StopState> decode(std::string_view message);

/// Whether an agent that says this does what is wanted: where it is to stand it knows of all those pulls,
/// where it is to go on of their release.
bool has_confirmed(const wire::EmergencyStop& said, const StopState& wanted);

/// Where an agent keeps it, so that it outlives the agent.
class StopFile {
 public:
  /// @param path  empty: it can't be kept
  explicit StopFile(std::string path) : path_(std::move(path)) {}
  /// What was kept last; one that can't be read counts as engaged, and by whom says why.
  StopState read() const;
  /// On the disk when this comes back. @errors  a sentence; what was kept before is left, and nothing else
  std::optional<std::string> write(const StopState& state) const;
  bool is_there() const;
  /// Where there is one.
  void remove() const;
  /// Why it will not outlive the agent, as far as that can be known before; nothing: it will. Tries to write
  /// beside it.
  std::optional<std::string> why_not_kept() const;

 private:
  std::optional<std::string> write_beside(const std::string& bytes) const;
  std::string fresh() const { return path_ + ".new"; }

  std::string path_;
};

}  // namespace mlab::agents
