#include "mlab/study/row.h"

#include <fmt/core.h>

namespace mlab::study {

std::string column(const NumberInfo& info) {
  return info.unit.empty() ? std::string(info.name) : fmt::format("{}_{}", info.name, info.unit);
}

}  // namespace mlab::study
