#include "mlab/mission/failsafe.h"

#include <fmt/core.h>

namespace mlab::mission {

std::string words_of(const Failsafe& failsafe) {
  const FailsafeConditionInfo& condition = info(failsafe.condition);
  std::string out = "FAILSAFE ";
  if (!failsafe.type_name.empty()) out += fmt::format("FOR {} ", failsafe.type_name);
  out += condition.word;
  if (condition.has_fence) out += fmt::format(" {}", failsafe.fence_name);
  if (condition.has_share) out += fmt::format(" BELOW {:g}%", 100.0 * failsafe.share);
  if (condition.may_last) out += fmt::format(" AFTER {:g}", failsafe.seconds);
  return out + fmt::format(" {}", info(failsafe.action).word);
}

}  // namespace mlab::mission
