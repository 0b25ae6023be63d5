#pragma once

#include "mlab/lang/cnl/cpp_writer.h"
#include "mlab/lang/cnl/tree.h"
#include "mlab/lang/cnl/types.h"

namespace mlab::cnl {

/// C++ of one procedure, without the namespace around it: its sections as functions, its `fire`, and the
/// function `behavior()` with its descriptor.
void write_procedure(CppWriter& out, const Procedure& procedure);

}  // namespace mlab::cnl
