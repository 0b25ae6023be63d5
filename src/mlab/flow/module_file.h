#pragma once

#include <expected>
#include <span>
#include <string>

#include "mlab/flow/module.h"

namespace mlab::flow {

/// Loads a shared library with procedures into this process, which runs code of it (constructors of static
/// objects) at once. It stays loaded. For processes in a cell only: `mlab` itself never calls this.
///
/// @return  its behaviors, which live as long as the process
/// @errors  a sentence for a person: no such file, no library with procedures, made with other headers
std::expected<std::span<const Behavior* const>, std::string> open_module(const std::string& file);

}  // namespace mlab::flow
