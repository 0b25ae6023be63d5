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
  /// @param wall      of the cell that the compiler works in
  ObjectCache(std::string folder, std::string compiler, std::string version, cell::Wall wall,
              cnl::ProcessLimits limits);

  struct Object {
    std::string path;  ///< empty: it could not be made
    bool was_compiled = false;
    cnl::ProcessResult compiler;  ///< where it was compiled now; its messages in any case
    std::string failure;          ///< of the cache itself; empty: none
  };
  /// Gives the object of a text, compiled where it has to be. May be called from several threads.
  ///
  /// @param readable  what the compiler may read besides the headers of the system
  Object get(const std::string& name, const std::string& text, const std::vector<std::string>& flags,
             const cnl::CompilerFiles& readable) const;

  const std::string& folder() const { return folder_; }

 private:
  void compile(const std::string& key, const std::string& text, const std::vector<std::string>& flags,
               const cnl::CompilerFiles& readable, Object& out) const;
  std::string path_of(const std::string& key) const;

  std::string folder_;
  std::string compiler_;
  std::string version_;
  cell::Wall wall_;
  cnl::ProcessLimits limits_;
};

}  // namespace mlab::robot_build
