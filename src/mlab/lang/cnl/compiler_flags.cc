#include "mlab/lang/cnl/compiler_flags.h"

namespace mlab::cnl {

std::vector<std::string> compiler_flags() {
  return {"-std=c++23",
          "-ffp-contract=off",
          "-fsigned-char",    // as ours
          "-fno-exceptions",  // nobody would catch one: the process would end
          "-Wall",
          "-fno-diagnostics-show-caret",
          "-fdiagnostics-color=never",
          "-fdiagnostics-column-unit=byte",
          "-fmax-errors=50"};
}

std::vector<std::string> procedure_flags() {
  std::vector<std::string> flags = compiler_flags();
  flags.insert(flags.end(), {"-O2", "-fno-math-errno", "-fno-tree-slp-vectorize"});
  return flags;
}

}  // namespace mlab::cnl
