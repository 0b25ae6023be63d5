#include "mlab/console/past/condition.h"

#include <utility>

namespace mlab::console {

std::expected<Condition, std::string> Condition::parse(std::string_view text) {
  Breakpoint wanted;
  wanted.set_sentence(std::string(text));
  Condition out;
  std::string problem;
  if (out.halts_.set(wanted, problem) == 0) return std::unexpected(std::move(problem));
  return out;
}

std::optional<std::string> Condition::why_never(const run::MissionRun& run) const {
  BreakpointTable table = halts_;
  table.begin(&run);
  Breakpoints told;
  table.encode(told);
  const std::string& why = told.breakpoints(0).error();
  return why.empty() ? std::nullopt : std::optional(why);
}

std::optional<Condition::Met> Condition::look(const run::MissionRun& run) {
  Halted halted;
  halts_.look(run, halted);
  if (halted.hits().empty()) return std::nullopt;
  return Met{halted.hits(0).robot(), halted.hits(0).text()};
}

}  // namespace mlab::console
