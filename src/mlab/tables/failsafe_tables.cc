#include "mlab/tables/failsafe_tables.h"

#include <fmt/core.h>

#include "mlab/mission/failsafe.h"

namespace mlab::tables {

std::string failsafe_condition_documentation() {
  std::string out = "| condition | without AFTER | it holds while |\n|---|---|---|\n";
  for (const mission::FailsafeConditionInfo& one : mission::kFailsafeConditions) {
    const std::string_view operand = one.has_fence ? " boundary" : one.has_share ? " BELOW share%" : "";
    out += fmt::format("| `{}{}{}` | {} | {} |\n", one.word, operand, one.may_last ? " [AFTER seconds]" : "",
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
