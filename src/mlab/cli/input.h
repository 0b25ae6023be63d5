#pragma once

#include <string>

#include "mlab/text/diagnostic.h"

namespace mlab::cli {

/// True where the command line names standard input.
inline bool is_standard_input(const std::string& file) {
  return file == "-";
}

/// A file that the command line names; `-` is standard input. Files that files name are read otherwise: there
/// `-` is a name like any other.
text::Result<text::SourcePtr> read_input(const std::string& file);

}  // namespace mlab::cli
