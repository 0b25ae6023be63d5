#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "mlab/console.pb.h"
#include "mlab/console/published/channel.h"
#include "mlab/console/roles.h"

namespace mlab::console {

/// What a request is answered with; an error is one sentence.
using Answered = std::optional<std::string>;

/// Who made a request. Only as long as the request is being answered.
struct Sender {
  Channel& channel;
  const Roles::Client& client;
};

/// Seconds of a clock that does not go back.
inline double wall_time() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace mlab::console
