#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mlab/cell/policy.h"

namespace mlab::cnl {

/// How much of an author's folder a compiler may read.
enum class ProjectPart {
  kAll,
  kNone,     ///< the text came from elsewhere: nothing lies beside it
  kSources,  ///< by their endings. People who take part in a session write none of these (console, designer)
};

/// What a compiler may read besides itself and the headers of the system: the authors' headers.
struct CompilerFiles {
  std::vector<std::string>
      folders;  ///< of missionlab's headers, and whatever else is ours: all that is in them
  std::vector<std::string> projects;  ///< of authors: as `project_files`
  ProjectPart part = ProjectPart::kAll;
};

/// What may be read of an author's folder: what is in it, but nothing whose name begins with a dot (keys, the
/// environment, a version control's memory) and no link that leads out of it. Of a home folder, or one that
/// holds it, only the sources that lie in it directly: who has one file there did not open all the rest.
std::vector<std::string> project_files(const std::string& folder, ProjectPart part = ProjectPart::kAll);
/// Whether a file's name says that C++ may include it.
bool is_source(std::string_view path);

/// The cell that a compiler or linker works in: it reads the headers and libraries of the system and `files`,
/// starts its own parts, and writes into one folder.
///
/// @param program  path of the compiler
/// @param own      the folder that it writes into
cell::Policy compiler_policy(const std::string& program, const CompilerFiles& files, const std::string& own);

}  // namespace mlab::cnl
