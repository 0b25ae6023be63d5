#pragma once

#include "source_tree.h"

namespace mlab::repo {

/// The `#include` lines in `src/mlab` and `library` that point upwards: at a module which the including one
/// must not know. Also names a module that the table of arrows does not have, so that a new one is placed on
/// purpose.
Findings upward_includes(const Tree& tree);

/// The `#include` lines of what is no test that name code of `testing/` folders.
Findings tests_in_the_product(const Tree& tree);

/// Lines in `src/mlab` that make a `cell::Permission`: only the command does, out of its options, and tests.
Findings foreign_permissions(const Tree& tree);

}  // namespace mlab::repo
