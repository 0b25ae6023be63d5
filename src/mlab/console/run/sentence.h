#pragma once

#include <cstdint>
#include <expected>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mlab/console.pb.h"
#include "mlab/fleet/fleet_robot.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

bool compares(double a, Breakpoint::Condition::Comparison how, double b);

/// Something that is true of a robot at some moments of a run, as a person writes it:
///
///     robot 3 nearer than 2 m to an obstacle
///     any robot farther than 50 m from PP-Charlie
///     any robot in contact
///     robot 2 in state Return
///     robot 2 speed > 1.5
///     any robot Forward.magnitude <= 0.1
///     any robot active_task = moveto
///     robot 2 movement goes from Searching to Return
///
/// What it is near to is an obstacle (edge to edge, walls as well), a robot, its goal, or a place of the map
/// (its middle). What is compared is one of the words of Series.Quantity with hyphens, a heading in degrees,
/// or a port. What it says of ports and transitions is what breakpoints are made of; the sentence that tells
/// of a halt at a transition is such a sentence.
class Sentence {
 public:
  static constexpr std::string_view kExamples =
      "`robot 3 nearer than 2 m to an obstacle`, `any robot in contact`, `robot 2 in state Return`, "
      "`robot 2 speed > 1.5`";

  /// @errors  a sentence: what was seen, and what is expected
  static std::expected<Sentence, std::string> parse(std::string_view text);
  /// What it says of a port or a transition: who knows breakpoints looks for it. Else `look` does.
  const std::optional<Breakpoint>& breakpoint() const { return breakpoint_; }
  /// Why it can never be true of that run, as far as robots, places, states and numbers go.
  std::optional<std::string> why_never(const run::MissionRun& run) const;

  struct Met {
    std::uint32_t robot = 0;
    std::string text;  ///< as a sentence
  };
  /// Of whom it is true now, and was not when this was called last.
  std::vector<Met> look(const run::MissionRun& run);
  /// The next look takes all for untrue before.
  void forget() { standing_.clear(); }

 private:
  /// A sentence where it is true.
  using Test =
      std::function<std::optional<std::string>(const run::MissionRun& run, const fleet::FleetRobot& robot)>;
  struct Reader;

  std::uint32_t robot_ = 0;  // 0: any
  std::string place_;        // of the map, that it names
  std::string state_;        // that it names, which a robot is to come into
  bool is_contact_ = false;
  Test test_;
  std::optional<Breakpoint> breakpoint_;  // in place of a test
  struct Standing {
    bool was_true = false;
    std::uint32_t contacts = 0;
  };
  std::map<std::uint32_t, Standing> standing_;
};

}  // namespace mlab::console
