#pragma once

#include "source_tree.h"

namespace mlab::repo {

/// Paths of one person's machine and hosts of package registries: both are set-up, not source.
Findings machine_traces(const Tree& tree);

/// Sources past 600 lines. Each holds more than one idea.
Findings long_files(const Tree& tree);

/// Types in headers of `src/mlab`, of more than a few lines, that have a comment neither above nor inside.
Findings uncommented_types(const Tree& tree);

/// Modules (folders of `src/mlab` with a CMakeLists.txt) without a README.md, or with one past 30 lines.
Findings modules_without_readme(const Tree& tree);

/// Functions of <cmath> that are rounded otherwise on another processor, in what the product computes.
Findings unequal_arithmetic(const Tree& tree);

/// Headers that nothing keeps from being read twice.
Findings unguarded_headers(const Tree& tree);

}  // namespace mlab::repo
