// Files of percepts: any bytes are refused with a sentence, or their robots can be stepped through to the
// end.

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "mlab/recording/recorded_binding.h"

namespace {

using namespace mlab;

void step_through(recording::RecordedBinding& bodies, const std::vector<std::uint32_t>& robots) {
  std::vector<binding::BodyIndex> given;
  for (const std::uint32_t robot : robots) {
    binding::BodySetup setup;
    setup.robot = {robot};
    if (const auto placement = bodies.embody(setup)) given.push_back(placement->body);
  }
  const percept::Needs needs;
  const std::vector<percept::Action> actions(given.size());
  for (int cycle = 0; cycle < 20; ++cycle) {
    std::vector<binding::Ailment> ailments;
    bodies.health(ailments);
    for (const binding::BodyIndex body : given) {
      percept::Percepts percepts;
      const binding::Sensing sensing{body, &needs, &percepts};
      bodies.percepts({&sensing, 1}, 0);
    }
    bodies.carry_out(actions, 0.1);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const int file = ::memfd_create("percepts", 0);
  if (file < 0) return 0;
  if (::write(file, data, size) == static_cast<ssize_t>(size)) {
    auto opened = recording::PerceptsReader::open("/proc/self/fd/" + std::to_string(file));
    if (opened) {
      std::vector<std::uint32_t> robots;
      for (const wire::RecordedBody& body : (*opened)->bodies()) robots.push_back(body.robot());
      robots.resize(std::min<std::size_t>(robots.size(), 16));
      recording::RecordedBinding bodies(std::move(*opened), 1);
      step_through(bodies, robots);
    }
  }
  ::close(file);
  return 0;
}
