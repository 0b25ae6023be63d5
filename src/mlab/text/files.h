#pragma once

#include <functional>
#include <string>

#include "mlab/text/diagnostic.h"

namespace mlab::text {

/// How the languages come by the files that a text names. The ordinary one is `files_on_disk`; an editor
/// gives one of its own, so that texts being edited are read instead of the files, and nothing else is read
/// at all.
struct Files {
  /// Whether `read` could give something. Only regular files count, so that a name like `/dev/stdin` never
  /// makes a reader wait.
  std::function<bool(const std::string& path)> is_file;
  /// The text, its source named by the path. @errors as `read_source`
  std::function<Result<SourcePtr>(const std::string& path)> read;
  /// How a file begins, at least a kilobyte of it where it has so many; empty where it can't be read. None
  /// where nobody asks what kinds of files there are.
  std::function<std::string(const std::string& path)> beginning;
};

const Files& files_on_disk();

}  // namespace mlab::text
