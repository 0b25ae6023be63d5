#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "mlab/console.pb.h"
#include "mlab/console/published/scene_encoder.h"
#include "mlab/history/history.h"

namespace mlab::console {

/// The documents of a mission as a recording holds them: its own text and its overlays, named relative to the
/// mission's folder.
class PastTexts {
 public:
  /// @param number  of the version, from 1
  PastTexts(const history::History& history, const wire::HistoryMission& version, std::uint64_t number);

  DocumentPlace place(const text::Place& place) const;
  const Documents& message() const { return message_; }

 private:
  std::map<std::string, std::string> names_;  // by name of the source
  Documents message_;
};

}  // namespace mlab::console
