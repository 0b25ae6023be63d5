#include "mlab/tables/failsafe_tables.h"

#include <fmt/core.h>

#include "mlab/mission/failsafe.h"

namespace mlab::tables {

std::string failsafe_condition_documentation() {
  std::string out = "| condition | without AFTER | it holds while |\n|---|---|---|\n";
  for (const mission::FailsafeConditionInfo& one : mission::kFailsafeConditions) {
    out += fmt::format("| `{}{}{}` | {} | {} |\n", one.word, one.has_fence ? " boundary" : "",
                       one.may_last ? " [AFTER seconds]" : "",
                       one.may_last ? fmt::format("{:g} s", one.default_seconds) : "at once", one.help);
  }
  return out;
}

std::string failsafe_action_documentation() {
  std::string out = "| action | what becomes of the robot |\n|---|---|\n";
  for (const mission::FailsafeActionInfo& one : mission::kFailsafeActions)
    out += fmt::format("| `{}` | {} |\n", one.word, one.help);
  return out;
}

}  // namespace mlab::tables
