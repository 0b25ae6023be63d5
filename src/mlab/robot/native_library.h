#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <span>

#include "mlab/flow/library.h"
#include "mlab/lang/cnl/signatures.h"
#include "mlab/lang/cnl/tree.h"
#include "mlab/robot/robot_program.h"
#include "mlab/text/diagnostic.h"

namespace mlab::robot {

/// The component library, and behind it the procedures of these files, compiled and loaded.
/// @return  nothing where they can't be, which was said
std::optional<flow::Library> library_with(std::span<const std::shared_ptr<const cnl::Tree>> files,
                                          const ProgramSources& sources, text::Diagnostics& sink);

/// What a check needs to know of them: nothing of the files is run.
struct CheckedLibrary {
  flow::Library library;
  std::deque<cnl::Signatures> signatures;  ///< the library points into them
};

/// Checks the C++ of the files, where there is a compiler's worth of headers, and takes what their procedures
/// say of themselves.
std::unique_ptr<CheckedLibrary> checked_library_with(std::span<const std::shared_ptr<const cnl::Tree>> files,
                                                     const ProgramSources& sources, text::Diagnostics& sink);

}  // namespace mlab::robot
