#include "mlab/cli/robot_options.h"

#include "mlab/cli/fleet_words.h"
#include "mlab/cli/option_groups.h"
#include "mlab/cli/vehicle_kinds.h"

namespace mlab::cli {

void add_robot(CLI::App& app, RobotOptions& o) {
  CLI::App* c = app.add_subcommand(
      "robot", "Let runs of a fleet drive a vehicle that is connected to this machine (docs/vehicles.md).");
  c->add_option("--binding", o.binding, vehicle_kinds_help())
      ->required()
      ->check(CLI::IsMember(vehicle_kinds()))
      ->type_name("KIND");
  c->add_option("--fleet", o.network.fleet, "the fleet to join")
      ->default_str("default")
      ->check(refuse_unless_name)
      ->type_name("NAME");
  c->add_option("--name", o.name,
                "of this vehicle in the fleet, which NEW-ROBOT names as host (default: the machine's)")
      ->check(refuse_unless_name)
      ->type_name("NAME");
  c->add_option("--device", o.device, "where the vehicle is connected")
      ->check(refuse_if_empty)
      ->type_name("ADDRESS");
  c->add_option("--world", o.world, "simulated: overlay of what stands around it; none: nothing does")
      ->check(refuse_if_empty)
      ->type_name("FILE");
  c->add_option("--at", o.at, "simulated: where it starts, and how it looks: X,Y,DEGREES")
      ->delimiter(',')
      ->default_str("0,0,0")
      ->type_name("PLACE");
  c->add_option("--seed", o.seed, "simulated: of its noise")->capture_default_str()->type_name("N");
  add_network(c, o.network);
}

}  // namespace mlab::cli
