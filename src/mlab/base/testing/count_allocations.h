#pragma once

#include <cstddef>

namespace mlab::base {

/// How often this program asked for heap so far, on any thread. Only in programs that link
/// count_allocations.cc, which counts them: tests that say "no heap here".
std::size_t allocation_count();

}  // namespace mlab::base
