// mlab_text_rover_model: the vehicle of docs/adding_a_vehicle.md, on a pseudo-terminal.

#include <exception>

#include <fmt/core.h>

#include "mlab/model_vehicles/program.h"
#include "mlab/model_vehicles/text_rover_model.h"

namespace mlab::model_vehicles {
namespace {

constexpr const char* kDescription =
    "A small rover that isn't there, and is spoken with in lines of text: the vehicle of\n"
    "docs/adding_a_vehicle.md. It prints `line: PATH` and runs until it is interrupted (Ctrl-C).";

int run(int argc, char** argv) {
  CLI::App app(kDescription, "mlab_text_rover_model");
  app.set_version_flag("--version", std::string("mlab_text_rover_model ") + MLAB_VERSION);
  ProgramOptions options;
  TextRoverSpec spec;
  add_options(app, options);
  app.add_option("--encoder-noise", spec.encoder_noise, "by what share its encoders are off")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? kDone : kBadInput;
  }
  overlay::Overlay world;
  if (!read_world(options, world)) return kBadInput;
  spec.place = options.place();
  spec.seed = options.seed;
  TextRoverModel vehicle(world, spec);
  return serve(vehicle, options);
}

}  // namespace
}  // namespace mlab::model_vehicles

int main(int argc, char** argv) {
  try {
    return mlab::model_vehicles::run(argc, argv);
  } catch (const std::exception& e) {
    fmt::print(stderr, "mlab_text_rover_model: {}\n", e.what());
    return mlab::model_vehicles::kFailed;
  }
}
