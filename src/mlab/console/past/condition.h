#pragma once

#include <cstdint>
#include <expected>
#include <optional>
#include <string>
#include <string_view>

#include "mlab/console/run/breakpoints.h"
#include "mlab/run/mission_run.h"

namespace mlab::console {

/// What moments of a run are searched for by: a `Sentence`, true when a breakpoint of the same would halt the
/// run.
class Condition {
 public:
  /// @errors  a sentence: what was seen, and what is expected
  static std::expected<Condition, std::string> parse(std::string_view text);
  /// Why it can never be true of that run, as a sentence.
  std::optional<std::string> why_never(const run::MissionRun& run) const;

  /// Somebody of whom it is true now, and was not when this was called last.
  struct Met {
    std::uint32_t robot = 0;
    std::string text;  ///< as a sentence
  };
  std::optional<Met> look(const run::MissionRun& run);
  /// The next look only notes how it stands.
  void forget() { halts_.change(nullptr); }

 private:
  BreakpointTable halts_;  // that alone
};

}  // namespace mlab::console
