#pragma once

#include <string>

#include "mlab/study/definition.h"
#include "mlab/text/diagnostic.h"

namespace mlab::study {

/// True for the name of a file that defines a batch: `study.toml`.
bool is_study_file(const std::string& path);

/// Reads the definition of a batch, in TOML: the options of `mlab batch` as keys, and a table `[set]` of
/// values. Files that it names count from its own folder.
/// @param definition  what stands in the file is added to it
/// @return  false: there were errors, all in `sink`
bool read_study(const text::SourcePtr& source, Definition& definition, text::Diagnostics& sink);

}  // namespace mlab::study
