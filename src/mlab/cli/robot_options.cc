#include "mlab/cli/robot_options.h"

#include "mlab/cli/fleet_words.h"
#include "mlab/cli/option_groups.h"
#include "mlab/cli/ros2_options.h"
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
  c->add_option("--device", o.device,
                "where the vehicle is connected: serial:/dev/ttyUSB0:57600, tcp:HOST:PORT, udp:PORT, "
                "udp:HOST:PORT")
      ->check(refuse_if_empty)
      ->type_name("ADDRESS");
  c->add_option("--world", o.world, "overlay of what stands around it; none: nothing does")
      ->check(refuse_if_empty)
      ->type_name("FILE");
  c->add_option("--at", o.at, "where it starts, and how it looks")
      ->delimiter(',')
      ->default_str("0,0,0")
      ->type_name("X,Y,DEGREES");
  c->add_option("--seed", o.seed, "of its noise")->default_str("1")->type_name("N");
  c->add_option("--key-file", o.key_file,
                "file with the key that all is signed with: 64 hexadecimal digits, or passphrase:WORDS")
      ->check(CLI::ExistingFile)
      ->type_name("FILE");
  c->add_option("--origin", o.origin,
                "where the origin of the vehicle's own frame is on the map; without it the vehicle begins "
                "where START puts it")
      ->delimiter(',')
      ->type_name("X,Y");
  c->add_option("--radius", o.radius, "of the disc that the vehicle takes up [m]")
      ->check(CLI::Range(0.01, 100.0))
      ->type_name("METRES");
  c->add_option("--max-speed", o.max_speed, "it is never told to go faster [m/s]")
      ->check(CLI::Range(0.01, 100.0))
      ->type_name("SPEED");
  c->add_option("--max-turn-rate", o.max_turn_rate, "it is never told to turn faster [deg/s]")
      ->check(CLI::Range(0.1, 3600.0))
      ->type_name("RATE");
  add_ros2(c, o.ros2);
  add_network(c, o.network);
}

}  // namespace mlab::cli
