#include "mlab/cli/preflight_options.h"

#include "mlab/cli/fleet_words.h"
#include "mlab/cli/option_groups.h"

namespace mlab::cli {

void add_preflight(CLI::App& app, PreflightOptions& o) {
  CLI::App* c = app.add_subcommand(
      "preflight",
      "Look at a mission's vehicles before it moves them, and have the checklist signed without which "
      "`mlab run`\n"
      "does not start on vehicles (docs/preflight.md). Exit status 0: nothing has failed, or it is signed, "
      "1: "
      "something\n"
      "has failed, or it is not signed, 2: something can't be read.");
  c->add_option("mission", o.mission, "the mission file")
      ->required()
      ->check(CLI::ExistingFile)
      ->type_name("MISSION.mdl");
  c->add_option("--fleet", o.network.fleet, "the fleet that the vehicles take part in")
      ->default_str("default")
      ->check(refuse_unless_name)
      ->type_name("NAME");
  add_network(c, o.network);
  auto* const sign =
      c->add_option("--sign", o.sign,
                    "sign it, under this name: asks for each thing that only a person can confirm; what was "
                    "signed holds for an hour")
          ->check(refuse_if_empty)
          ->type_name("NAME");
  auto* const accept =
      c->add_option("--accept", o.accept,
                    "an item that has failed, and is not to keep the mission from running; again for each")
          ->allow_extra_args(false)
          ->needs(sign)
          ->type_name("ITEM");
  auto* const because = c->add_option("--because", o.because, "why; behind each --accept")
                            ->allow_extra_args(false)
                            ->check(refuse_if_empty)
                            ->needs(accept)
                            ->type_name("REASON");
  accept->needs(because);
  c->add_flag("--yes", o.yes,
              "do not ask: all that a person has to confirm is so. What has failed is not accepted by that")
      ->needs(sign);
  c->add_flag("--json", o.json,
              "as JSON (docs/preflight.md); with --sign, which then needs --yes, what was signed");
  c->add_flag("--allow-native", o.allow_native, "as of mlab run");
  add_no_cell(c, o.no_cell);
}

}  // namespace mlab::cli
