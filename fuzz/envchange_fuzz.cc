// Any bytes as an environment-change file; its events are carried out, in a world small enough to be quick.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "mlab/lang/envchange/envchange.h"
#include "mlab/overlay/environment_change.h"
#include "mlab/text/diagnostic.h"

// libFuzzer's name, not ours.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {  // NOLINT(readability-identifier-naming)
  const std::string text(reinterpret_cast<const char*>(data), size);
  mlab::text::Diagnostics sink;
  const auto changes = mlab::envchange::parse(std::make_shared<const mlab::text::Source>("fuzz.env", text),
                                              {10.0, 20.0}, sink);
  if (changes.has_value() == sink.has_errors()) std::abort();
  mlab::text::render(sink);
  if (!changes) return 0;
  std::vector<mlab::overlay::ObstacleDisc> obstacles;
  constexpr std::size_t kMostEvents = 20;
  constexpr std::size_t kMostObstacles = 1000;
  for (std::size_t i = 0; i < changes->events.size() && i < kMostEvents && obstacles.size() < kMostObstacles;
       ++i) {
    mlab::overlay::apply(changes->events[i], i, 1, {}, obstacles);
  }
  for (const auto& d : obstacles) {
    if (!(d.radius > 0.0)) std::abort();
  }
  return 0;
}
