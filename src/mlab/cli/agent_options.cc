#include "mlab/cli/agent_options.h"

#include "mlab/cli/fleet_words.h"
#include "mlab/cli/option_groups.h"

namespace mlab::cli {

void add_agent_options(CLI::App* c, AgentOptions& o) {
  c->add_option("--fleet", o.network.fleet, "the fleet to join")
      ->default_str("default")
      ->check(refuse_unless_name)
      ->type_name("NAME");
  c->add_option("--name", o.name,
                "of this agent in the fleet, which NEW-ROBOT names as host (default: the "
                "machine's)")
      ->check(refuse_unless_name)
      ->type_name("NAME");
  c->add_option("--offer", o.offer,
                "carry robots of this executable of `mlab build`, and no others; what it does when it is "
                "started with --fleet itself")
      ->check(refuse_if_empty)
      ->type_name("FILE");
  add_network(c, o.network);
  c->add_flag("--allow-native", o.allow_native,
              "with --network: compile and run, in cells, C++ that runs on other machines bring");
  add_cell(c, o);
}

}  // namespace mlab::cli
