#include "mlab/cli/fleet_options.h"

#include "mlab/cli/fleet_words.h"
#include "mlab/cli/option_groups.h"

namespace mlab::cli {

void add_fleet(CLI::App& app, FleetOptions& o) {
  CLI::App* c = app.add_subcommand(
      "fleet", "Who is in a fleet: machines, robots, versions; live on a terminal. Its emergency stop.");
  c->add_option("fleet", o.network.fleet, "the fleet")
      ->default_str("default")
      ->check(refuse_unless_name)
      ->type_name("NAME");
  add_network(c, o.network);
  c->add_flag("--once", o.once, "say it once, and end");
  auto* const json = c->add_flag("--json", o.json, "say it once, as JSON");
  auto* const stop = c->add_flag("--stop", o.stop,
                                 "EMERGENCY STOP: all robots of the fleet stand, until somebody releases it")
                         ->excludes(json);
  auto* const release =
      c->add_flag("--release", o.release, "release the emergency stop")->excludes(stop)->excludes(json);
  c->add_option("--log", o.log, "what the agent of that name told last")
      ->excludes(stop)
      ->excludes(release)
      ->excludes(json)
      ->check(refuse_unless_name)
      ->type_name("NAME");
}

void add_keys(CLI::App& app, KeysOptions& o) {
  CLI::App* c = app.add_subcommand("keys",
                                   "Make the keys of a secured fleet where there are none, and say where "
                                   "they are. Members take part with\n"
                                   "--secure (docs/robots_of_their_own.md).");
  c->add_option("fleet", o.fleet, "the fleet")
      ->default_str("default")
      ->check(refuse_unless_name)
      ->type_name("NAME");
  auto* const added =
      c->add_option("--add", o.add,
                    "make the identity of another machine, to be brought there; own: this one's")
          ->check(refuse_if_empty)
          ->type_name("NAME");
  c->add_option("--withdraw", o.withdraw, "that identity belongs to the fleet no more")
      ->excludes(added)
      ->check(refuse_if_empty)
      ->type_name("NAME");
}

}  // namespace mlab::cli
