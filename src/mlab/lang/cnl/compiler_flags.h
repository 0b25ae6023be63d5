#pragma once

#include <string>
#include <vector>

namespace mlab::cnl {

/// How g++ compiles what we write for it, wherever that runs: the language, numbers that are the same as in
/// our own code, and messages as `report_compiler_messages` reads them. Without optimisation, folders and
/// files.
std::vector<std::string> compiler_flags();

/// Likewise for procedures, which run in each cycle: optimised as the component library is
/// (`mlab_tune_if_in_cycle` in cmake/MlabModule.cmake).
std::vector<std::string> procedure_flags();

}  // namespace mlab::cnl
