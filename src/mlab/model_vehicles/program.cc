#include "mlab/model_vehicles/program.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <thread>

#include <fmt/core.h>

#include "mlab/base/angle.h"
#include "mlab/lang/odl/odl.h"
#include "mlab/model_vehicles/pseudo_terminal.h"

namespace mlab::model_vehicles {
namespace {

constexpr auto kPeriod = std::chrono::milliseconds(20);
/// What the vehicle misses where the machine was busy for longer [s].
constexpr double kLongestStep = 0.1;

volatile std::sig_atomic_t has_to_end = 0;

void note_end(int) {
  has_to_end = 1;
}

}  // namespace

geom::Pose ProgramOptions::place() const {
  return {{x, y}, base::radians(heading_deg)};
}

void add_options(CLI::App& app, ProgramOptions& options) {
  app.add_option("--world", options.overlay, "what is around it: an overlay; without one there is nothing")
      ->type_name("FILE.odl");
  app.add_option("--x", options.x, "where it stands when it is switched on")->type_name("METRES");
  app.add_option("--y", options.y, "")->type_name("METRES");
  app.add_option("--heading", options.heading_deg, "counter-clockwise from east")->type_name("DEGREES");
  app.add_option("--seed", options.seed, "of all that is random; the same one gives the same noise")
      ->capture_default_str();
  app.add_option("--link", options.link, "a name for its line besides that of the pseudo-terminal")
      ->type_name("PATH");
}

bool read_world(const ProgramOptions& options, overlay::Overlay& into) {
  if (options.overlay.empty()) return true;
  text::Diagnostics sink;
  const bool is_read = odl::load_overlay(options.overlay, into, sink);
  std::fputs(text::render(sink).c_str(), stderr);
  return is_read;
}

int serve(ModelVehicle& vehicle, const ProgramOptions& options) {
  using Clock = std::chrono::steady_clock;
  std::signal(SIGINT, note_end);
  std::signal(SIGTERM, note_end);
  const auto line = PseudoTerminal::open(options.link);
  if (!line.has_value()) {
    fmt::print(stderr, "{}\n", line.error());
    return kFailed;
  }
  fmt::print("line: {}\n", options.link.empty() ? (*line)->path() : options.link);
  std::fflush(stdout);
  Clock::time_point before = Clock::now();
  Clock::time_point next = before;
  while (has_to_end == 0) {
    next = std::max(next + kPeriod, Clock::now() - kPeriod);
    std::this_thread::sleep_until(next);
    const Clock::time_point now = Clock::now();
    const double dt = std::chrono::duration<double>(now - before).count();
    before = now;
    vehicle.receive((*line)->read());
    if (dt > 0.0) (*line)->write(vehicle.step(std::min(dt, kLongestStep)));
  }
  return kDone;
}

}  // namespace mlab::model_vehicles
