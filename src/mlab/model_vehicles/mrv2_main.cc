// mlab_mrv2_model: a Denning MRV-2 for who has none, on a pseudo-terminal.

#include <exception>
#include <numbers>

#include <fmt/core.h>

#include "mlab/base/angle.h"
#include "mlab/model_vehicles/mrv2_model.h"
#include "mlab/model_vehicles/program.h"

namespace mlab::model_vehicles {
namespace {

constexpr const char* kDescription =
    "A Denning MRV-2 that isn't there: a model of the vehicle behind a serial line, for tests and for who "
    "has\n"
    "none. It prints `line: PATH`; a device opened there meets what it would meet on the vehicle's own "
    "line.\n"
    "It runs until it is interrupted (Ctrl-C).";

/// The same in degrees, as people say them.
struct Degrees {
  double turn_rate_deg = 90.0;
  double beam_width_deg = 15.0;
  double glancing_deg = 25.0;
};

void add_vehicle_options(CLI::App& app, Mrv2Spec& spec, Degrees& degrees) {
  const CLI::Range share(0.0, 1.0);
  app.add_option("--max-speed", spec.max_speed, "that it drives at most [m/s]")
      ->check(CLI::Range(0.01, 10.0))
      ->capture_default_str();
  app.add_option("--max-turn-rate", degrees.turn_rate_deg, "that it turns at most [degrees/s]")
      ->check(CLI::Range(1.0, 360.0))
      ->capture_default_str();
  app.add_option("--acceleration", spec.max_acceleration, "with which it starts and brakes [m/s^2]")
      ->check(CLI::Range(0.01, 10.0))
      ->capture_default_str();
  app.add_option("--watchdog", spec.watchdog, "after such a silence it brakes [s]")
      ->check(CLI::Range(0.1, 60.0))
      ->capture_default_str();
  app.add_option("--encoder-noise", spec.encoder_noise, "by what share its encoders are off")
      ->check(share)
      ->capture_default_str();
  app.add_option("--range", spec.sonar.range, "of its 24 sensors [m]")
      ->check(CLI::Range(0.5, 60.0))
      ->capture_default_str();
  app.add_option("--beam-width", degrees.beam_width_deg, "[degrees]")
      ->check(CLI::Range(0.1, 60.0))
      ->capture_default_str();
  app.add_option("--sonar-noise", spec.sonar.noise, "of a distance, standard deviation [m]")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  app.add_option("--dropout", spec.sonar.dropout, "chance that an echo is not heard")
      ->check(share)
      ->capture_default_str();
  app.add_option(
         "--glancing", degrees.glancing_deg,
         "walls throw sound elsewhere that meets them under more than this from straight on; 90: none "
         "does [degrees]")
      ->check(CLI::Range(0.0, 90.0))
      ->capture_default_str();
  app.add_flag("--lurch", spec.lurches, "it moves for a second, stands for half a second, and so on");
}

int run(int argc, char** argv) {
  CLI::App app(kDescription, "mlab_mrv2_model");
  app.set_version_flag("--version", std::string("mlab_mrv2_model ") + MLAB_VERSION);
  ProgramOptions options;
  Mrv2Spec spec;
  Degrees degrees;
  add_options(app, options);
  add_vehicle_options(app, spec, degrees);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? kDone : kBadInput;
  }
  overlay::Overlay world;
  if (!read_world(options, world)) return kBadInput;
  spec.max_turn_rate = base::radians(degrees.turn_rate_deg);
  spec.sonar.beam_width = base::radians(degrees.beam_width_deg);
  spec.sonar.glancing = base::radians(degrees.glancing_deg);
  spec.place = options.place();
  spec.seed = options.seed;
  Mrv2Model vehicle(world, spec);
  return serve(vehicle, options);
}

}  // namespace
}  // namespace mlab::model_vehicles

int main(int argc, char** argv) {
  try {
    return mlab::model_vehicles::run(argc, argv);
  } catch (const std::exception& e) {
    fmt::print(stderr, "mlab_mrv2_model: {}\n", e.what());
    return mlab::model_vehicles::kFailed;
  }
}
