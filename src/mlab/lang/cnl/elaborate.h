#pragma once

#include "mlab/flow/network.h"
#include "mlab/lang/cnl/tree.h"
#include "mlab/text/diagnostic.h"

namespace mlab::cnl {

/// The network that a file (with its includes) describes, for `flow` to build a program from. Historic
/// `DATABASE_DOUBLE|INT|BOOLEAN` nodes become parameters named by their key.
///
/// @errors  `node-named-like-procedure`, `bad-database-node`; everything about types and wiring is said where
/// the
///          program is built
flow::Network elaborate(const Tree& tree, text::Diagnostics& diagnostics);

}  // namespace mlab::cnl
