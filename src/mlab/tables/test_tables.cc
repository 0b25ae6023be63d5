#include "mlab/tables/test_tables.h"

#include <fmt/core.h>

#include "mlab/lang/cdl/test_percepts.h"

namespace mlab::tables {

std::string test_percept_documentation() {
  std::string out = "| percept | inputs | |\n|---|---|---|\n";
  for (const cdl::TestPerceptInfo& one : cdl::kTestPercepts) {
    std::string inputs;
    for (const cdl::TestInput& input : one.inputs)
      inputs += fmt::format("{}`{}`", inputs.empty() ? "" : ", ", input.name);
    out += fmt::format("| `{}` | {} | {}{} |\n", one.name, inputs, one.is_many ? "many: " : "", one.help);
  }
  return out;
}

}  // namespace mlab::tables
