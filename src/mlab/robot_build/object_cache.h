#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mlab/lang/cnl/compiler_process.h"

namespace mlab::robot_build {

/// Objects by the content of what they were made from: the text, the flags, the compiler, and all headers.
class ObjectCache {
 public:
  /// @param folder    is made where it is missing
  /// @param compiler  path of the program
  ObjectCache(std::string folder, std::string compiler, std::string version, cnl::ProcessLimits limits);

  struct Object {
    std::string path;  ///< empty: it could not be made
    bool was_compiled = false;
    cnl::ProcessResult compiler;  ///< where it was compiled now; its messages in any case
    std::string failure;          ///< of the cache itself; empty: none
  };
  /// Gives the object of a text, compiled where it has to be. May be called from several threads.
  Object get(const std::string& name, const std::string& text, const std::vector<std::string>& flags) const;

  const std::string& folder() const { return folder_; }

 private:
  std::string path_of(const std::string& key) const;

  std::string folder_;
  std::string compiler_;
  std::string version_;
  cnl::ProcessLimits limits_;
};

}  // namespace mlab::robot_build
