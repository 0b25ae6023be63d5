#include "mlab/cli/replay_options.h"

#include <CLI/CLI.hpp>

#include "mlab/cli/option_groups.h"

namespace mlab::cli {
namespace {

CLI::Option* add_recording(CLI::App* c, ReplayOptions& o) {
  CLI::Option* out =
      c->add_option("recording", o.recording, "the file that `mlab run` has recorded")->type_name("RUN.mcap");
  c->add_option("--threads", o.threads,
                "how many threads step the robots; the result is the same for any number")
      ->capture_default_str()
      ->check(CLI::Range(1, 256))
      ->type_name("N");
  add_cell_limits(c, o.limits);
  return out;
}

}  // namespace

void add_record(CLI::App* c, RunOptions& o) {
  auto* const file =
      c->add_option("--record", o.record,
                    "record the run in this MCAP file, from which it is computed again (docs/recording.md); "
                    "without, the console keeps its newest runs by itself")
          ->check(refuse_if_empty)
          ->type_name("FILE.mcap");
  c->add_flag("--no-record", o.no_record, "the console records nothing")->excludes(file);
}

void add_replay_options(CLI::App* c, ReplayOptions& o) {
  add_recording(c, o)->description(
      "the file that `mlab run` has recorded; without one, those of the project in this folder are listed");
  c->add_option("--report", o.report, "write the run's report as it would have been written then")
      ->check(refuse_if_empty)
      ->type_name("FILE.json");
  c->add_option("--project", o.project, "folder of the project whose runs are listed")
      ->check(CLI::ExistingDirectory)
      ->type_name("FOLDER");
  auto* const keep =
      c->add_flag("--keep", o.keep, "only mark it: it stays, however many runs the console records after it");
  c->add_flag("--no-keep", o.no_keep, "take the mark away")->excludes(keep);
  c->add_flag("--quiet", o.quiet, "print only what became of it");
}

void add_trace_options(CLI::App* c, TraceOptions& o) {
  add_recording(c, o.replay)->required();
  c->add_option("--robot", o.robots, "only this robot; again for each (default: all)")->type_name("N");
  c->add_option("--ports", o.ports,
                "paths of ports, in which * stands for anything: 'movement.*'; again for each (default: all "
                "outputs)")
      ->type_name("PATTERN");
  c->add_option("--from", o.from, "simulated seconds from which on")
      ->check(CLI::NonNegativeNumber)
      ->type_name("SECONDS");
  c->add_option("--to", o.to, "simulated seconds up to which (default: the end)")
      ->check(CLI::NonNegativeNumber)
      ->type_name("SECONDS");
  c->add_option("--every", o.every, "a row for every so many cycles")
      ->capture_default_str()
      ->check(CLI::Range(1U, 1'000'000U))
      ->type_name("CYCLES");
  c->add_flag("--csv", o.says_csv, "as comma-separated values, which is what it does anyway");
}

}  // namespace mlab::cli
