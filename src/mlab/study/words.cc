#include "mlab/study/words.h"

#include <algorithm>

#include <fmt/core.h>

namespace mlab::study {

std::string heading(const NumberInfo& info) {
  std::string out(info.name);
  std::ranges::replace(out, '_', ' ');
  return info.unit.empty() ? out : fmt::format("{} [{}]", out, info.unit);
}

}  // namespace mlab::study
