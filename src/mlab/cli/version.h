#pragma once

namespace mlab::cli {

inline constexpr const char* kVersion = MLAB_VERSION;  // of the CMake project

}  // namespace mlab::cli
