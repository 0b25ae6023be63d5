#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <expected>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "mlab/agents/roster.h"
#include "mlab/cli/clock.h"
#include "mlab/cli/commands.h"
#include "mlab/cli/fleet_network.h"
#include "mlab/cli/fleet_vehicles.h"
#include "mlab/cli/output.h"
#include "mlab/cli/permission.h"
#include "mlab/cli/run_settings.h"
#include "mlab/cli/terminal.h"
#include "mlab/lang/mdl/mdl.h"
#include "mlab/preflight/gate.h"
#include "mlab/run/crew.h"
#include "mlab/text/shell_word.h"
#include "mlab/vehicles/fleet_facts.h"

namespace mlab::cli {
namespace {

using preflight::Checklist;
using preflight::CheckResult;

int problem(const std::string& what, int status) {
  fmt::print(stderr, "mlab preflight: {}\n", what);
  return status;
}

// As `mlab run` makes it, so that what is signed is what runs. Diagnostics are printed here.
std::shared_ptr<const run::Crew> crew_of(const PreflightOptions& options) {
  RunOptions as_run;
  as_run.mission = options.mission;
  as_run.allow_native = options.allow_native;
  as_run.no_cell = options.no_cell;
  const std::string folder = std::filesystem::path(options.mission).parent_path().string();
  const robot::ProgramSources sources =
      mission_sources(as_run, permission_to_run(as_run, cell::Grounds::People::kHere, folder));
  text::Diagnostics sink;
  const auto mission = mdl::load_mission(options.mission, sink, load_options(as_run, sources));
  auto out = mission ? run::make_crew(mission, sources, sink) : nullptr;
  if (sink.has_errors()) out = nullptr;
  tell(sink);
  return out;
}

void say(const PreflightOptions& options, const std::string& text) {
  if (!options.json) write_output_now(text);
}

// Each failure that nobody accepts, with what does; false: there is one.
bool are_accepted(const Checklist& checklist, const PreflightOptions& options) {
  bool out = true;
  for (const preflight::Item& one : checklist.items) {
    const bool is_accepted = std::ranges::find(options.accept, one.id) != options.accept.end();
    if (one.result != CheckResult::kFail || is_accepted) continue;
    fmt::print(stderr,
               "mlab preflight: not signed: `{}` has failed: {}; to run all the same: --accept {} "
               "--because \"REASON\"\n",
               one.id, one.is, text::shell_word(one.id));
    out = false;
  }
  return out;
}

// Asks for what only a person knows; false: something is not so, or nobody answers.
bool confirm(const Checklist& checklist, const PreflightOptions& options, preflight::Signature& signature) {
  std::size_t number = 0;
  if (!options.yes) say(options, "\nAnswer each with y where it is so; anything else ends this.\n");
  for (const preflight::ManualItem& one : checklist.manual) {
    ++number;
    if (!options.yes) {
      say(options,
          fmt::format("\n  {} of {}: {}\n  Is that so? [y/n] ", number, checklist.manual.size(), one.text));
      std::string answer;
      if (!std::getline(std::cin, answer) || (answer != "y" && answer != "Y" && answer != "yes")) {
        problem(fmt::format("not signed: `{}` is not confirmed", one.id), kFailed);
        return false;
      }
    }
    signature.confirmed.push_back(one.id);
  }
  return true;
}

int sign(const preflight::Gate& gate, const run::Crew& crew, const Checklist& checklist,
         const PreflightOptions& options) {
  if (!are_accepted(checklist, options)) return kFailed;
  preflight::Signature signature;
  signature.by = options.sign;
  for (std::size_t i = 0; i < options.accept.size(); ++i)
    signature.accepted.push_back({options.accept[i], options.because[i]});
  if (!confirm(checklist, options, signature)) return kFailed;
  const auto done = gate.sign(crew, std::move(signature));
  if (!done) return problem("not signed: " + done.error(), kFailed);
  if (options.json) {
    write_output_now(preflight::json_of(*done));
    return kDone;
  }
  MissionClock until = wall_clock();
  until.epoch_seconds = done->signature.at + preflight::kHoldsFor;
  say(options, fmt::format("\nSigned by {}. It holds until {}, for these texts, as long as no process of a "
                           "vehicle\nis started anew.\n",
                           done->signature.by, print(until)));
  return kDone;
}

// How it stands with who has signed, where nobody does now.
void tell_held(const preflight::Gate& gate, const run::Crew& crew, const Checklist& checklist,
               const PreflightOptions& options) {
  if (!checklist.is_needed()) {
    say(options, "All vehicles that are there are simulated: nobody has to sign.\n");
    return;
  }
  const auto held = gate.held(crew);
  say(options, held ? fmt::format("Signed by {}.\n", held->signature.by)
                    : fmt::format("No signed checklist holds: {}.\n", held.error()));
}

}  // namespace

int preflight(const PreflightOptions& options) {
  if (options.accept.size() != options.because.size())
    return problem("expected a --because behind each --accept", kBadInput);
  if (!options.sign.empty() && !options.yes && (options.json || ::isatty(STDIN_FILENO) != 1))
    return problem("--sign asks a person at a terminal; --yes says that all is so without being asked",
                   kBadInput);
  const auto crew = crew_of(options);
  if (!crew) return kBadInput;
  const auto network = network_of(options.network);
  if (!network) return problem(network.error(), kBadInput);
  const auto roster = agents::Roster::join(*network);
  if (!roster) return problem(roster.error(), kBadInput);
  const auto gate =
      make_gate(std::make_shared<vehicles::FleetFacts>(*roster), options.network, options.mission, "");
  const Checklist checklist = gate->look(*crew);
  if (options.json && options.sign.empty()) write_output_now(preflight::json_of(checklist));
  if (checklist.vehicles.empty())
    return problem(
        fmt::format("no robot of the mission has a vehicle of the fleet `{}` as its body: NEW-ROBOT "
                    "names one as host (docs/vehicles.md)",
                    checklist.fleet),
        kFailed);
  say(options, preflight::text_of(checklist));
  if (!options.sign.empty()) return sign(*gate, *crew, checklist, options);
  tell_held(*gate, *crew, checklist, options);
  return checklist.worst() == CheckResult::kFail ? kFailed : kDone;
}

}  // namespace mlab::cli
