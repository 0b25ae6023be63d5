#pragma once

#include <functional>
#include <string>
#include <utility>

#include "mlab/designer/session/desk.h"
#include "mlab/designer/session/mark_keeper.h"

namespace mlab::designer {

/// Whatever ends this process after an answer, what it answers is in the file system, or people are told that
/// it is not.
class Safekeeping {
 public:
  /// @param tell_not_kept  as DesignerSettings
  Safekeeping(Desk& desk, MarkKeeper& marks, std::function<void(const std::string& why)> tell_not_kept)
      : desk_(desk), marks_(marks), tell_not_kept_(std::move(tell_not_kept)) {}

  /// To be called after changes, before they are answered, and now and then.
  void keep();
  /// The same, and drafts are on the disk.
  void sync();
  /// Why something is not kept, as it was told last; empty: all is.
  const std::string& why_not() const { return not_kept_; }

 private:
  void tell();

  Desk& desk_;
  MarkKeeper& marks_;
  const std::function<void(const std::string& why)> tell_not_kept_;
  std::string not_kept_;
};

}  // namespace mlab::designer
